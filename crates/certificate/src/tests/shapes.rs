//! Outlines and meshes that are no problem, or not covered once.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use crate::examples::{Plate, fill, wall, wedge_field};
use crate::problem::Problem;
use crate::{
    Boundary, CertificateError, Condition, Flow, Line, LineUse, Mesh, Place, Region, Statement, Triangle,
    UpperField, Velocity, Vertex, prove_lower, prove_upper,
};

const UP: f64 = 1.8;

fn error(change: impl Fn(&mut Statement, &mut UpperField)) -> CertificateError {
    let (mut statement, mut field) = (wall(), wedge_field(UP));
    change(&mut statement, &mut field);
    prove_upper(&statement, &field).unwrap_err()
}

fn bad_statement(change: impl Fn(&mut Statement)) {
    let error = error(|s, _| change(s));
    assert!(matches!(error, CertificateError::BadStatement { .. }), "{error}");
}

fn bad_mesh(change: impl Fn(&mut Mesh)) {
    let error = error(|_, f| change(&mut f.mesh));
    assert!(matches!(error, CertificateError::BadMesh { .. }), "{error}");
}

#[test]
fn outlines_must_make_sense() {
    bad_statement(|s| s.regions[0].loops[0].swap(0, 1));
    bad_statement(|s| s.regions[0].loops[0].truncate(3));
    bad_statement(|s| s.regions[0].loops.push(Vec::new()));
    bad_statement(|s| s.boundaries.truncate(3));
    bad_statement(|s| s.boundaries.push(s.boundaries[0]));
    bad_statement(|s| s.boundaries[0].forward = false);
    // Crossing lines: a bow tie. Then a line without length, and one that touches another.
    bad_statement(|s| s.points.swap(2, 3));
    bad_statement(|s| s.points[3] = s.points[2]);
    bad_statement(|s| {
        s.points.extend([[1.0, 0.0], [1.0, 3.0]]);
        s.lines.push(Line { from: 4, to: 5 });
    });
    // Clockwise.
    bad_statement(|s| {
        let uses = &mut s.regions[0].loops[0];
        uses.reverse();
        uses.iter_mut().for_each(|u| u.forward = false);
        s.boundaries.iter_mut().for_each(|b| b.forward = false);
    });
    // The same soil twice.
    bad_statement(|s| {
        s.points.extend([[1.0, -0.5], [1.0, -1.0], [2.0, -1.0]]);
        s.lines.extend([(4, 5), (5, 6), (6, 4)].map(|(from, to)| Line { from, to }));
        let sides: Vec<LineUse> = (4..7).map(|line| LineUse { line, forward: true }).collect();
        let fixed = |u: &LineUse| Boundary { line: u.line, forward: true, condition: Condition::Fixed };
        s.boundaries.extend(sides.iter().map(fixed));
        s.regions.push(Region { loops: vec![sides], material: s.regions[0].material.clone() });
    });
}

#[test]
fn meshes_must_cover_the_soil_once() {
    bad_mesh(|m| m.triangles.truncate(2));
    bad_mesh(|m| m.triangles.clear());
    bad_mesh(|m| m.triangles.push(m.triangles[0]));
    bad_mesh(|m| m.triangles[0].corners.swap(0, 1));
    bad_mesh(|m| m.triangles[0].corners[0] = 4);
    bad_mesh(|m| m.vertices[4].place = Place::Inside);
    bad_mesh(|m| m.vertices[4].place = Place::OnLine { line: 1, s: 0.5 });
    // An overlap: a whole second cover of the soil, with vertices of its own.
    bad_mesh(|m| {
        let count = m.vertices.len();
        m.vertices.extend(m.vertices.clone());
        let shifted = |t: &Triangle| Triangle { corners: t.corners.map(|c| c + count), ..*t };
        m.triangles.extend(m.triangles.iter().map(shifted).collect::<Vec<_>>());
    });
    // A vertex beside the edge that it should be on makes a gap.
    bad_mesh(|m| {
        m.vertices.push(Vertex { position: [2.0, -1.0], place: Place::Inside });
        m.triangles[0].corners[2] = 5;
    });
}

/// Layered soil: the wall problem cut in two along a level line, so that materials may differ.
fn layered(interface: bool) -> (Statement, UpperField) {
    let mut s = wall();
    s.points.extend([[0.0, -1.0], [4.0, -1.0]]);
    let ends = [(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (4, 5)];
    s.lines = ends.map(|(from, to)| Line { from, to }).to_vec();
    let face = Condition::Face { delta_deg: 0.0, adhesion: 0.0 };
    let conditions =
        [face, face, Condition::Fixed, Condition::Fixed, Condition::Fixed, Condition::Free].into_iter();
    s.boundaries =
        conditions.enumerate().map(|(line, condition)| Boundary { line, forward: true, condition }).collect();
    let side = |line, forward| LineUse { line, forward };
    let material = s.regions[0].material.clone();
    let above = vec![side(0, true), side(6, true), side(4, true), side(5, true)];
    let below = vec![side(1, true), side(2, true), side(3, true), side(6, false)];
    s.regions = [above, below].map(|l| Region { loops: vec![l], material: material.clone() }).to_vec();
    let corner = |point| Vertex { position: [0.0; 2], place: Place::Corner { point } };
    let mut vertices: Vec<Vertex> = (0..6).map(corner).collect();
    let triangle = |corners, region| Triangle { corners, region };
    let mut lower = [4, 5];
    if !interface {
        // The lower layer with vertices of its own along the interface.
        vertices.extend([corner(4), corner(5)]);
        lower = [6, 7];
    }
    let [a, b] = lower;
    let triangles =
        vec![triangle([0, 4, 5], 0), triangle([0, 5, 3], 0), triangle([a, 1, 2], 1), triangle([a, 2, b], 1)];
    // All soil rises with the wall, which is possible only without fixed lines.
    for boundary in &mut s.boundaries {
        if boundary.condition == Condition::Fixed {
            boundary.condition = Condition::Free;
        }
    }
    let field = UpperField {
        mesh: Mesh { vertices, triangles },
        flows: vec![Flow::Quadratic([0; 6]); 4],
        velocities: vec![Velocity::Free { x: 1.0, y: 1.0 }],
        stream: Vec::new(),
        walls: Vec::new(),
        members: Vec::new(),
    };
    (s, field)
}

#[test]
fn interfaces_hold_together() {
    let (statement, field) = layered(true);
    assert!((prove_upper(&statement, &field).unwrap() - 8.0).abs() < 1e-12);
    let (statement, field) = layered(false);
    let error = prove_upper(&statement, &field).unwrap_err();
    assert!(matches!(error, CertificateError::BadMesh { .. }), "{error}");
}

#[test]
fn a_jump_between_soils_may_use_either() {
    let (mut statement, mut field) = layered(true);
    field.flows[0] = Flow::Quadratic([1; 6]);
    field.flows[1] = Flow::Quadratic([1; 6]);
    // The upper layer rises by one and slides by one: enough for 45 degrees, not for 50.
    field.velocities.push(Velocity::Free { x: 2.0, y: 2.0 });
    let bound = |phi: [f64; 2], statement: &mut Statement| {
        statement.regions[0].material.phi_deg = phi[0];
        statement.regions[1].material.phi_deg = phi[1];
        prove_upper(statement, &field)
    };
    for phi in [[44.9, 50.0], [50.0, 44.9], [30.0, 30.0]] {
        assert!((bound(phi, &mut statement).unwrap() - 12.0).abs() < 1e-12);
    }
    assert!(bound([50.0, 50.0], &mut statement).is_err());
}

#[test]
fn far_lines_must_frame_the_soil() {
    let plate = Plate { lean: 0.3, delta_deg: 20.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let mesh = plate.mesh(0.1, 1);
    let bound = |conditions: &[(usize, Condition)], gravity: [f64; 2]| {
        let mut statement = Plate { gravity, ..plate }.statement();
        for (boundary, condition) in conditions {
            statement.boundaries[*boundary].condition = *condition;
        }
        Problem::new(&statement)?;
        prove_lower(&statement, &fill(&statement, &mesh, 0.0, 1))
    };
    let [down, tilted] = [[0.0, -1.0], [0.1, -1.0]];
    let (fixed, smooth) = (Condition::Fixed, Condition::Smooth);
    assert!(bound(&[], down).is_ok());
    assert!(bound(&[], tilted).is_ok());
    for lines in [&[0][..], &[2], &[0, 2], &[1], &[0, 1, 2]] {
        let with = |c| lines.iter().map(|l| (*l, c)).collect::<Vec<_>>();
        assert!(bound(&with(fixed), down).is_ok(), "{lines:?}");
        assert!(bound(&with(smooth), down).is_ok(), "{lines:?}");
        assert!(bound(&with(fixed), tilted).is_ok(), "{lines:?}");
        // No frame, or a bare side at which the field's stress does not vanish.
        let free = bound(&with(Condition::Free), down).unwrap_err();
        assert!(
            matches!(free, CertificateError::NotCovered { .. } | CertificateError::NotProven { .. }),
            "{lines:?} {free}"
        );
    }
    let wall_below = bound(&[(0, smooth)], tilted).unwrap_err();
    assert!(matches!(wall_below, CertificateError::NotCovered { .. }), "{wall_below}");
    let top = bound(&[(3, Condition::Far)], down).unwrap_err();
    assert!(matches!(top, CertificateError::NotCovered { .. }), "{top}");
    // The datum is not where the surface is.
    let mut statement = plate.statement();
    statement.datum = 0.5;
    let error = prove_lower(&statement, &fill(&plate.statement(), &mesh, 0.0, 1)).unwrap_err();
    assert!(matches!(error, CertificateError::NotProven { .. }), "{error}");
}

#[test]
fn soil_beyond_far_lines_must_bear_its_stress() {
    let plate = Plate { lean: 0.0, delta_deg: 20.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let (statement, mesh) = (plate.statement(), plate.mesh(0.0, 1));
    let mut field = fill(&statement, &mesh, 0.0, 1);
    // At the corner, 3 deep, friction of 35 degrees allows horizontal stress up to 3.69 times the vertical one.
    let kp = (1.0 + 35.0_f64.to_radians().sin()) / (1.0 - 35.0_f64.to_radians().sin());
    for (stress, holds) in [
        (-3.0 * (kp - 1.0) + 1e-9, true),
        (-3.0 * (kp - 1.0) - 1e-9, false),
        (3.0 * (1.0 - 1.0 / kp) - 1e-9, true),
        (3.0 * (1.0 - 1.0 / kp) + 1e-9, false),
    ] {
        field.far_stress = stress;
        assert_eq!(prove_lower(&statement, &field).is_ok(), holds, "{stress}");
    }
    // A slope of 45 degrees at rest is too much for a friction of 35 degrees at any depth.
    let mut tilted = statement.clone();
    tilted.gravity = [1.0, -1.0];
    assert!(matches!(prove_lower(&tilted, &field).unwrap_err(), CertificateError::NotProven { .. }));
}
