//! The gap as a sum of shares, with stress fields made by hand: only their equilibrium matters.

use soilctl_certificate::{Condition, Linear, Material, Objective, Statement};

use super::super::Upper;
use super::grounds::{footing, layered, pressed, soil};
use crate::accuracy::{self, solve_through};
use crate::fields::{StressField, VelocityField};
use crate::gap::shares;
use crate::mesh::{Guide, Mesh, Request, generate};
use crate::problem::Problem;
use crate::topology::Topology;

const PRESSURE: f64 = 1.5;

fn mesh(problem: &Problem, size: f64, guides: &[Guide]) -> (Mesh, Topology) {
    let size = |_: [f64; 2]| size;
    let request =
        Request { statement: problem.statement(), guides, fans: &[], size: &size, max_triangles: 10_000 };
    let mesh = generate(&request).unwrap();
    let topology = Topology::new(&mesh);
    (mesh, topology)
}

/// Level ground under an even load of which the part beyond `x = 1` is dead: the vertical stress follows from the load and
/// the weights of all layers, and the horizontal one may be any function of the height.
fn check(statement: &Statement, weight_above: impl Fn(f64) -> f64) {
    check_with(statement, |[_, y]| {
        let vertical = -PRESSURE - weight_above(y);
        [0.3 * vertical - 0.4, vertical, 0.0]
    });
}

/// The gap for a stress field that carries `PRESSURE` times the live loads, or that on a face.
fn check_with(statement: &Statement, of: impl Fn([f64; 2]) -> [f64; 3]) {
    let problem = Problem::new(statement.clone()).unwrap();
    let guides = [Guide { points: vec![[1.0, 0.0], [2.0, -0.7], [3.0, 0.0]] }];
    let (fine, topology) = mesh(&problem, 0.35, &guides);
    let upper = Upper::new(&problem, &fine, &topology, &[], 0.0);
    let answer = solve_through(&upper.program, accuracy::FLOW);
    let velocity = VelocityField::new(&upper, &answer.x);

    let (coarse, across) = mesh(&problem, 0.8, &[]);
    let corners: Vec<[[f64; 2]; 3]> =
        coarse.triangles.iter().map(|t| t.corners.map(|c| coarse.vertices[c].position)).collect();
    let (across, members) = (across.across.clone(), Vec::new());
    let mut stress = StressField { corners, across, parts: Vec::new(), part: 1.0, members };
    stress.parts = (0..coarse.triangles.len())
        .map(|t| {
            let (v, c) = (stress.corners[t], stress.centre(t));
            std::array::from_fn(|k| [v[(k + 1) % 3], v[(k + 2) % 3], c].map(&of))
        })
        .collect();
    let sum: f64 = shares(&problem, &fine, &topology, &velocity, &stress).iter().sum();
    let gap = upper.force.value(&answer.x) - PRESSURE;
    assert!((sum - gap).abs() < 2e-5 * gap.abs(), "{sum} {gap}, {:?}", answer.status);
}

fn loaded(material: Material) -> Statement {
    footing(1.0, [4.0, 2.0], pressed(1.0, true), pressed(PRESSURE, false), material, Objective::Loads)
}

#[test]
fn shares_add_up_in_clay() {
    let mut clay = soil(0.0, 1.0, 0.7);
    check(&loaded(clay.clone()), |y| -0.7 * y);
    clay.cohesion = Linear { at_origin: 1.0, gradient: [0.1, -0.5] };
    check(&loaded(clay), |y| -0.7 * y);
}

#[test]
fn shares_add_up_at_faces() {
    let below = |y: f64| -0.7 * y;
    let down = Objective::Structure { velocity: [0.2, -1.0] };
    let mut sand = soil(25.0, 0.5, 0.7);
    sand.pore_pressure = Linear { at_origin: 0.1, gradient: [0.05, -0.3] };
    for (meshed, delta_deg, adhesion) in [
        (soil(0.0, 1.0, 0.7), 0.0, 0.0),
        (soil(0.0, 1.0, 0.7), 0.0, 0.5),
        (sand.clone(), 0.0, 0.0),
        (sand, 15.0, 0.1),
    ] {
        let face = Condition::Face { delta_deg, adhesion };
        check(&footing(1.0, [4.0, 2.0], face, pressed(PRESSURE, false), meshed, down), below);
    }
}

#[test]
fn loads_that_are_linear_and_shear_count() {
    for meshed in [soil(0.0, 1.0, 0.0), soil(25.0, 0.5, 0.0)] {
        let mut s = loaded(meshed);
        s.boundaries[0].condition = Condition::Fixed;
        // Walked from the right to the left; the stress field is the same along all verticals.
        let load = |factor: f64, at: [f64; 2], live| Condition::Loaded {
            pressure: at.map(|x| factor * (1.0 + 0.2 * x)),
            shear: [0.1 * factor; 2],
            live,
        };
        s.boundaries[3].condition = load(PRESSURE, [4.0, 1.0], false);
        s.boundaries[4].condition = load(1.0, [1.0, 0.0], true);
        check_with(&s, |[x, _]| [-0.4, -PRESSURE * (1.0 + 0.2 * x), -0.1 * PRESSURE]);
    }
}

#[test]
fn shares_add_up_in_sand() {
    let mut sand = soil(25.0, 0.5, 0.7);
    check(&loaded(sand.clone()), |y| -0.7 * y);
    sand.cohesion = Linear { at_origin: 0.5, gradient: [0.1, -0.5] };
    sand.pore_pressure = Linear { at_origin: 0.1, gradient: [0.0, -0.3] };
    check(&loaded(sand.clone()), |y| -0.7 * y);
    sand.tension = Some(0.1);
    check(&loaded(sand), |y| -0.7 * y);
}

#[test]
fn shares_add_up_across_layers() {
    let below = |y: f64| if y < -0.5 { 0.5 * 0.7 - 0.9 * (y + 0.5) } else { -0.7 * y };
    for [upper, lower] in [
        [soil(30.0, 0.2, 0.7), soil(20.0, 0.4, 0.9)],
        [soil(30.0, 0.2, 0.7), soil(0.0, 1.0, 0.9)],
        [soil(0.0, 1.0, 0.7), soil(25.0, 0.1, 0.9)],
    ] {
        let s = layered([4.0, 2.0], 0.5, [upper, lower], pressed(PRESSURE, false));
        check(&s, below);
    }
}
