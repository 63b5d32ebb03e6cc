//! Exact solutions, and altered ones that must be refused.

mod buried;
mod cut;
mod layers;
mod pillar;
mod strip;
mod wall;

use proptest::prelude::*;

use super::super::*;
use crate::examples::{Blocks, fitted, material, pushed_field, wall};
use crate::tests::altered::{alter, changes};
use crate::{Gradient, Jet, LineUse, Linear, Material, Place};

use buried::{Way, buried};
use cut::cut;
use layers::layered;
use pillar::Pillar;
use strip::strip;

const NEAR: f64 = 1e-10;
const BODY: Objective = Objective::Body { gravity: [0.0, -1.0] };

/// Proves a field and checks that more than `limit` is not proven.
fn is_the_limit(limit: f64, problem: &dyn Fn(f64) -> (Statement, LowerField)) {
    let prove = |factor: f64| {
        let (statement, field) = problem(factor);
        prove_lower(&statement, &field)
    };
    let below = limit - NEAR * limit.abs().max(1.0);
    assert_eq!(prove(below).unwrap(), below);
    let error = prove(limit + 1e-9 * limit.abs().max(1.0)).unwrap_err();
    assert!(matches!(error, CertificateError::NotProven { .. }), "{error}");
}

/// Checks that wrong numbers in places that matter are refused.
fn altered_is_refused(statement: &Statement, field: &LowerField) {
    prove_lower(statement, field).unwrap();
    let refused = |change: &dyn Fn(&mut LowerField)| {
        let mut field = field.clone();
        change(&mut field);
        prove_lower(statement, &field).unwrap_err()
    };
    let inside = field.copies.iter().position(|c| matches!(c.jet, Jet::Free { .. })).unwrap();
    let shifted = refused(&|field| {
        if let Jet::Free { f, .. } = &mut field.copies[inside].jet {
            *f += 1.0;
        }
    });
    assert!(matches!(shifted, CertificateError::NotProven { .. }), "{shifted}");
    let onto_gauge = refused(&|field| field.copies[inside].jet = Jet::Gauge { gauge: 0 });
    assert!(matches!(onto_gauge, CertificateError::BadField { .. }), "{onto_gauge}");
    let on_run = field.copies.iter().position(|c| matches!(c.jet, Jet::Gauge { .. })).unwrap();
    let off_gauge = refused(&|field| {
        field.copies[on_run].jet = Jet::Free { base: 0, f: 0.0, fx: 0.0, fy: 0.0 };
    });
    assert!(matches!(off_gauge, CertificateError::BadField { .. }), "{off_gauge}");
    let more_gauges = refused(&|field| {
        field.gauges.push(field.gauges[0]);
        field.copies[on_run].jet = Jet::Gauge { gauge: field.gauges.len() - 1 };
    });
    assert!(matches!(more_gauges, CertificateError::BadField { .. }), "{more_gauges}");
    let moved = refused(&|field| field.gauges[0].gradient = Gradient::Free { x: 1e-300, y: 0.0 });
    assert!(matches!(moved, CertificateError::BadField { .. }), "{moved}");
    let endless = refused(&|field| field.multiplier = f64::INFINITY);
    assert!(matches!(endless, CertificateError::OutOfRange { .. }), "{endless}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(1500), ..ProptestConfig::default() })]

    /// What altered fields prove is still below what collapses.
    #[test]
    fn altered_fields_prove_nothing_false(changes in changes(), which in 0..7_usize, below in 0.5..1.0_f64) {
        let pillar = Pillar { material: material(0.0, 1.0, 2.0), datum: 4.1, load: None };
        let loaded = Pillar { material: material(0.0, 1.0, 0.0), datum: 3.0, load: Some(2.0) };
        // What collapses by hand, as an upper bound: a pillar along a plane through its foot, a strip and a cut along the
        // slip lines of Prandtl and Fellenius. Walls and a base near the strip hold it a little longer.
        let (limit, highest, (statement, field)) = match which {
            0 => (1.0 / 3.0, 0.5, pillar.problem(below / 3.0)),
            1 => (1.0, 1.0, loaded.problem(below)),
            2 => (2.0, 3.5, strip(2.0 * below)),
            3 => (2.2, 2.78, layered(2.2 * below, [2.0, 1.3, 0.4])),
            // Two upright slip lines from the block to the top hold 2 c H.
            4 => (1.0, 2.0, buried(Way::Up, Objective::Loads, 1.0, below)),
            5 => (1.0, 2.0, buried(Way::Down, Objective::Loads, 1.0, below)),
            _ => (1.0, 1.92, cut(below, 1.0, 0.4, [1.0, 1.4])),
        };
        prop_assert!(prove_lower(&statement, &field).unwrap() <= limit);
        if let Some(field) = alter(&field, &changes)
            && let Ok(bound) = prove_lower(&statement, &field)
        {
            prop_assert!(bound <= highest, "{bound}");
        }
        // Whatever the statement is, it is checked without panic.
        if let Some(statement) = alter(&statement, &changes) {
            let _ = prove_lower(&statement, &field);
        }
    }
}
