#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod altered;
mod clay;
mod element;
mod reference;
mod rigid;
mod strength;
mod walls;

use super::*;
use crate::examples::{wall, wedge_field};
use crate::{
    Boundary, Condition, Flow, Line, LineUse, Linear, Mesh, Objective, Place, Statement, Triangle, Velocity,
    Vertex,
};

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} {b}");
}

/// A little more than friction demands.
fn up() -> f64 {
    3.0_f64.sqrt() * (1.0 + 1e-12)
}

#[test]
fn coulombs_wedge_is_proven() {
    let bound = prove_upper(&wall(), &wedge_field(up())).unwrap();
    assert!((6.0..6.0 + 1e-9).contains(&bound), "{bound}");
}

#[test]
fn cohesion_surcharge_and_a_rough_wall_add_what_they_dissipate() {
    // By hand: the wedge has the area 2 sqrt(3), its top the length 2 sqrt(3), its slip line the length 4.
    let changed = |change: &dyn Fn(&mut Statement)| {
        let mut statement = wall();
        change(&mut statement);
        prove_upper(&statement, &wedge_field(up())).unwrap() - 6.0
    };
    let root = 3.0_f64.sqrt();
    near(changed(&|s| s.surcharge = 0.5), 0.5 * 2.0 * root * root);
    // The wedge slides at cos(30) of its speed of 2.
    near(changed(&|s| s.regions[0].material.cohesion = Linear::uniform(0.3)), 0.3 * 4.0 * root);
    near(changed(&|s| s.regions[0].material.unit_weight = 2.0), 6.0);
    near(changed(&|s| s.gravity = [0.25, -1.0]), -0.25 * 2.0 * root);
    // A structure that moves away with the vertical velocity of the wedge sees no slip.
    near(
        changed(&|s| {
            s.objective = Objective::Structure { velocity: [1.0, up()] };
            s.boundaries[0].condition = Condition::Face { delta_deg: 20.0, adhesion: 0.1 };
        }),
        0.0,
    );
}

#[test]
fn a_wedge_that_opens_too_little_is_not_proven() {
    let error = prove_upper(&wall(), &wedge_field(3.0_f64.sqrt() * (1.0 - 1e-12))).unwrap_err();
    assert!(matches!(error, CertificateError::NotProven { low, .. } if low < 0.0 && low > -1e-9), "{error}");
    // A rough wall lets nothing slide past without opening.
    let mut rough = wall();
    rough.boundaries[0].condition = Condition::Face { delta_deg: 5.0, adhesion: 0.0 };
    let error = prove_upper(&rough, &wedge_field(up())).unwrap_err();
    assert!(matches!(error, CertificateError::NotProven { .. }), "{error}");
}

#[test]
fn conditions_are_checked() {
    let refused = |change: &dyn Fn(&mut Statement, &mut UpperField)| {
        let (mut statement, mut field) = (wall(), wedge_field(up()));
        change(&mut statement, &mut field);
        prove_upper(&statement, &field).unwrap_err()
    };
    for condition in [Condition::Fixed, Condition::Smooth] {
        let top = refused(&|s, _| s.boundaries[3].condition = condition);
        assert!(matches!(top, CertificateError::BadField { .. }), "{top}");
    }
    let through_wall = refused(&|_, f| f.velocities[0] = Velocity::Free { x: 0.999, y: 2.0 });
    assert!(matches!(through_wall, CertificateError::NotProven { .. }), "{through_wall}");
    let frictionless = refused(&|s, _| s.regions[0].material.phi_deg = 0.0);
    assert!(matches!(frictionless, CertificateError::BadField { .. }), "{frictionless}");
    let no_stream = refused(&|_, f| f.flows[1] = Flow::Stream { corners: [0; 3], slopes: [0.0; 3] });
    assert!(matches!(no_stream, CertificateError::NoSuch { .. }), "{no_stream}");
    let grip = refused(&|s, _| s.boundaries[0].condition = Condition::Face { delta_deg: 0.0, adhesion: 1.0 });
    assert!(matches!(grip, CertificateError::NotCovered { .. }), "{grip}");
    let node = refused(&|_, f| f.flows[1] = Flow::Quadratic([6, 6, 6, usize::MAX, 6, 6]));
    assert!(matches!(node, CertificateError::NoSuch { .. }), "{node}");
    let nan = refused(&|_, f| f.velocities[0] = Velocity::Free { x: f64::NAN, y: 2.0 });
    assert!(matches!(nan, CertificateError::OutOfRange { .. }), "{nan}");
}

#[test]
fn slides_along_smooth_lines_are_exact() {
    // A ramp whose direction has no short numbers, so that arithmetic would leave noise across it.
    let mut statement = wall();
    statement.points[2] = [4.1, -1.9];
    statement.boundaries[1].condition = Condition::Smooth;
    let mut field = wedge_field(up());
    field.velocities[6] = Velocity::Slide { line: 1, value: 1e-30 };
    let error = prove_upper(&statement, &field).unwrap_err();
    assert!(
        matches!(&error, CertificateError::BadField { place, .. } if place == "triangle 2, edge 2"),
        "{error}"
    );
    statement.boundaries[2].condition = Condition::Free;
    assert!(prove_upper(&statement, &field).unwrap() > 6.0 - 1e-9);
}

/// Soil that is stretched along x with the velocity `x^2`, in a triangle with sides of one.
#[test]
fn what_flowing_soil_dissipates_is_proven() {
    let corner = |point| Vertex { position: [0.0; 2], place: Place::Corner { point } };
    let mut statement = wall();
    statement.points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    statement.lines = vec![Line { from: 0, to: 1 }, Line { from: 1, to: 2 }, Line { from: 2, to: 0 }];
    let side = |line| LineUse { line, forward: true };
    statement.regions[0].loops = vec![vec![side(0), side(1), side(2)]];
    statement.boundaries =
        [0, 1, 2].map(|line| Boundary { line, forward: true, condition: Condition::Free }).into();
    statement.gravity = [0.5, -1.0];
    statement.surcharge = 0.7;
    statement.regions[0].material.cohesion = crate::Linear::uniform(0.3);
    let triangle = Triangle { corners: [0, 1, 2], region: 0 };
    let mut field = UpperField {
        mesh: Mesh { vertices: vec![corner(0), corner(1), corner(2)], triangles: vec![triangle] },
        flows: vec![Flow::Quadratic([0, 1, 0, 0, 0, 0])],
        velocities: vec![Velocity::Zero, Velocity::Free { x: 1.0, y: 0.0 }],
        stream: Vec::new(),
        walls: Vec::new(),
        members: Vec::new(),
    };
    // The integral of x over the triangle is 1/6, that of x^2 is 1/12.
    let expected = 0.3 * 3.0_f64.sqrt() / 3.0 - 0.5 / 12.0 + 0.7 / 3.0;
    let bound = prove_upper(&statement, &field).unwrap();
    assert!((bound - expected).abs() < 1e-14, "{bound} {expected}");
    // Means over the triangle of x, x^2 and xy times its area are 1/6, 1/12 and 1/24.
    let mut with = statement.clone();
    let linear = Linear { at_origin: 0.3, gradient: [0.1, -0.2] };
    let mean = 2.0 * (0.3 / 6.0 + 0.1 / 12.0 - 0.2 / 24.0);
    with.regions[0].material.cohesion = linear;
    let loads = 0.7 / 3.0 - 0.5 / 12.0;
    near(prove_upper(&with, &field).unwrap(), mean * 3.0_f64.sqrt() + loads);
    with.regions[0].material.pore_pressure = linear;
    near(prove_upper(&with, &field).unwrap(), mean * (3.0_f64.sqrt() - 1.0) + loads);
    // Stretching one way is all tension.
    with.regions[0].material.tension = Some(0.1);
    near(prove_upper(&with, &field).unwrap(), 0.1 / 3.0 - mean + loads);
    field.velocities[1] = Velocity::Free { x: -1.0, y: 0.0 };
    let error = prove_upper(&statement, &field).unwrap_err();
    assert!(matches!(error, CertificateError::NotProven { .. }), "{error}");
}
