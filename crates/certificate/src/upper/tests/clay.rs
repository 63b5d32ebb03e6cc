//! Flows of soil without friction whose power is known by hand.

use super::near;
use crate::examples::{Block, pressed, pressed_field, stream_field};
use crate::{
    CertificateError, Condition, Flow, Linear, Objective, Statement, StreamCopy, StreamJet, UpperField,
    prove_upper,
};

fn pressed_by(n: [usize; 2], change: impl Fn(&mut Statement)) -> f64 {
    let (block, mut statement) = pressed();
    change(&mut statement);
    prove_upper(&statement, &pressed_field(block, &statement, n)).unwrap()
}

#[test]
fn a_strip_load_on_a_block_is_twice_the_cohesion() {
    for n in [[1, 1], [2, 3], [7, 4]] {
        near(pressed_by(n, |_| {}), 2.0);
        // The weight sinks by half the height for each unit at the top.
        near(pressed_by(n, |s| s.regions[0].material.unit_weight = 0.6), 2.0 - 0.6 / 2.0);
        // The surcharge on the right is pushed out.
        near(pressed_by(n, |s| s.surcharge = 0.25), 2.25);
        let linear = Linear { at_origin: 1.0, gradient: [0.25, -0.5] };
        near(pressed_by(n, |s| s.regions[0].material.cohesion = linear), 2.0 * (1.0 + 0.25 + 0.25));
        // Water in the pores and a limit to tension change nothing where nothing opens.
        near(pressed_by(n, |s| s.regions[0].material.pore_pressure = Linear::uniform(3.0)), 2.0);
        near(pressed_by(n, |s| s.regions[0].material.tension = Some(0.1)), 2.0);
    }
    // Any tilt of the load that leaves its total.
    let load = Condition::Loaded { pressure: [1.5, 0.5], shear: [0.0; 2], live: true };
    near(pressed_by([2, 2], |s| s.boundaries[3].condition = load), 2.0);
    // A shear load: along the top, walked to the left, the soil moves with -x.
    let sheared = |from, to| Condition::Loaded { pressure: [0.0; 2], shear: [from, to], live: true };
    near(pressed_by([2, 2], |s| s.boundaries[3].condition = sheared(-1.0, 0.0)), 4.0 / (4.0 / 3.0));
    near(pressed_by([2, 2], |s| s.boundaries[3].condition = sheared(0.0, -1.0)), 4.0 / (2.0 / 3.0));
}

#[test]
fn the_weight_that_a_block_bears_is_known() {
    // Factor 4 c/(w h) on the body force.
    let bound = pressed_by([3, 2], |s| {
        s.objective = Objective::Body { gravity: [0.0, -1.0] };
        s.gravity = [0.0; 2];
        s.regions[0].material.unit_weight = 0.5;
        // Dead now.
        s.boundaries[3].condition = Condition::Loaded { pressure: [0.5; 2], shear: [0.0; 2], live: true };
    });
    near(bound, (4.0 - 1.0) / 0.5);
    let error = |change: &dyn Fn(&mut Statement)| {
        let (block, mut statement) = pressed();
        let field = pressed_field(block, &statement, [1, 1]);
        change(&mut statement);
        prove_upper(&statement, &field).unwrap_err()
    };
    for change in [
        (&|s: &mut Statement| s.boundaries[3].condition = Condition::Free) as &dyn Fn(&mut Statement),
        &|s| s.objective = Objective::Body { gravity: [0.0, 1.0] },
    ] {
        let error = error(change);
        assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
    }
}

/// A plate on a block, and the flow that it presses out at the side.
pub(super) fn plated(n: [usize; 2]) -> (Statement, UpperField) {
    let block = Block { width: 2.0, height: 1.0 };
    let plate = Condition::Face { delta_deg: 0.0, adhesion: 0.3 };
    let conditions = [Condition::Smooth, Condition::Smooth, Condition::Free, plate];
    let objective = Objective::Structure { velocity: [0.5, -1.0] };
    let statement = block.statement(conditions, objective);
    // Its wall goes on: plate, left side, bottom. It grows by -2 along the plate.
    let stream = |[x, y]: [f64; 2]| [x * (y + 1.0), y + 1.0, x];
    let wall = [Some(0), Some(0), None, Some(0)];
    let field = stream_field(&statement, &block.mesh(n), &wall, &[2.0], stream);
    (statement, field)
}

#[test]
fn a_plate_with_adhesion_adds_what_slips() {
    for n in [[2, 1], [4, 3]] {
        let (statement, field) = plated(n);
        // Slip x - 1/2 along the plate: the bound uses the greater absolute values at control points where it turns.
        let bound = prove_upper(&statement, &field).unwrap();
        let exact = 4.0 + 0.3 * (0.125 + 1.125);
        assert!(bound > exact - 1e-9 && bound < exact + 0.3 * 0.3, "{bound} {exact}");
    }
}

/// Soil that shears along level lines with the speed `y^2/2`, all sides free.
#[test]
fn a_shear_rate_that_is_linear_is_exact() {
    let block = Block { width: 2.0, height: 3.0 };
    let mut statement = block.statement([Condition::Free; 4], Objective::Structure { velocity: [0.0; 2] });
    statement.gravity = [0.5, -1.0];
    statement.regions[0].material.unit_weight = 0.7;
    statement.regions[0].material.cohesion = Linear { at_origin: 1.0, gradient: [0.0, -1.0] };
    let field = stream_field(&statement, &block.mesh([3, 4]), &[None; 4], &[], |[_, y]| {
        [y * y * y / 6.0, 0.0, y * y / 2.0]
    });
    // c g = (1 - y)(-y).
    let dissipation = 2.0 * (9.0 / 2.0 + 27.0 / 3.0);
    near(prove_upper(&statement, &field).unwrap(), dissipation - 0.5 * 0.7 * 2.0 * 27.0 / 6.0);
}

/// Clay of which the left half is pulled off to the left.
pub(super) fn torn() -> (Statement, UpperField) {
    let block = Block { width: 2.0, height: 1.0 };
    let pull = Condition::Loaded { pressure: [-1.0; 2], shear: [0.0; 2], live: true };
    let conditions = [pull, Condition::Free, Condition::Fixed, Condition::Free];
    let mut statement = block.statement(conditions, Objective::Loads);
    statement.regions[0].material.tension = Some(0.4);
    let mesh = block.mesh([2, 1]);
    let mut field = stream_field(&statement, &mesh, &[None, None, Some(0), None], &[0.0], |_| [0.0; 3]);
    // The left half has vertex copies of its own.
    let count = field.stream.len();
    for i in 0..count {
        let y = mesh.vertices[i].position[1];
        field.stream.push(StreamCopy { vertex: i, jet: StreamJet::Free { s: -y, sx: 0.0, sy: -1.0 } });
    }
    for (flow, t) in field.flows.iter_mut().zip(&mesh.triangles) {
        let Flow::Stream { corners, slopes } = flow else { continue };
        let x = |k: usize| mesh.vertices[t.corners[k % 3]].position[0];
        if [0, 1, 2].iter().any(|k| x(*k) == 0.0) {
            *corners = corners.map(|c| c + count);
            *slopes = [0, 1, 2].map(|k| x(k + 1) - x(k + 2));
        }
    }
    (statement, field)
}

#[test]
fn a_crack_in_clay_costs_its_tension() {
    let (mut statement, field) = torn();
    for (tension, expected) in [(0.4, 0.4), (0.0, 0.0)] {
        statement.regions[0].material.tension = Some(tension);
        near(prove_upper(&statement, &field).unwrap(), expected);
        statement.regions[0].material.pore_pressure = Linear { at_origin: 0.0, gradient: [0.0, -1.0] };
        near(prove_upper(&statement, &field).unwrap(), expected - 0.5);
        statement.regions[0].material.pore_pressure = Linear::default();
    }
    statement.regions[0].material.tension = None;
    let closed = prove_upper(&statement, &field).unwrap_err();
    assert!(matches!(closed, CertificateError::NotProven { .. }), "{closed}");
}

fn stream_corners(flow: Flow) -> Vec<usize> {
    match flow {
        Flow::Stream { corners, .. } => corners.to_vec(),
        Flow::Quadratic(_) => Vec::new(),
    }
}

#[test]
fn rules_of_construction_are_checked() {
    let refused = |change: &dyn Fn(&mut Statement, &mut UpperField)| {
        let (block, mut statement) = pressed();
        let mut field = pressed_field(block, &statement, [2, 2]);
        change(&mut statement, &mut field);
        prove_upper(&statement, &field).unwrap_err()
    };
    let is_bad = |e: CertificateError| assert!(matches!(e, CertificateError::BadField { .. }), "{e}");
    // Vertices 0 and 6 are corners of the wall, 3 lies on its left side, 4 inside.
    let free = StreamJet::Free { s: 0.0, sx: 0.0, sy: 0.0 };
    is_bad(refused(&|_, f| f.stream[3].jet = free));
    is_bad(refused(&|_, f| f.stream[6].jet = StreamJet::Wall { wall: 0, line: 0, across: 0.1 }));
    is_bad(refused(&|_, f| f.stream[4].jet = StreamJet::Corner { wall: 0 }));
    is_bad(refused(&|_, f| f.stream[3].jet = StreamJet::Corner { wall: 0 }));
    is_bad(refused(&|_, f| f.stream[3].jet = StreamJet::Wall { wall: 0, line: 1, across: 0.0 }));
    is_bad(refused(&|_, f| f.stream[3].vertex = 4));
    is_bad(refused(&|s, _| s.boundaries[0].condition = Condition::Fixed));
    is_bad(refused(&|_, f| {
        f.velocities.push(crate::Velocity::Free { x: 1.0, y: 0.0 });
        f.flows[0] = Flow::Quadratic([0; 6]);
    }));
    let length = refused(&|_, f| f.walls.push(0.0));
    assert!(matches!(length, CertificateError::Length { .. }), "{length}");
    let rough =
        refused(&|s, _| s.boundaries[0].condition = Condition::Face { delta_deg: 1.0, adhesion: 0.0 });
    assert!(matches!(rough, CertificateError::NotCovered { .. }), "{rough}");
    // A copy of its own on one side of an inner edge makes a jump, which soil without friction does not allow.
    let torn = refused(&|_, f| {
        f.stream.push(f.stream[4]);
        let last = f.stream.len() - 1;
        f.stream[last].jet = StreamJet::Free { s: 0.1, sx: 0.0, sy: 0.0 };
        let at = f.flows.iter().position(|flow| stream_corners(*flow).contains(&4)).unwrap();
        if let Flow::Stream { corners, .. } = &mut f.flows[at] {
            *corners = corners.map(|c| if c == 4 { last } else { c });
        }
    });
    assert!(matches!(torn, CertificateError::NotProven { .. }), "{torn}");
}
