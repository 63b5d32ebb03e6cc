use super::*;
use crate::{Envelope, StrengthLine};

/// A column, three high, on a fixed base, with free sides. Only a vertical stress carries its weight or its load.
pub(super) struct Pillar {
    pub(super) material: Material,
    pub(super) datum: f64,
    pub(super) load: Option<f64>,
}

impl Pillar {
    pub(super) fn problem(&self, factor: f64) -> (Statement, LowerField) {
        let Self { ref material, datum, load } = *self;
        let top = |load| Condition::Loaded { pressure: [load; 2], shear: [0.0; 2], live: true };
        let blocks = Blocks {
            xs: &[-1.0, 0.5, 1.0],
            ys: &[0.0, 1.0, 3.0],
            cell: &|_, _| Some(0),
            materials: std::slice::from_ref(material),
            condition: &|_, out| match (out, load) {
                ([0, -1], _) => Condition::Fixed,
                ([0, 1], Some(load)) => top(load),
                _ => Condition::Free,
            },
            objective: if load.is_some() { Objective::Loads } else { BODY },
            gravity: [0.0; 2],
            datum,
            surcharge: 0.0,
            slope: 0.0,
        };
        let statement = blocks.statement();
        let weight = if load.is_some() { 0.0 } else { factor * material.unit_weight };
        let load = factor * load.unwrap_or(0.0);
        // The vertical stress is -weight (3 - y) - load, the reference -weight (datum - y).
        let f = |[x, y]: [f64; 2]| {
            let (across, depth) = (weight * (datum - 3.0) - load, datum - y);
            let value = across * x * x / 2.0 + weight * depth.powi(3) / 6.0;
            [value, across * x, -weight * depth * depth / 2.0]
        };
        let field = fitted(&statement, &blocks.mesh(&statement), factor, &f);
        (statement, field)
    }
}

#[test]
fn a_pillar_bears_its_weight() {
    for (phi, cohesion, datum) in [(0.0, 1.0, 3.0), (0.0, 0.7, 4.1), (30.0, 1.0, 3.0), (25.0, 1.3, -2.0)] {
        let pillar = Pillar { material: material(phi, cohesion, 2.0), datum, load: None };
        let limit = 2.0 * cohesion * (45.0 + 0.5 * phi).to_radians().tan() / (2.0 * 3.0);
        is_the_limit(limit, &|factor| pillar.problem(factor));
        let (statement, field) = pillar.problem(0.9 * limit);
        altered_is_refused(&statement, &field);
    }
    // Cohesion that grows with depth from nothing but what the depth of 0.5 at the top has.
    let mut material = material(0.0, 0.0, 1.0);
    material.cohesion = Linear { at_origin: 3.5, gradient: [0.0, -1.0] };
    is_the_limit(7.0 / 3.0, &|factor| {
        Pillar { material: material.clone(), datum: 3.0, load: None }.problem(factor)
    });
}

#[test]
fn a_pillar_bears_a_load() {
    let pillar = Pillar { material: material(0.0, 1.5, 0.0), datum: 3.0, load: Some(2.0) };
    is_the_limit(1.5, &|factor| pillar.problem(factor));
    let (statement, field) = pillar.problem(1.2);
    altered_is_refused(&statement, &field);
    let (mut other, field) = pillar.problem(1.2);
    other.objective = BODY;
    // Then it is the load itself, not 1.2 times it, that acts.
    assert!(prove_lower(&other, &field).is_err());
}

/// With `c_k` and `phi_k` of each line it bears the least `2 c_k tan(45 deg + phi_k/2)`, whatever the outer lines are.
#[test]
fn an_envelope_limits_what_a_pillar_bears() {
    let bears = |phi: f64, c: f64| 2.0 * c * (45.0 + 0.5 * phi).to_radians().tan();
    let line = |(phi_deg, cohesion)| StrengthLine { phi_deg, cohesion };
    for (own, further) in [((40.0, 1.0), (30.0, 1.1)), ((30.0, 1.0), (20.0, 2.0)), ((40.0, 1.0), (0.0, 1.2))]
    {
        let outside = if further.0 == 30.0 { vec![line((50.0, 2.0)), line((35.0, 3.0))] } else { Vec::new() };
        let envelope = Some(Envelope { inside: vec![line(further)], outside });
        let material = Material { envelope, ..material(own.0, own.1, 0.0) };
        let limit = bears(own.0, own.1).min(bears(further.0, further.1));
        let pillar = Pillar { material, datum: 3.0, load: Some(1.0) };
        is_the_limit(limit, &|factor| pillar.problem(factor));
        let (statement, field) = pillar.problem(0.9 * limit);
        altered_is_refused(&statement, &field);
    }
}

/// Lines out of order, and outer ones below the inner ones, mean nothing.
#[test]
fn envelopes_that_are_none_are_refused() {
    let line = |(phi_deg, cohesion)| StrengthLine { phi_deg, cohesion };
    let is_refused = |own: (f64, f64), inside: &[(f64, f64)], outside: &[(f64, f64)]| {
        let [inside, outside] = [inside, outside].map(|lines| lines.iter().copied().map(line).collect());
        let plain = Pillar { material: material(own.0, own.1, 0.0), datum: 3.0, load: Some(1.0) };
        let (mut statement, field) = plain.problem(0.0);
        statement.regions[0].material.envelope = Some(Envelope { inside, outside });
        prove_lower(&statement, &field).is_err()
    };
    let own = (40.0, 1.0);
    assert!(!is_refused(own, &[(30.0, 1.5)], &[]));
    assert!(!is_refused(own, &[(30.0, 1.5)], &[(45.0, 1.3), (30.0, 1.6)]));
    assert!(is_refused(own, &[(45.0, 1.5)], &[]), "steeper");
    assert!(is_refused(own, &[(35.0, 0.4)], &[]), "the first is needless");
    assert!(is_refused(own, &[(30.0, 1.5), (35.0, 1.6)], &[]), "out of order");
    assert!(is_refused(own, &[(30.0, f64::NAN)], &[]));
    assert!(is_refused((0.0, 1.0), &[], &[]), "no friction");
    assert!(is_refused(own, &[(30.0, 1.5)], &[(45.0, 0.5), (35.0, 1.6)]), "below at the tip");
    assert!(is_refused(own, &[(30.0, 1.5)], &[(45.0, 1.3), (30.0, 1.4)]), "below at high pressure");
    assert!(is_refused(own, &[(30.0, 1.5)], &[(45.0, 1.3), (29.0, 9.0)]), "below at great depth");
    assert!(is_refused(own, &[(30.0, 1.5)], &[(35.0, 1.2)]), "below where the inner lines meet");
}

#[test]
fn tension_may_be_limited() {
    let pulled = |tension| {
        let material = Material { tension, ..material(20.0, 1.0, 0.0) };
        Pillar { material, datum: 3.0, load: Some(-1.0) }
    };
    let limit = 2.0 * 35.0_f64.to_radians().tan();
    is_the_limit(limit, &|factor| pulled(None).problem(factor));
    is_the_limit(0.4, &|factor| pulled(Some(0.4)).problem(factor));
    is_the_limit(limit, &|factor| pulled(Some(2.0)).problem(factor));
    let (statement, field) = pulled(Some(0.0)).problem(0.0);
    assert_eq!(prove_lower(&statement, &field).unwrap(), 0.0);
    let (statement, field) = pulled(Some(0.0)).problem(1e-9);
    assert!(prove_lower(&statement, &field).is_err());
    // Pressure in the pores pulls as well.
    let wet = |factor| {
        let mut pillar = pulled(Some(0.4));
        pillar.material.pore_pressure = Linear::uniform(0.3);
        pillar.problem(factor)
    };
    is_the_limit(0.1, &wet);
}

#[test]
fn a_pillar_bears_all_that_acts() {
    // The field for what acts, with a claim of how often that could act.
    let often = |pillar: Pillar, claim| {
        let (mut statement, mut field) = pillar.problem(1.0);
        if statement.objective == BODY {
            statement.gravity = [0.0, -1.0];
        }
        statement.objective = Objective::Everything;
        field.multiplier = claim;
        (statement, field)
    };
    let limit = 2.0 * 1.3 * (45.0_f64 + 12.5).to_radians().tan() / (2.0 * 3.0);
    let heavy = |claim| often(Pillar { material: material(25.0, 1.3, 2.0), datum: 3.0, load: None }, claim);
    is_the_limit(limit, &heavy);
    for none in [0.0, -1.0] {
        let (statement, field) = heavy(none);
        assert!(matches!(prove_lower(&statement, &field), Err(CertificateError::BadField { .. })), "{none}");
    }
    // Water pulls as the load does: there is 0.4 for 1.3 times the factor.
    let pulled = |claim| {
        let mut material = Material { tension: Some(0.4), ..material(20.0, 1.0, 0.0) };
        material.pore_pressure = Linear::uniform(0.3);
        often(Pillar { material, datum: 3.0, load: Some(-1.0) }, claim)
    };
    is_the_limit(0.4 / 1.3, &pulled);
}
