//! Blocks that slide as one, whose power is known by hand.

use super::near;
use crate::examples::{Block, stream_field, wall, wedge_field};
use crate::{
    Boundary, CertificateError, Condition, Flow, LineUse, Linear, Material, Objective, Region, Statement,
    UpperField, Velocity, prove_upper,
};

/// Slip line and friction of the wedge, in degrees; the wedge has the area `2 sqrt(3)`, its top the length `2 sqrt(3)`, its
/// slip line the length 4 and the ends (0, -2) and (2 sqrt(3), 0).
const PHI: f64 = 20.0;
const THETA: f64 = 30.0;

fn sin(degrees: f64) -> f64 {
    degrees.to_radians().sin()
}

fn cos(degrees: f64) -> f64 {
    degrees.to_radians().cos()
}

/// A vertical cut, two high: the wedge slides out of it, with unit speed at the angle `phi` off its slip line.
fn cut(objective: Objective, change: impl Fn(&mut Statement)) -> f64 {
    let mut statement = wall();
    statement.objective = objective;
    statement.boundaries[0].condition = Condition::Free;
    let material = &mut statement.regions[0].material;
    (material.phi_deg, material.cohesion) = (PHI, Linear::uniform(0.5));
    change(&mut statement);
    let mut field = wedge_field(1.0);
    let down = THETA - PHI - 1e-11;
    field.velocities[..6].fill(Velocity::Free { x: -cos(down), y: -sin(down) });
    if statement.lines[3].from == 0 {
        field.mesh.vertices[4].place = crate::Place::OnLine { line: 3, s: 12.0_f64.sqrt() / 4.0 };
    }
    prove_upper(&statement, &field).unwrap()
}

const BODY: Objective = Objective::Body { gravity: [0.0, -1.0] };

#[test]
fn coulombs_cut_bears_a_known_weight() {
    let area = 12.0_f64.sqrt();
    let weight = area * sin(THETA - PHI);
    let hold = 0.5 * 4.0 * cos(PHI);
    near(cut(BODY, |s| s.gravity = [0.0; 2]), hold / weight);
    near(cut(BODY, |_| {}), hold / weight - 1.0);
    near(cut(BODY, |s| s.regions[0].material.unit_weight = 2.0), hold / (2.0 * weight) - 1.0);
    // The surcharge presses on the top and on the cut.
    let pressed = 0.1 * (area * sin(THETA - PHI) - 2.0 * cos(THETA - PHI));
    near(cut(BODY, |s| s.surcharge = 0.1), (hold - weight - pressed) / weight);
}

#[test]
fn cohesion_and_pore_pressure_may_be_linear() {
    let weight = 12.0_f64.sqrt() * sin(THETA - PHI);
    let linear = Linear { at_origin: 0.7, gradient: [0.1, 0.2] };
    // On the slip line the mean of x is sqrt(3), that of y is -1.
    let mean = 0.7 + 0.1 * 3.0_f64.sqrt() - 0.2;
    near(cut(BODY, |s| s.regions[0].material.cohesion = linear), 4.0 * mean * cos(PHI) / weight - 1.0);
    let water = cut(BODY, |s| s.regions[0].material.pore_pressure = linear);
    near(water, 4.0 * (0.5 * cos(PHI) - mean * sin(PHI)) / weight - 1.0);
    // A rough face sees the water too, one that moves with the wedge does not.
    let mut statement = wall();
    statement.regions[0].material.pore_pressure = linear;
    let up = 3.0_f64.sqrt() * (1.0 + 1e-12);
    let base = -4.0 * mean;
    near(prove_upper(&statement, &wedge_field(up)).unwrap(), 6.0 + base);
    statement.boundaries[0].condition = Condition::Face { delta_deg: 0.0, adhesion: 0.0 };
    statement.objective = Objective::Structure { velocity: [0.5, 0.0] };
    // Half of the speed opens at the face, where the mean of the pressure is 0.5 over a length of 2.
    near(prove_upper(&statement, &wedge_field(up)).unwrap(), 6.0 + base - 0.5 * 2.0 * 0.5);
}

#[test]
fn everything_that_acts_has_one_factor() {
    let area = 12.0_f64.sqrt();
    let (weight, hold) = (area * sin(THETA - PHI), 0.5 * 4.0 * cos(PHI));
    near(cut(Objective::Everything, |_| {}), hold / weight);
    let pressed = 0.1 * (area * sin(THETA - PHI) - 2.0 * cos(THETA - PHI));
    near(cut(Objective::Everything, |s| s.surcharge = 0.1), hold / (weight + pressed));
    // Water lifts the wedge off its slip line, and a load that is dead for other objectives pushes its top.
    let water = 4.0 * 0.7 * sin(PHI);
    let pushed = Condition::Loaded { pressure: [0.3; 2], shear: [0.0; 2], live: false };
    let all = cut(Objective::Everything, |s| {
        s.regions[0].material.pore_pressure = Linear::uniform(0.7);
        s.boundaries[3].condition = pushed;
    });
    near(all, hold / (weight + water + 0.3 * weight));
}

#[test]
fn loads_may_be_linear_and_live() {
    let load = |pressure, live| Condition::Loaded { pressure, shear: [0.0; 2], live };
    let hold = 2.0 * cos(PHI) - 12.0_f64.sqrt() * sin(THETA - PHI);
    let top = 12.0_f64.sqrt();
    let sinks = sin(THETA - PHI);
    near(cut(Objective::Loads, |s| s.boundaries[3].condition = load([1.0; 2], true)), hold / (top * sinks));
    // The line runs from (4, 0) to the wall; the pressure is x/4, so its mean over the wedge is top/8.
    let triangle = load([1.0, 0.0], true);
    let expected = hold / (top * sinks * top / 8.0);
    near(cut(Objective::Loads, |s| s.boundaries[3].condition = triangle), expected);
    // The same line walked the other way.
    let turned = |s: &mut Statement| {
        let line = &mut s.lines[3];
        (line.from, line.to) = (line.to, line.from);
        s.regions[0].loops[0][3].forward = false;
        s.boundaries[3].forward = false;
        s.boundaries[3].condition = load([0.0, 1.0], true);
    };
    near(cut(Objective::Loads, turned), expected);
    // Shear along the top, which is walked to the left, as the wedge moves.
    let shear = Condition::Loaded { pressure: [0.0; 2], shear: [0.0, 1.0], live: true };
    let mean = 1.0 - top / 8.0;
    near(
        cut(Objective::Loads, |s| s.boundaries[3].condition = shear),
        hold / (top * mean * cos(THETA - PHI)),
    );
    // A dead load on the cut, and a live one on the top.
    let both = cut(Objective::Loads, |s| {
        s.boundaries[3].condition = load([1.0; 2], false);
        s.boundaries[0].condition = load([-0.1, -0.3], true);
    });
    near(both, (hold - top * sinks) / (0.2 * 2.0 * cos(THETA - PHI)));
}

/// The left half of a block of soil with friction is pulled off along x, and slides by `slip` along the crack.
fn crack(tension: Option<f64>, slip: f64) -> f64 {
    let block = Block { width: 2.0, height: 1.0 };
    let pull = Condition::Loaded { pressure: [-1.0; 2], shear: [0.0; 2], live: true };
    let conditions = [pull, Condition::Free, Condition::Fixed, Condition::Free];
    let mut statement = block.statement(conditions, Objective::Loads);
    let material = &mut statement.regions[0].material;
    (material.phi_deg, material.tension) = (30.0, tension);
    let mesh = block.mesh([2, 1]);
    let moves = |t: &crate::Triangle| t.corners.iter().any(|v| mesh.vertices[*v].position[0] == 0.0);
    let flows = mesh.triangles.iter().map(|t| Flow::Quadratic([usize::from(moves(t)); 6])).collect();
    let velocities = vec![Velocity::Zero, Velocity::Free { x: -1.0, y: slip }];
    let field =
        UpperField { mesh, flows, velocities, stream: Vec::new(), walls: Vec::new(), members: Vec::new() };
    prove_upper(&statement, &field).unwrap()
}

#[test]
fn a_crack_costs_its_tension() {
    near(crack(None, 0.0), 3.0_f64.sqrt());
    near(crack(Some(2.0), 0.0), 3.0_f64.sqrt());
    near(crack(Some(0.5), 0.0), 0.5);
    near(crack(Some(0.0), 0.0), 0.0);
    // With slip, Q (g - e) more.
    let q = (cos(30.0) - 0.5 * 0.5) / 0.5;
    near(crack(Some(0.5), 1.0), 0.5 + q * (2.0_f64.sqrt() - 1.0));
    near(
        crack(Some(1.7), 1.7),
        3.0_f64.sqrt().min(1.7 + (cos(30.0) - 0.85) / 0.5 * (1.7_f64.hypot(1.0) - 1.0)),
    );
}

/// Sand on clay, two wide and one high each: the sand is pushed along by a smooth wall, the clay below shears.
pub(super) fn sand_on_clay(speed: f64, rise: f64) -> (Statement, UpperField) {
    sand_on(rise, |[_, y]| [speed * (y + 2.0) * (y + 2.0) / 2.0, 0.0, speed * (y + 2.0)])
}

fn sand_on(rise: f64, stream: impl Fn([f64; 2]) -> [f64; 3]) -> (Statement, UpperField) {
    let block = Block { width: 2.0, height: 2.0 };
    let (free, fixed) = (Condition::Free, Condition::Fixed);
    let mut s = block.statement([free, fixed, free, free], Objective::Structure { velocity: [1.0, 0.0] });
    s.gravity = [0.0, -1.0];
    // Points 4 and 5 are the ends of the interface, line 6; lines 0 and 4 the left sides, 5 and 2 the right ones.
    s.points.extend([[0.0, -1.0], [2.0, -1.0]]);
    let ends = [(0, 4), (1, 2), (2, 5), (3, 0), (4, 1), (5, 3), (4, 5)];
    s.lines = ends.map(|(from, to)| crate::Line { from, to }).to_vec();
    let side = |line, forward| LineUse { line, forward };
    let face = Condition::Face { delta_deg: 0.0, adhesion: 0.0 };
    let conditions = [face, fixed, free, free, free, free];
    let boundary = |(line, condition)| Boundary { line, forward: true, condition };
    s.boundaries = conditions.into_iter().enumerate().map(boundary).collect();
    let clay = s.regions[0].material.clone();
    let sand = Material { phi_deg: 30.0, cohesion: Linear::uniform(0.2), unit_weight: 1.5, ..clay.clone() };
    let region = |sides: &[(usize, bool)], material| Region {
        loops: vec![sides.iter().map(|(line, forward)| side(*line, *forward)).collect()],
        material,
    };
    s.regions = vec![
        region(&[(0, true), (6, true), (5, true), (3, true)], sand),
        region(&[(4, true), (1, true), (2, true), (6, false)], clay),
    ];
    let corner = |point| crate::Vertex { position: s.points[point], place: crate::Place::Corner { point } };
    let triangle = |corners, region| crate::Triangle { corners, region };
    let mesh = crate::Mesh {
        vertices: (0..6).map(corner).collect(),
        triangles: vec![
            triangle([0, 4, 5], 0),
            triangle([0, 5, 3], 0),
            triangle([4, 1, 2], 1),
            triangle([4, 2, 5], 1),
        ],
    };
    let walls = [None, Some(0), None, None, None, None, None];
    let mut field = stream_field(&s, &mesh, &walls, &[0.0], stream);
    field.velocities = vec![Velocity::Free { x: 1.0, y: rise }];
    field.flows[..2].fill(Flow::Quadratic([0; 6]));
    (s, field)
}

#[test]
fn sand_slides_over_clay_by_its_own_strength() {
    let tan = 1.0 / 3.0_f64.sqrt();
    let bound = |speed, rise| {
        let (statement, field) = sand_on_clay(speed, rise);
        prove_upper(&statement, &field)
    };
    for speed in [0.0, 0.4, 0.9, 1.3] {
        let rise = (1.0_f64 - speed).abs() * tan * (1.0 + 1e-12) + 1e-13;
        // Shear of the clay, lift of the sand, cohesion along the interface.
        let expected = speed * 2.0 + 3.0 * rise + 0.2 / tan * rise * 2.0;
        near(bound(speed, rise).unwrap(), expected);
        if speed != 1.0 {
            assert!(matches!(bound(speed, 0.9 * rise), Err(CertificateError::NotProven { .. })));
        }
    }
}

#[test]
fn a_jump_between_sand_and_clay_may_vary_along_it() {
    // The clay sinks by 2 k x below the sand, and has no strength here.
    let (k, rise, tan) = (0.1, 1.0, 1.0 / 3.0_f64.sqrt());
    let (mut statement, field) = sand_on(rise, |[x, y]| {
        let d = y + 2.0;
        [k * x * x * d * d, 2.0 * k * x * d * d, 2.0 * k * x * x * d]
    });
    statement.regions[1].material.cohesion = Linear::default();
    let linear = Linear { at_origin: 0.2, gradient: [0.1, 0.0] };
    statement.regions[0].material.cohesion = linear;
    let opening = 0.2 * (2.0 * rise + 4.0 * k) + 0.1 * (2.0 * rise + 2.0 * k * 8.0 / 3.0);
    near(prove_upper(&statement, &field).unwrap(), 3.0 * rise + opening / tan);
    statement.regions[0].material.pore_pressure = linear;
    near(prove_upper(&statement, &field).unwrap(), 3.0 * rise + opening / tan - opening);
}
