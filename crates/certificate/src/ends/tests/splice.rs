//! The two limits of the splice against the search for a pressure across.

use proptest::prelude::*;

use super::super::Splice;
use crate::examples::{Plate, fill};
use crate::interval::Vector;
use crate::problem::Problem;
use crate::{
    Boundary, CertificateError, Condition, Line, LineUse, Linear, Mechanism, Statement, prove_lower,
    prove_mechanism,
};

fn plate(cohesion: f64, surcharge: f64, gravity: [f64; 2]) -> Statement {
    let mut statement = Plate { lean: 0.3, delta_deg: 20.0, surcharge, gravity }.statement().with_width(3.0);
    statement.regions[0].material.cohesion = Linear::uniform(cohesion);
    statement
}

/// How much more the soil bears than three principal pressures demand, by the greatest and the least of them.
fn spare(pressures: [f64; 3], apex: f64, phi: f64) -> f64 {
    let greatest = pressures.into_iter().fold(f64::MIN, f64::max) + apex;
    let least = pressures.into_iter().fold(f64::MAX, f64::min) + apex;
    (1.0 + phi.sin()) / (1.0 - phi.sin()) * least - greatest
}

proptest! {
    /// Random states of the slice: there is a pressure across that both parts bear exactly where the limits say so.
    #[test]
    fn a_pressure_across_exists_where_the_limits_hold(
        cohesion in prop_oneof![Just(0.0), 0.0..1.0_f64], surcharge in prop_oneof![Just(0.0), 0.0..1.0_f64],
        slope in prop_oneof![Just(0.0), -0.5..0.5_f64], depth in 0.1..5.0_f64, least in 0.01..40.0_f64, ratio in 0.0..1.0_f64,
    ) {
        let statement = plate(cohesion, surcharge, [-slope.sin(), -slope.cos()]);
        let problem = Problem::new(&statement).unwrap();
        let splice = Splice::new(&problem).unwrap().unwrap();
        let phi = 35.0_f64.to_radians();
        let k = (1.0 + phi.sin()) / (1.0 - phi.sin());
        let apex = cohesion / phi.tan();
        // The ground at rest: pressures along and across the surface, and the shear that carries a slope.
        let (across, shear) = (depth * slope.cos(), depth * slope.sin());
        let along = across * (1.0 + 2.0 * slope.tan().powi(2));
        let (mean, radius) = (0.5 * (along + across) + surcharge, (0.25 * (along - across).powi(2) + shear * shear).sqrt());
        let outer = [mean + radius, mean - radius];
        let p3 = least - apex;
        let p1 = k.powf(ratio) * least - apex;
        let bears = |f: f64| spare([p1, p3, f], apex, phi).min(spare([outer[0], outer[1], f], apex, phi));
        // The spare is concave in the pressure across.
        let best = (0..=200).map(|i| bears(1e-3 * (1.1_f64).powi(i) - apex)).fold(f64::MIN, f64::max);
        let [greatest, lowest] = splice.at(Vector::point([0.0, -depth])).radii((-0.5 * (p1 + p3)).into());
        let spliced = (greatest.middle() - 0.5 * (p1 - p3)).min(lowest.middle() - 0.5 * (p1 - p3));
        // The search is good to its steps of a tenth.
        prop_assert!(spliced > -1e-9 || best < 1e-9, "{spliced} {best}");
        prop_assert!(spliced < 0.2 * p1.abs().max(mean) + 0.1 || best > -1e-9, "{spliced} {best}");
    }

    /// What is proven with ends is proven without, the same for every width.
    #[test]
    fn ends_take_nothing_from_what_is_proven(seed in any::<u64>(), size in -4.0..0.5_f64, width in 0.01..100.0_f64) {
        let plate = Plate { lean: 0.3, delta_deg: 20.0, surcharge: 0.5, gravity: [0.0, -1.0] };
        let statement = plate.statement();
        let field = fill(&statement, &plate.mesh(0.2, seed), 10.0_f64.powf(size), seed);
        let ended = prove_lower(&statement.clone().with_width(width), &field).ok();
        if ended.is_some() {
            prop_assert_eq!(ended, prove_lower(&statement, &field).ok());
        }
    }
}

#[test]
fn what_is_no_plate_in_one_soil_is_refused() {
    let good = plate(0.0, 0.0, [0.0, -1.0]);
    let problem = Problem::new(&good).unwrap();
    assert!(Splice::new(&problem).is_ok());
    let changes: [fn(&mut Statement); 4] = [
        |s| s.regions[0].material.tension = Some(0.0),
        |s| s.regions[0].material.pore_pressure = Linear::uniform(0.1),
        |s| s.regions[0].material.cohesion = Linear { at_origin: 9.0, gradient: [0.1, 0.0] },
        |s| s.regions[0].material.phi_deg = 0.0,
    ];
    for change in changes {
        let mut bad = good.clone();
        change(&mut bad);
        let problem = Problem::new(&bad).unwrap();
        assert!(matches!(Splice::new(&problem).unwrap_err(), CertificateError::NotCovered { .. }));
    }
    // A slope steeper than the friction angle.
    let steep = plate(0.0, 0.0, [-0.6, -0.8]);
    let problem = Problem::new(&steep).unwrap();
    assert!(matches!(Splice::new(&problem).unwrap_err(), CertificateError::NotProven { .. }));
}

/// The plate bent in its middle, in two sheets.
fn bent() -> Statement {
    let mut statement = plate(0.0, 0.0, [0.0, -1.0]);
    let is_face = |b: &&Boundary| matches!(b.condition, Condition::Face { .. });
    let line = statement.boundaries.iter().find(is_face).unwrap().line;
    let Line { from, to } = statement.lines[line];
    let [a, b] = [from, to].map(|p| statement.points[p]);
    let (middle, lower) = (statement.points.len(), statement.lines.len());
    statement.points.push([0.5 * (a[0] + b[0]) + 0.2, 0.5 * (a[1] + b[1])]);
    statement.lines[line] = Line { from, to: middle };
    statement.lines.push(Line { from: middle, to });
    let split = |side: &LineUse| match (side.line == line, side.forward) {
        (false, _) => vec![*side],
        (true, true) => vec![*side, LineUse { line: lower, ..*side }],
        (true, false) => vec![LineUse { line: lower, ..*side }, *side],
    };
    for one in statement.regions.iter_mut().flat_map(|region| &mut region.loops) {
        *one = one.iter().flat_map(split).collect();
    }
    let faces: Vec<Boundary> = statement.boundaries.iter().filter(is_face).copied().collect();
    statement.boundaries.extend(faces.into_iter().map(|face| Boundary { line: lower, ..face }));
    statement
}

#[test]
fn a_bent_tool_has_the_limits_of_the_plate_but_no_proof_in_space() {
    let (bent, straight) = (bent(), plate(0.0, 0.0, [0.0, -1.0]));
    let limits = |statement: &Statement| {
        let problem = Problem::new(statement).unwrap();
        let splice = Splice::new(&problem).unwrap().unwrap();
        splice.at(Vector::point([0.3, -1.7])).radii((-2.0).into()).map(crate::interval::Interval::middle)
    };
    assert_eq!(limits(&bent), limits(&straight));
    let none = Mechanism { vertices: Vec::new(), velocities: Vec::new(), facets: Vec::new() };
    let refused = prove_mechanism(&bent, &none).unwrap_err().to_string();
    assert!(refused.contains("one thin plate that hangs from the datum"), "{refused}");
}
