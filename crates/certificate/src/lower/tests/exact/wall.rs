use super::*;

#[test]
fn pore_water_carries_its_share() {
    // Water up to the surface of soil that weighs 1 in all and 0.6 in water: it pushes with 0.4 times the depth.
    let mut wet = wall();
    wet.regions[0].material.pore_pressure = Linear { at_origin: 0.0, gradient: [0.0, -0.4] };
    let mut light = wall();
    light.regions[0].material.unit_weight = 0.6;
    let less = 2.0 * (1.0 - 1e-11);
    let buoyant = prove_lower(&light, &pushed_field(8, 0.6 * less, 0.0)).unwrap();
    let whole = prove_lower(&wet, &pushed_field(8, 0.6 * less, 0.0)).unwrap();
    assert!((buoyant - 3.6).abs() < 1e-9 && (whole - buoyant - 0.8).abs() < 1e-9, "{buoyant} {whole}");
    assert!(prove_lower(&wet, &pushed_field(8, 0.6 * 2.0 * (1.0 + 1e-11), 0.0)).is_err());
    // A smooth face presses on the grains: not less than the water.
    let mut held = wet.clone();
    held.regions[0].material.cohesion = Linear::uniform(1.0);
    let error = prove_lower(&held, &pushed_field(8, -0.6, -0.01)).unwrap_err();
    assert!(error.to_string().contains("grip of the face"), "{error}");
}

/// A wall that slides down along soil without friction or weight: a shear stress all over it.
fn sliding(stress: f64, face: Condition, phi: f64) -> (Statement, LowerField) {
    let blocks = Blocks {
        xs: &[0.0, 2.0],
        ys: &[-2.0, 0.0],
        cell: &|_, _| Some(0),
        materials: &[material(phi, 1.0, 0.0)],
        condition: &|_, out| if out == [-1, 0] { face } else { Condition::Fixed },
        objective: Objective::Structure { velocity: [0.0, -1.0] },
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        slope: 0.0,
    };
    let statement = blocks.statement();
    let f = |[x, y]: [f64; 2]| [-stress * x * y, -stress * y, -stress * x];
    let field = fitted(&statement, &blocks.mesh(&statement), 0.0, &f);
    (statement, field)
}

#[test]
fn adhesion_holds_soil_without_friction() {
    let face = |delta_deg, adhesion| Condition::Face { delta_deg, adhesion };
    let bound = |stress: f64, face: Condition, phi: f64| {
        let (statement, field) = sliding(stress, face, phi);
        prove_lower(&statement, &field)
    };
    for (adhesion, limit) in [(0.4, 0.4), (1.5, 1.0)] {
        let proven = bound(limit - 1e-10, face(0.0, adhesion), 0.0).unwrap();
        assert!((proven - 2.0 * limit).abs() < 1e-9, "{proven}");
        let error = bound(limit + 1e-9, face(0.0, adhesion), 0.0).unwrap_err();
        assert!(matches!(error, CertificateError::NotProven { .. }), "{error}");
    }
    for (face, phi) in [(face(0.0, 0.4), 10.0), (face(10.0, 0.4), 0.0)] {
        let error = bound(0.1, face, phi).unwrap_err();
        assert!(matches!(error, CertificateError::NotCovered { .. }), "{error}");
    }
    assert!(bound(0.3, face(10.0, 0.4), 20.0).is_ok());
}

/// A layer between an adhesive plate below and a load on it that presses by `pressure` and drags by 1.
fn dragged(face: Condition, phi: f64, pressure: f64, claim: f64) -> (Statement, LowerField) {
    let load = Condition::Loaded { pressure: [pressure; 2], shear: [1.0; 2], live: true };
    let blocks = Blocks {
        xs: &[0.0, 2.0],
        ys: &[-2.0, 0.0],
        cell: &|_, _| Some(0),
        materials: &[material(phi, 1.0, 0.0)],
        condition: &|_, out| match out {
            [0, 1] => load,
            [0, -1] => face,
            _ => Condition::Fixed,
        },
        objective: Objective::Everything,
        gravity: [0.0; 2],
        datum: 0.0,
        surcharge: 0.0,
        slope: 0.0,
    };
    let statement = blocks.statement();
    let f = |[x, y]: [f64; 2]| {
        let [along, across] = [y - pressure * x, x - pressure * y];
        [x * y - 0.5 * pressure * (x * x + y * y), along, across]
    };
    let mut field = fitted(&statement, &blocks.mesh(&statement), 0.0, &f);
    field.multiplier = claim;
    (statement, field)
}

#[test]
fn adhesion_holds_its_part_of_all_that_acts() {
    let face = |delta_deg, adhesion| Condition::Face { delta_deg, adhesion };
    // Soil of cohesion 1 gives way above it.
    for (adhesion, limit) in [(0.4, 0.4), (1.5, 1.0)] {
        is_the_limit(limit, &|claim| dragged(face(0.0, adhesion), 0.0, 0.0, claim));
    }
    // The friction grows with all that acts, the adhesion does not.
    let limit = 0.4 / (1.0 - 0.5 * 10.0_f64.to_radians().tan());
    is_the_limit(limit, &|claim| dragged(face(10.0, 0.4), 20.0, 0.5, claim));
}
