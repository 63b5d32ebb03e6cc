//! Walls that are closed, thin or meet others.

use super::near;
use crate::examples::{Block, Plate, stream_field};
use crate::{
    CertificateError, Condition, Flow, Linear, Objective, Place, Statement, StreamCopy, StreamJet,
    UpperField, prove_upper,
};

const FACE: Condition = Condition::Face { delta_deg: 0.0, adhesion: 0.5 };

/// A block of three by three with a square hole in the middle.
fn holed(
    outer: Condition,
    sides: [Condition; 4],
    stream: impl Fn([f64; 2]) -> [f64; 3],
) -> (Statement, UpperField) {
    let block = Block { width: 3.0, height: 3.0 };
    let mut s = block.statement([outer; 4], Objective::Structure { velocity: [1.0, 0.5] });
    s.points.extend([[1.0, -1.0], [2.0, -1.0], [2.0, -2.0], [1.0, -2.0]]);
    let hole: Vec<usize> = (4..8).collect();
    // Clockwise.
    s.lines.extend([(4, 5), (5, 6), (6, 7), (7, 4)].map(|(from, to)| crate::Line { from, to }));
    let forward = |line: &usize| crate::LineUse { line: *line, forward: true };
    s.regions[0].loops.push(hole.iter().map(forward).collect());
    let boundary =
        |(line, condition): (&usize, Condition)| crate::Boundary { line: *line, forward: true, condition };
    s.boundaries.extend(hole.iter().zip(sides).map(boundary));
    let mut mesh = block.mesh([3, 3]);
    for v in &mut mesh.vertices {
        if let Some(point) = s.points.iter().position(|p| *p == v.position) {
            v.place = Place::Corner { point };
        }
    }
    let inside = |t: &crate::Triangle| {
        t.corners
            .iter()
            .all(|v| mesh.vertices[*v].position.map(|x| x.abs() >= 1.0 && x.abs() <= 2.0) == [true; 2])
    };
    mesh.triangles = mesh.triangles.iter().copied().filter(|t| !inside(t)).collect();
    let outside = (outer == Condition::Fixed).then_some(0);
    let own = Some(usize::from(outside.is_some()));
    let wall_of = [[outside; 4], [own; 4]].concat();
    // The hole's wall starts at (1, -1).
    let values = [0.0, stream([1.0, -1.0])[0]];
    let field = stream_field(&s, &mesh, &wall_of, &values[usize::from(outside.is_none())..], stream);
    (s, field)
}

#[test]
fn soil_may_move_with_an_obstacle() {
    // v = (1, 1/2).
    let (mut statement, field) = holed(Condition::Free, [FACE; 4], |[x, y]| [y - 0.5 * x, -0.5, 1.0]);
    near(prove_upper(&statement, &field).unwrap(), 0.0);
    // All soil rises.
    statement.regions[0].material.unit_weight = 1.0;
    near(prove_upper(&statement, &field).unwrap(), 8.0 * 0.5);
}

#[test]
fn soil_may_flow_around_an_obstacle() {
    let around = |[x, y]: [f64; 2]| {
        let outer = x == 0.0 || y == 0.0 || x == 3.0 || y == -3.0;
        if outer { [0.0; 3] } else { [y - 0.5 * x + 2.25, -0.5, 1.0] }
    };
    let (statement, mut field) = holed(Condition::Fixed, [FACE; 4], around);
    for (flow, t) in field.flows.iter_mut().zip(&field.mesh.triangles) {
        let Flow::Stream { slopes, .. } = flow else { continue };
        for (k, slope) in slopes.iter_mut().enumerate() {
            let outer = |i: usize| around(field.mesh.vertices[t.corners[(k + i) % 3]].position) == [0.0; 3];
            if outer(1) && outer(2) {
                *slope = 0.0;
            }
        }
    }
    let bound = prove_upper(&statement, &field).unwrap();
    assert!(bound > 10.0 && bound < 200.0, "{bound}");
    // The flow carried around must be zero.
    let mut torn = statement.clone();
    torn.boundaries[5].condition = Condition::Smooth;
    let error = prove_upper(&torn, &field).unwrap_err();
    assert!(matches!(error, CertificateError::NotCovered { .. }), "{error}");
    // Soil that moves along a fixed side, between vertices or at them.
    let mut bulging = field.clone();
    for flow in &mut bulging.flows {
        if let Flow::Stream { slopes, .. } = flow {
            slopes.iter_mut().filter(|slope| **slope == 0.0).for_each(|slope| *slope = 1e-300);
        }
    }
    let error = prove_upper(&statement, &bulging).unwrap_err();
    assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
    let mut sliding = field;
    for copy in &mut sliding.stream {
        if let StreamJet::Wall { wall: 0, across, .. } = &mut copy.jet {
            *across = 1e-300;
        }
    }
    let error = prove_upper(&statement, &sliding).unwrap_err();
    assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
}

/// The plate problem in clay that moves along with the plate as one. The vertices on the plate have two copies, but that at
/// its tip.
fn plate() -> (Statement, UpperField) {
    let plate = Plate { lean: 0.0, delta_deg: 0.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let (mut statement, mesh) = (plate.statement(), plate.mesh(0.0, 1));
    statement.regions[0].material.phi_deg = 0.0;
    statement.regions[0].material.cohesion = Linear::uniform(1.0);
    for boundary in &mut statement.boundaries {
        boundary.condition = if boundary.line == 4 { FACE } else { Condition::Free };
    }
    let wall_of = [None, None, None, None, Some(0), None];
    let mut field = stream_field(&statement, &mesh, &wall_of, &[0.0], |[_, y]| [y, 0.0, 1.0]);
    for (flow, t) in field.flows.iter_mut().zip(&mesh.triangles) {
        let Flow::Stream { corners, .. } = flow else { continue };
        let left = t.corners.iter().any(|v| mesh.vertices[*v].position[0] < 0.0);
        for copy in corners {
            let [x, y] = mesh.vertices[*copy].position;
            if left && x == 0.0 && y > -2.0 {
                field.stream.push(field.stream[*copy]);
                *copy = field.stream.len() - 1;
            }
        }
    }
    // Each triangle on the left has its own copy now; those of one vertex are made one.
    let mut first = std::collections::BTreeMap::new();
    let count = mesh.vertices.len();
    let one: Vec<usize> = field
        .stream
        .iter()
        .enumerate()
        .map(|(i, c)| *first.entry((c.vertex, i < count)).or_insert(i))
        .collect();
    for flow in &mut field.flows {
        if let Flow::Stream { corners, .. } = flow {
            *corners = corners.map(|c| one[c]);
        }
    }
    for (i, copy) in field.stream.iter_mut().enumerate().filter(|(i, _)| one[*i] != *i) {
        *copy = StreamCopy { jet: StreamJet::Free { s: i as f64, sx: 0.0, sy: 0.0 }, ..*copy };
    }
    (statement, field)
}

#[test]
fn both_sides_of_a_thin_plate_are_one_wall() {
    let (statement, mut field) = plate();
    near(prove_upper(&statement, &field).unwrap(), 0.0);
    // Soil that slips along one side of the plate, by 2 across, at the middle of its length.
    let slipped = field.stream.iter().position(|c| matches!(c.jet, StreamJet::Wall { .. })).unwrap();
    if let StreamJet::Wall { across, .. } = &mut field.stream[slipped].jet {
        *across = 0.25;
    }
    let bound = prove_upper(&statement, &field).unwrap();
    assert!(bound > 0.1, "{bound}");
    // One copy for both sides.
    let (_, mut shared) = plate();
    for flow in &mut shared.flows {
        if let Flow::Stream { corners, .. } = flow {
            *corners = corners.map(|c| shared.stream[c].vertex);
        }
    }
    let error = prove_upper(&statement, &shared).unwrap_err();
    assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
}
