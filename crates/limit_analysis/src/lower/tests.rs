//! Lower bounds of problems with known answers, on one mesh each.

use soilctl_certificate::{Condition, Linear, Material, Objective, Statement, prove_lower};

#[path = "../../tests/common/mod.rs"]
pub(crate) mod common;

use common::{soil, statement};

use super::*;
use crate::accuracy::{self, solve_through};
use crate::mesh::{Fan, Request, generate};

fn proven(statement: Statement, fan: Option<usize>, size: impl Fn([f64; 2]) -> f64) -> f64 {
    let problem = Problem::new(statement).unwrap();
    let fans: Vec<Fan> = fan.into_iter().map(|point| Fan { point, radius: 0.1, angle: 0.26 }).collect();
    let request = Request {
        statement: problem.statement(),
        guides: &[],
        fans: &fans,
        size: &size,
        max_triangles: 20_000,
    };
    let mesh = generate(&request).unwrap();
    let topology = Topology::new(&mesh);
    let accuracy = soilctl_conic::Accuracy { gap: 1e-7, ..accuracy::STRESS };
    let attempt = |tightening: f64| {
        let lower = Lower::new(&problem, &mesh, &topology, tightening);
        let answer = solve_through(&lower.program, accuracy);
        let x = lower.drawn_inside(&answer.x, -0.5 * tightening);
        let field = lower.function.saved(&mesh, &topology, &problem, &x);
        prove_lower(problem.statement(), &field).ok()
    };
    [1e-8, 1e-7, 1e-6, 1e-5].into_iter().find_map(attempt).unwrap()
}

const STRIP: [[f64; 2]; 5] = [[0.0, 0.0], [0.0, -3.0], [5.0, -3.0], [5.0, 0.0], [1.0, 0.0]];

fn pressed(pressure: f64, live: bool) -> Condition {
    Condition::Loaded { pressure: [pressure; 2], shear: [0.0; 2], live }
}

/// Half of a strip load of half-width one, with a pressure beside it.
fn strip(material: Material, beside: f64) -> Statement {
    statement(&[(&[0, 1, 2, 3, 4], material)], &STRIP, Objective::Loads, |[x, y]| {
        if x == 0.0 {
            Condition::Smooth
        } else if y == 0.0 {
            if x < 1.0 { pressed(1.0, true) } else { pressed(beside, false) }
        } else {
            Condition::Fixed
        }
    })
}

fn around_edge(p: [f64; 2]) -> f64 {
    (0.05 + 0.2 * (p[0] - 1.0).hypot(p[1])).min(0.6)
}

#[test]
fn a_strip_on_clay_carries_prandtls_load() {
    let load = proven(strip(soil(0.0, 1.0), 0.0), Some(4), around_edge);
    let exact = 2.0 + std::f64::consts::PI;
    assert!(load <= exact && load > 0.98 * exact, "{load}");
}

#[test]
fn a_surcharge_beside_a_strip_on_weightless_sand_carries_nq() {
    let (exact, load) = (18.401, proven(strip(soil(30.0, 0.0), 1.0), Some(4), around_edge));
    assert!(load <= exact + 1e-3 && load > 0.92 * exact, "{load}");
}

#[test]
fn a_vertical_cut_in_clay_has_its_critical_height() {
    let points = [[-3.0, 1.0], [-3.0, -1.5], [2.0, -1.5], [2.0, 0.0], [0.0, 0.0], [0.0, 1.0]];
    let material = Material { unit_weight: 1.0, ..soil(0.0, 1.0) };
    let free = |[x, y]: [f64; 2]| {
        if (x > 0.0 && y == 0.0) || x == 0.0 || y == 1.0 { Condition::Free } else { Condition::Fixed }
    };
    let objective = Objective::Body { gravity: [0.0, -1.0] };
    let cut = statement(&[(&[0, 1, 2, 3, 4, 5], material.clone())], &points, objective, free);
    let factor = proven(cut, Some(4), |p| (0.06 + 0.15 * p[0].hypot(p[1])).min(0.5));
    // Pastor, Thai & Francescato (2000), Martin (2011): between 3.7760 and 3.7777.
    assert!(factor <= 3.7777 && factor > 3.66, "{factor}");
}

/// A wall that is pushed into two level layers, the lower one heavier: the exact force is the sum of Rankine's pressures.
#[test]
fn a_smooth_wall_before_layers_has_rankines_pressure() {
    let points = [
        [0.0, 0.0],
        [0.0, -0.4],
        [0.0, -1.0],
        [0.0, -3.0],
        [6.0, -3.0],
        [6.0, -1.0],
        [6.0, -0.4],
        [6.0, 0.0],
    ];
    let light = Material { unit_weight: 1.0, ..soil(30.0, 0.1) };
    let heavy = Material { unit_weight: 1.7, ..soil(30.0, 0.1) };
    let layers: [(&[usize], Material); 3] =
        [(&[0, 1, 6, 7], light), (&[1, 2, 5, 6], heavy.clone()), (&[2, 3, 4, 5], heavy)];
    let objective = Objective::Structure { velocity: [1.0, 0.0] };
    for far in [false, true] {
        let mut wall = statement(&layers, &points, objective, |[x, y]| {
            if x == 0.0 && y > -1.0 {
                Condition::Face { delta_deg: 0.0, adhesion: 0.0 }
            } else if y == 0.0 {
                Condition::Free
            } else if x == 0.0 {
                Condition::Smooth
            } else if far {
                Condition::Far
            } else {
                Condition::Fixed
            }
        });
        wall.gravity = [0.0, -1.0];
        let kp = 3.0_f64;
        let cohesion = 2.0 * 0.1 * kp.sqrt();
        let exact = kp * (0.4 * 0.4 / 2.0 + 0.6 * 0.4 + 1.7 * 0.6 * 0.6 / 2.0) + cohesion;
        let force = proven(wall, None, |p| (0.1 + 0.2 * p[0].hypot(p[1] + 0.5)).min(0.8));
        assert!(force <= exact && force > 0.97 * exact, "far {far}: {force} of {exact}");
    }
}

/// Water up to the surface takes its own weight off the soil.
#[test]
fn ground_water_leaves_the_buoyant_weight() {
    let points = [[0.0, 0.0], [0.0, -1.0], [0.0, -3.0], [6.0, -3.0], [6.0, 0.0]];
    let wall = |unit_weight: f64, water: f64| {
        let pore_pressure = Linear { at_origin: 0.0, gradient: [0.0, -water] };
        let material = Material { unit_weight, pore_pressure, ..soil(30.0, 0.2) };
        let objective = Objective::Structure { velocity: [1.0, 0.0] };
        let mut wall = statement(&[(&[0, 1, 2, 3, 4], material)], &points, objective, |[x, y]| {
            if x == 0.0 && y > -1.0 {
                Condition::Face { delta_deg: 10.0, adhesion: 0.0 }
            } else if y == 0.0 {
                Condition::Free
            } else {
                Condition::Fixed
            }
        });
        wall.gravity = [0.0, -1.0];
        proven(wall, None, |p| (0.1 + 0.2 * p[0].hypot(p[1] + 0.5)).min(0.8))
    };
    // The water itself pushes back with half its weight times the height squared.
    let (wet, buoyant) = (wall(2.0, 1.0) - 0.5, wall(1.0, 0.0));
    assert!((wet / buoyant - 1.0).abs() < 1e-3, "{wet} {buoyant}");
}

/// A slope in soil with friction and cohesion, on ground of its own level on each side.
#[test]
fn a_slope_stands_below_its_critical_height() {
    let points = [[-4.0, 1.0], [-4.0, -2.0], [5.0, -2.0], [5.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let material = Material { unit_weight: 1.0, ..soil(20.0, 1.0) };
    let objective = Objective::Body { gravity: [0.0, -1.0] };
    let slope = |far: bool| {
        statement(&[(&[0, 1, 2, 3, 4, 5], material.clone())], &points, objective, |[x, y]| {
            if y == 1.0 || y == 0.0 || (x > 0.0 && x < 1.0 && y > 0.0) {
                Condition::Free
            } else if far {
                Condition::Far
            } else {
                Condition::Fixed
            }
        })
    };
    let size = |p: [f64; 2]| (0.08 + 0.15 * (p[0] - 0.8).hypot(p[1])).min(0.6);
    // Michalowski (1995), Chen (1975): 16.16 for 45 and 20 degrees, an upper bound.
    for far in [false, true] {
        let factor = proven(slope(far), None, size);
        assert!(factor <= 16.2 && factor > 15.0, "far {far}: {factor}");
    }
}
