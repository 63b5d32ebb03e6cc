//! Tractions of random stress functions balance and conditions hold, which nothing in the proof computes.

use proptest::prelude::*;

use super::super::*;
use crate::Material;
use crate::examples::{Blocks, Random, fill, material};
use crate::interval::{Interval, Vector};
use crate::problem::Stress;
use crate::tiling::OnLine;

fn middle(x: Interval) -> f64 {
    0.5 * (x.lo() + x.hi())
}

/// Stresses at the start and end of an edge, on the part of the triangle that adjoins it, with the edge's vector.
fn at_edge(function: &StressFunction, side: Side) -> (Vector, [Stress; 2]) {
    let corners = function.tiling.corners(side.triangle);
    let [a, b, _] = function.stresses(side.triangle)[side.corner];
    (corners[after(side.corner, 2)] - corners[after(side.corner, 1)], [a, b])
}

fn near(a: f64, b: f64, what: &str, side: Side) {
    assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{what} {side}: {a} {b}");
}

/// Pressure and shear that the statement demands at both ends of an edge.
fn demanded(statement: &Statement, factor: f64, on: OnLine, condition: Condition) -> [[f64; 2]; 2] {
    [on.start, on.end].map(|s| match condition {
        Condition::Loaded { pressure, shear, live } => {
            let factor = if live { factor } else { 1.0 };
            [pressure, shear].map(|[a, b]| factor * (a + s * (b - a)))
        }
        _ => [statement.surcharge, 0.0],
    })
}

/// Checks equilibrium in all parts, across all edges and at all boundaries.
pub(super) fn check(statement: &Statement, field: &LowerField) {
    let problem = Problem::new(statement).unwrap();
    let tiling = Tiling::new(&problem, &field.mesh).unwrap();
    let setting = Setting::new(&problem, field).unwrap();
    let function = StressFunction::new(&problem, &setting, &tiling, field).unwrap();
    let velocity = statement.objective.velocity();
    let mut power = 0.0;
    for side in tiling.sides() {
        let (t, stresses) = at_edge(&function, side);
        let n = t.turned();
        let tractions = stresses.map(|s| s.on(n));
        match tiling.beyond(side) {
            Beyond::Soil(other) => {
                let (_, [end, start]) = at_edge(&function, other);
                for (here, there) in tractions.into_iter().zip([start, end].map(|s| s.on(n))) {
                    near(middle(here.x), middle(there.x), "x across", side);
                    near(middle(here.y), middle(there.y), "y across", side);
                }
            }
            Beyond::Boundary(on, condition) => {
                let loads = demanded(statement, field.multiplier, on, condition);
                for (i, s) in stresses.iter().enumerate() {
                    let p = tiling.corners(side.triangle)[after(side.corner, 1 + i)];
                    let outside = match condition {
                        Condition::Far => function.references.base().at(p).between(t, n),
                        _ => Interval::ZERO,
                    };
                    if condition.shear_is_given() {
                        near(middle(s.between(t, n)), middle(outside), "shear", side);
                    }
                    if condition.traction_is_given() {
                        let ([pressure, shear], traction) = (loads[i], s.on(-n));
                        let [tx, ty] = [middle(t.x), middle(t.y)];
                        near(middle(traction.x), shear * tx - pressure * ty, "load x", side);
                        near(middle(traction.y), shear * ty + pressure * tx, "load y", side);
                    }
                }
                if let Condition::Face { .. } = condition {
                    // On the soil, so with the outward normal.
                    for traction in tractions {
                        power -= 0.5 * (middle(traction.x) * velocity[0] + middle(traction.y) * velocity[1]);
                    }
                }
            }
        }
    }
    near(middle(function.power()), power, "power", Side { triangle: 0, corner: 0 });
    for triangle in 0..field.mesh.triangles.len() {
        check_weight(statement, field, &function, triangle);
    }
}

fn check_weight(statement: &Statement, field: &LowerField, function: &StressFunction, triangle: usize) {
    let corners = function.tiling.corners(triangle).map(|p| [middle(p.x), middle(p.y)]);
    let centre = [0, 1].map(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0);
    let unit_weight = statement.regions[field.mesh.triangles[triangle].region].material.unit_weight;
    let live = match statement.objective {
        Objective::Body { gravity } => gravity.map(|g| g * field.multiplier),
        _ => [0.0; 2],
    };
    for (corner, nodes) in function.stresses(triangle).iter().enumerate() {
        let at = |i: usize| corners[after(corner, i)].map(|x| x);
        let [a, b] = [1, 2].map(|i| [at(i)[0] - centre[0], at(i)[1] - centre[1]]);
        let area = a[0] * b[1] - a[1] * b[0];
        let slope = |of: fn(&Stress) -> Interval| {
            let [u, v] = [0, 1].map(|i| middle(of(&nodes[i])) - middle(of(&nodes[2])));
            [(u * b[1] - v * a[1]) / area, (v * a[0] - u * b[0]) / area]
        };
        let [xx, yy, xy] = [slope(|s| s.xx), slope(|s| s.yy), slope(|s| s.xy)];
        for (k, sum) in [xx[0] + xy[1], xy[0] + yy[1]].into_iter().enumerate() {
            let weight = unit_weight * (statement.gravity[k] + live[k]);
            assert!(
                (sum + weight).abs() < 1e-6 * (1.0 + xx[0].abs() + yy[1].abs()),
                "{triangle}: {sum} {weight}"
            );
        }
    }
}

/// Two columns of two layers. The left one may be higher; loads are different on each side.
fn blocks(seed: u64, slope: f64, weights: [f64; 4], objective: Objective, sides: Condition) {
    let mut random = Random::new(seed);
    let materials: Vec<Material> = weights.map(|w| material(20.0, 1.0, w)).to_vec();
    let live = objective == Objective::Loads;
    let loads: Vec<Condition> = (0..64)
        .map(|i| {
            let mut two = || [random.next(), random.next()];
            Condition::Loaded { pressure: two(), shear: two(), live: live && i % 3 == 0 }
        })
        .collect();
    let loaded = |[x, y]: [f64; 2]| loads[((x * 7.0 + y * 3.0).abs() * 5.0) as usize % 64];
    let [tall, free, lid] = [seed % 2, seed % 5, seed % 3].map(|rest| rest == 0);
    let problem = Blocks {
        xs: &[0.0, 1.0, 2.5],
        ys: &[-1.0, 0.0, 0.7, 1.5],
        cell: &|i, j| match (i, j) {
            (1, 2) if tall => None,
            (i, 1 | 2) => Some(2 + i),
            _ => Some(i),
        },
        materials: &materials,
        condition: &|middle, out| match out {
            [0, -1] => Condition::Fixed,
            [1, 0] if middle[0] == 1.0 => loaded(middle),
            [_, 0] => sides,
            // The slope across the sides is then known from one of their lines only.
            [0, 1] if lid => Condition::Fixed,
            _ if free => Condition::Free,
            _ => loaded(middle),
        },
        objective,
        gravity: [0.0, -1.0],
        datum: 0.3,
        surcharge: 0.4,
        slope,
    };
    let statement = problem.statement();
    let mesh = problem.mesh(&statement);
    check(&statement, &fill(&statement, &mesh, 2.0, seed));
}

fn weights() -> impl Strategy<Value = [f64; 4]> {
    let some =
        [[1.0; 4], [2.0, 2.0, 1.0, 1.0], [1.0, 1.0, 1.5, 1.5], [0.0, 0.0, 1.0, 1.0], [1.0, 2.0, 3.0, 4.0]];
    prop::sample::select(some.to_vec())
}

proptest! {
    #[test]
    fn loads_balance(
        seed in 0_u64..10000,
        slope in prop_oneof![Just(0.0), -0.5..0.5_f64],
        weights in weights(),
        which in 0..3_usize,
        sides in prop_oneof![Just(Condition::Smooth), Just(Condition::Fixed), Just(Condition::Far)],
    ) {
        // Far soil needs a level base.
        let slope = if sides == Condition::Far { 0.0 } else { slope };
        // Far soil needs vertical gravity unless it is level up to the datum.
        let upright = weights != [1.0; 4] || sides == Condition::Far;
        let body = Objective::Body { gravity: [if upright { 0.0 } else { 0.3 }, -0.8] };
        let objective = [Objective::Loads, body, Objective::Structure { velocity: [1.0, 0.3] }][which];
        blocks(seed, slope, weights, objective, sides);
    }
}

proptest! {
    /// Two layers without cohesion up to the datum, where the stress vanishes, between walls of two lines each.
    #[test]
    fn bare_soil_balances(seed in 0_u64..10000, weights in weights(), far in any::<bool>()) {
        let sides = if far { Condition::Far } else { Condition::Smooth };
        let problem = Blocks {
            xs: &[0.0, 1.0, 2.5],
            ys: &[-1.0, 0.0, 0.7],
            cell: &|i, j| Some(2 * j + i),
            materials: &weights.map(|w| material(20.0, 0.0, w)),
            condition: &|_, out| match out {
                [0, -1] => Condition::Fixed,
                [0, _] => Condition::Free,
                _ => sides,
            },
            objective: Objective::Loads,
            gravity: [0.0, -1.0],
            datum: 0.7,
            surcharge: 0.0,
            slope: 0.0,
        };
        let statement = problem.statement();
        let mesh = problem.mesh(&statement);
        check(&statement, &fill(&statement, &mesh, 2.0, seed));
    }
}
