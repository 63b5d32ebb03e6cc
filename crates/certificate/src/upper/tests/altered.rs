//! Whatever is changed in a flow of soil without friction, what is still proven is true.

use proptest::prelude::*;

use super::clay::{plated, torn};
use super::rigid::sand_on_clay;
use crate::examples::{Random, pressed, pressed_field};
use crate::tests::altered::{alter, changes};
use crate::{Flow, Statement, StreamJet, UpperField, prove_upper};

/// Problems, flows, and what is known to be held: twice the cohesion by the block, of which a rough plate only makes more;
/// the tension by torn clay, where a uniform tension does no harm.
fn known(which: usize) -> (Statement, UpperField, f64) {
    match which {
        0 => {
            let (block, statement) = pressed();
            let field = pressed_field(block, &statement, [2, 2]);
            (statement, field, 2.0)
        }
        1 => {
            let (statement, field) = plated([2, 2]);
            (statement, field, 4.0)
        }
        2 => {
            let (statement, field) = torn();
            (statement, field, 0.4)
        }
        _ => {
            let (statement, field) = sand_on_clay(0.5, 0.3);
            (statement, field, 0.0)
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(4000), ..ProptestConfig::default() })]

    #[test]
    fn an_altered_stream_function_proves_nothing_false(changes in changes(), which in 0..4_usize) {
        let (statement, field, held) = known(which);
        let field: Option<UpperField> = alter(&field, &changes);
        if let Some(bound) = field.and_then(|f| prove_upper(&statement, &f).ok()) {
            prop_assert!(bound >= held, "{bound} {held}");
        }
    }

    #[test]
    fn any_stream_function_is_above_what_is_held(which in 0..2_usize, size in 0.0..1.0_f64, seed in any::<u64>()) {
        let (statement, mut field, held) = known(which);
        let mut random = Random::new(seed);
        let mut add = |x: &mut f64| *x += size * random.next();
        for copy in &mut field.stream {
            match &mut copy.jet {
                StreamJet::Free { s, sx, sy } => [s, sx, sy].into_iter().for_each(&mut add),
                StreamJet::Wall { across, .. } => add(across),
                StreamJet::Kinked { jump, .. } => add(jump),
                StreamJet::Slip { jump, .. } => add(jump),
                StreamJet::Corner { .. } | StreamJet::SlipAtWall { .. } => {}
            }
        }
        for flow in &mut field.flows {
            if let Flow::Stream { slopes, .. } = flow {
                slopes.iter_mut().for_each(&mut add);
            }
        }
        // The flow may go against the load.
        if let Ok(bound) = prove_upper(&statement, &field) {
            prop_assert!(bound >= held, "{bound} {held}");
        } else {
            prop_assert!(which == 0);
        }
    }

    #[test]
    fn altered_statements_are_checked_without_panic(changes in changes(), more in changes(), which in 0..4_usize) {
        let (statement, field, _) = known(which);
        if let (Some(s), Some(f)) = (alter(&statement, &changes), alter(&field, &more[..1])) {
            let _ = prove_upper(&s, &f);
            let _ = prove_upper(&s, &field);
        }
    }
}

/// So that the properties above are about something.
#[test]
fn small_changes_of_stream_functions_are_often_harmless() {
    for which in 0..4 {
        let (statement, field, held) = known(which);
        let bound = prove_upper(&statement, &field).unwrap();
        assert!(bound >= held && bound <= 1.5 * held + 4.0);
        let mut count = 0;
        for i in 0..100 {
            let index = any::<prop::sample::Index>();
            let mut runner = proptest::test_runner::TestRunner::deterministic();
            let tree = (0..=i).map(|_| index.new_tree(&mut runner).unwrap()).last().unwrap();
            let change = (proptest::strategy::ValueTree::current(&tree), 2, 0.3, 0);
            count += usize::from(
                alter::<UpperField>(&field, &[change]).is_some_and(|f| prove_upper(&statement, &f).is_ok()),
            );
        }
        assert!(count > 10, "{which}: {count}");
    }
}
