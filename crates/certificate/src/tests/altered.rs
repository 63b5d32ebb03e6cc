//! Whatever is changed in a file, what is still proven is true.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Number, Value};

use crate::examples::{Plate, fill, rankine_field, wall, wedge_field};
use crate::{LowerField, Statement, UpperField, prove_lower, prove_upper};

/// All numbers of a document.
fn numbers<'a>(value: &'a mut Value, found: &mut Vec<&'a mut Number>) {
    match value {
        Value::Number(number) => found.push(number),
        Value::Array(list) => list.iter_mut().for_each(|v| numbers(v, found)),
        Value::Object(map) => map.values_mut().for_each(|v| numbers(v, found)),
        _ => {}
    }
}

/// A number to put in the place of `old`.
fn altered(old: &Number, how: u8, by: f64, index: u64) -> Number {
    let x = old.as_f64().unwrap();
    if !old.is_f64() {
        let near = old.as_u64().unwrap().wrapping_add_signed((by * 3.0) as i64);
        return Number::from(match how % 4 {
            0 => u64::MAX - index,
            1 => index,
            _ => near,
        });
    }
    let new = match how {
        0 => x * (1.0 + 1e-9 * by),
        1 => x * (1.0 + 0.01 * by),
        2 => x + 1e-3 * by,
        3 => x.next_up(),
        4 => -x,
        5 => 0.0,
        6 => by,
        7 => 1e308 * by,
        8 => 1e-308 * by,
        _ => index as f64,
    };
    Number::from_f64(new).unwrap_or_else(|| Number::from_f64(f64::MAX).unwrap())
}

pub(crate) type Change = (prop::sample::Index, u8, f64, u64);

pub(crate) fn changes() -> impl Strategy<Value = Vec<Change>> {
    prop::collection::vec((any::<prop::sample::Index>(), 0..10_u8, -1.0..1.0_f64, 0..40_u64), 1..4)
}

/// The same thing with some numbers changed, unless it cannot be read any more.
pub(crate) fn alter<T: Serialize + DeserializeOwned>(thing: &T, changes: &[Change]) -> Option<T> {
    let mut value = serde_json::to_value(thing).unwrap();
    for (which, how, by, index) in changes {
        let mut found = Vec::new();
        numbers(&mut value, &mut found);
        let number = which.get(&(0..found.len()).collect::<Vec<_>>()).to_owned();
        *found[number] = altered(found[number], *how, *by, *index);
    }
    serde_json::from_value(value).ok()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(3000), ..ProptestConfig::default() })]

    #[test]
    fn an_altered_stress_field_proves_nothing_false(changes in changes(), kp in 2.0..3.0_f64) {
        let field: Option<LowerField> = alter(&rankine_field(4, kp), &changes);
        if let Some(bound) = field.and_then(|f| prove_lower(&wall(), &f).ok()) {
            prop_assert!(bound <= 6.0, "{bound}");
        }
    }

    #[test]
    fn an_altered_flow_proves_nothing_false(changes in changes(), up in 1.733..2.0_f64) {
        let field: Option<UpperField> = alter(&wedge_field(up), &changes);
        if let Some(bound) = field.and_then(|f| prove_upper(&wall(), &f).ok()) {
            prop_assert!(bound >= 6.0, "{bound}");
        }
    }

    #[test]
    fn an_altered_statement_is_checked_without_panic(changes in changes(), of_plate in any::<bool>()) {
        if of_plate {
            let plate = Plate { lean: 0.3, delta_deg: 0.0, surcharge: 0.0, gravity: [0.0, -1.0] };
            let field = fill(&plate.statement(), &plate.mesh(0.1, 1), 0.01, 1);
            if let (Some(s), Some(f)) = (alter(&plate.statement(), &changes), alter(&field, &changes[..1])) {
                let _ = prove_lower(&s, &f);
            }
        } else if let Some(statement) = alter::<Statement>(&wall(), &changes) {
            let lower = prove_lower(&statement, &rankine_field(4, 2.5));
            let upper = prove_upper(&statement, &wedge_field(1.9));
            if let (Ok(lower), Ok(upper)) = (lower, upper) {
                prop_assert!(lower <= upper);
            }
        }
    }
}

/// So that the properties above are about something: altered fields often still prove a bound.
#[test]
fn small_changes_are_often_harmless() {
    let text = serde_json::to_value(rankine_field(4, 2.5)).unwrap();
    let holds = |i: usize| {
        let mut value = text.clone();
        let mut found = Vec::new();
        numbers(&mut value, &mut found);
        let number = 7 * i % found.len();
        // Whole numbers stay as they are.
        *found[number] = altered(found[number], 2, 0.3, 0);
        serde_json::from_value::<LowerField>(value).is_ok_and(|f| prove_lower(&wall(), &f).is_ok())
    };
    let count = (0..200).filter(|i| holds(*i)).count();
    assert!(count > 100, "{count}");
}
