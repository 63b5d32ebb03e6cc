#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod balance;
mod exact;

use proptest::prelude::*;

use super::*;
use crate::examples::{Plate, fill, pushed_field, rankine_field, wall};
use crate::interval::{Interval, Vector};
use crate::{Gradient, Jet, LineUse, Linear, Place, VertexCopy};

fn plates() -> impl Strategy<Value = Plate> {
    let tilted = prop_oneof![Just([0.0, -1.0]), Just([0.1, -0.9])];
    (0..3_i32, any::<bool>(), any::<bool>(), tilted).prop_map(|(lean, rough, loaded, gravity)| Plate {
        lean: f64::from(lean) * 0.3,
        delta_deg: if rough { 20.0 } else { 0.0 },
        surcharge: if loaded { 0.7 } else { 0.0 },
        gravity,
    })
}

proptest! {
    #[test]
    fn any_stress_function_balances(plate in plates(), seed in 0_u64..1000) {
        let (statement, mesh) = (plate.statement(), plate.mesh(0.1, seed));
        balance::check(&statement, &fill(&statement, &mesh, 3.0, seed));
    }
}

#[test]
fn soil_at_rest_holds_nothing() {
    for lean in [0.0, 0.3, 0.6] {
        for delta_deg in [0.0, 20.0] {
            for surcharge in [0.0, 0.7] {
                let plate = Plate { lean, delta_deg, surcharge, gravity: [0.0, -1.0] };
                let statement = plate.statement();
                let field = fill(&statement, &plate.mesh(0.1, 1), 0.0, 1);
                let bound = prove_lower(&statement, &field).unwrap();
                assert!(bound.abs() < 1e-12, "{bound}");
            }
        }
    }
}

#[test]
fn rankine_is_proven() {
    for n in [2, 4, 10, 40] {
        let bound = prove_lower(&wall(), &rankine_field(n, 3.0 * (1.0 - 1e-11))).unwrap();
        assert!(bound <= 6.0 && bound > 6.0 - 1e-9, "{n}: {bound}");
    }
}

#[test]
fn surcharge_and_cohesion_add_to_rankine() {
    // Pressure Kp (depth + q) + 2 c sqrt(Kp), with Kp = 3.
    let (q, c) = (0.5, 0.3);
    let more = 2.0 * q + 2.0 * c * 3.0_f64.sqrt();
    let expected = 6.0 + 3.0 * q * 2.0 + 2.0 * c * 3.0_f64.sqrt() * 2.0;
    let mut statement = wall();
    statement.surcharge = q;
    statement.regions[0].material.cohesion = Linear::uniform(c);
    let less = 1.0 - 1e-11;
    let bound = prove_lower(&statement, &pushed_field(8, 2.0 * less, more * less)).unwrap();
    assert!(bound <= expected && bound > expected - 1e-9, "{bound} {expected}");
    assert!(prove_lower(&statement, &pushed_field(8, 2.0, more * (1.0 + 1e-11))).is_err());
    // A rough face bears a normal pressure, and a frictionless one no tension.
    statement.boundaries[0].condition = Condition::Face { delta_deg: 10.0, adhesion: 0.0 };
    assert!(
        prove_lower(&statement, &pushed_field(8, 0.0, 0.0)).is_err(),
        "the copies on the wall are for a smooth one"
    );
    let mut pulled = wall();
    pulled.regions[0].material.cohesion = Linear::uniform(1.0);
    let error = prove_lower(&pulled, &pushed_field(8, -1.0, -0.1)).unwrap_err();
    assert!(error.to_string().contains("grip of the face"), "{error}");
}

#[test]
fn too_much_stress_is_not_proven() {
    let error = prove_lower(&wall(), &rankine_field(4, 3.0 * (1.0 + 1e-11))).unwrap_err();
    assert!(matches!(error, CertificateError::NotProven { low, .. } if low < 0.0 && low > -1e-9), "{error}");
}

fn refused(change: impl Fn(&mut Statement, &mut LowerField)) -> CertificateError {
    let (mut statement, mut field) = (wall(), rankine_field(4, 2.0));
    change(&mut statement, &mut field);
    prove_lower(&statement, &field).unwrap_err()
}

#[test]
fn rules_of_construction_are_checked() {
    // Triangle 0 has the top left corner of the wall, vertices 0, 5, 6.
    let other_copy = refused(|_, f| {
        f.copies.push(VertexCopy { jet: Jet::Zero { base: 0 }, ..f.copies[6] });
        f.corners[0][2] = 15;
    });
    assert!(matches!(other_copy, CertificateError::BadField { .. }), "{other_copy}");
    let free_beside_apex = refused(|_, f| f.copies[6].jet = Jet::Free { base: 0, f: 0.0, fx: 0.0, fy: 0.0 });
    assert!(matches!(free_beside_apex, CertificateError::BadField { .. }), "{free_beside_apex}");
    let free_on_smooth = refused(|_, f| f.copies[10].jet = Jet::Free { base: 0, f: 0.0, fx: 0.0, fy: 0.0 });
    assert!(matches!(free_on_smooth, CertificateError::BadField { .. }), "{free_on_smooth}");
    let gauge = refused(|_, f| f.gauges[0].gradient = Gradient::Free { x: 1e-300, y: 0.0 });
    assert!(matches!(gauge, CertificateError::BadField { .. }), "{gauge}");
    let gauge_below = refused(|_, f| f.copies[10].jet = Jet::Gauge { gauge: 0 });
    assert!(matches!(gauge_below, CertificateError::BadField { .. }), "{gauge_below}");
    let moved = refused(|_, f| f.mesh.vertices[6].place = Place::Corner { point: 2 });
    assert!(matches!(moved, CertificateError::BadMesh { .. }), "{moved}");
    let length = refused(|_, f| f.lines.clear());
    assert!(matches!(length, CertificateError::Length { .. }), "{length}");
    let tilted = refused(|s, _| s.points[0][1] = 0.1);
    assert!(matches!(tilted, CertificateError::BadField { .. }), "{tilted}");
    let face = refused(|s, _| s.boundaries[0].condition = Condition::Free);
    assert!(matches!(face, CertificateError::BadField { .. }), "{face}");
    let heavy = refused(|s, _| s.regions[0].loops[0].push(LineUse { line: 0, forward: false }));
    assert!(matches!(heavy, CertificateError::BadStatement { .. }), "{heavy}");
}

#[test]
fn gauges_belong_to_their_runs() {
    let plate = Plate { lean: 0.3, delta_deg: 20.0, surcharge: 0.7, gravity: [0.0, -1.0] };
    let statement = plate.statement();
    let mut field = fill(&statement, &plate.mesh(0.1, 1), 0.0, 1);
    assert!(prove_lower(&statement, &field).is_ok());
    for copy in &mut field.copies {
        if let Jet::Gauge { gauge } = &mut copy.jet {
            *gauge = 1 - *gauge;
        }
    }
    let error = prove_lower(&statement, &field).unwrap_err();
    assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
    field.gauges.pop();
    let error = prove_lower(&statement, &field).unwrap_err();
    assert!(matches!(error, CertificateError::Length { .. }), "{error}");
}

/// Pressed hard from all sides, soil bears what cannot be spliced with the ground at rest beyond the ends.
#[test]
fn ends_limit_what_the_soil_bears() {
    let plate = Plate { lean: 0.0, delta_deg: 20.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let statement = plate.statement().with_width(2.0);
    let problem = Problem::new(&statement).unwrap();
    let splice = Splice::new(&problem).unwrap().unwrap();
    let at = Vector::point([1.0, -2.0]);
    let bears = |splice: Option<&Splice>, pressure: f64| {
        let limit = strength::Limit::at(
            &problem.strengths[0],
            Divisor::new(&statement, &fill(&statement, &plate.mesh(0.1, 1), 0.0, 1)).unwrap(),
            splice,
            at,
        );
        let p = Interval::point(-pressure);
        limit.check_parts(p, Interval::ZERO, Interval::ZERO, "strength", || "here".into()).is_ok()
    };
    // K^2 at 35 deg, times the depth of two.
    let most = 2.0 * (62.5_f64).to_radians().tan().powi(4);
    let least = 4.0 / most;
    for (pressure, with_ends) in
        [(most * 0.999, true), (most * 1.001, false), (least * 1.001, true), (least * 0.999, false)]
    {
        assert!(bears(None, pressure));
        assert_eq!(bears(Some(&splice), pressure), with_ends, "{pressure}");
    }
}
