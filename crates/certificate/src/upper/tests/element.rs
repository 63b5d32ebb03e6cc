//! Flows by any stream function, against an element built in another way and integrals by plain sums in doubles.

use super::reference::{derivative, integral, solve};
use crate::examples::{Block, Random, stream_field};
use crate::{Condition, Flow, Linear, Objective, Statement, StreamJet, UpperField, prove_upper};

/// A footing on the left part of a block, rough with adhesion, pressed down beside a smooth axis.
fn footing(gravity: [f64; 2]) -> (Statement, [Option<usize>; 5]) {
    let block = Block { width: 3.0, height: 2.0 };
    let plate = Condition::Face { delta_deg: 0.0, adhesion: 0.4 };
    let load = Condition::Loaded { pressure: [0.3, 0.9], shear: [0.2, -0.1], live: true };
    let mut s = block.statement(
        [Condition::Smooth, Condition::Fixed, Condition::Fixed, load],
        Objective::Structure { velocity: [0.25, -1.0] },
    );
    s.gravity = gravity;
    s.regions[0].material.unit_weight = 1.3;
    s.regions[0].material.cohesion = Linear { at_origin: 0.8, gradient: [0.1, -0.2] };
    s.points.push([1.0, 0.0]);
    s.lines[3].to = 4;
    s.lines.push(crate::Line { from: 4, to: 0 });
    let side = crate::LineUse { line: 4, forward: true };
    s.regions[0].loops[0].push(side);
    s.boundaries.push(crate::Boundary { line: 4, forward: true, condition: plate });
    (s, [Some(0), Some(0), Some(0), None, Some(0)])
}

/// A flow of the footing problem with random values up to `size` wherever they are free.
fn random_flow(statement: &Statement, wall_of: &[Option<usize>], size: f64, seed: u64) -> UpperField {
    let mut mesh = Block { width: 3.0, height: 2.0 }.mesh([6, 4]);
    for v in &mut mesh.vertices {
        v.place = match (v.place, v.position) {
            (crate::Place::OnLine { line: 3, .. }, [1.0, _]) => crate::Place::Corner { point: 4 },
            (crate::Place::OnLine { line: 3, .. }, [x, _]) if x < 1.0 => {
                crate::Place::OnLine { line: 4, s: 1.0 - x }
            }
            (crate::Place::OnLine { line: 3, .. }, [x, _]) => {
                crate::Place::OnLine { line: 3, s: (3.0 - x) / 2.0 }
            }
            (place, _) => place,
        };
    }
    let mut field = stream_field(statement, &mesh, wall_of, &[0.5], |_| [0.0; 3]);
    let mut random = Random::new(seed);
    let mut next = || size * random.next();
    for copy in &mut field.stream {
        copy.jet = match copy.jet {
            StreamJet::Free { .. } => StreamJet::Free { s: next(), sx: next(), sy: next() },
            StreamJet::Wall { wall, line, .. } if line == 0 || line == 4 => {
                StreamJet::Wall { wall, line, across: next() }
            }
            jet => jet,
        };
    }
    for (flow, t) in field.flows.iter_mut().zip(&mesh.triangles) {
        let Flow::Stream { slopes, .. } = flow else { continue };
        for (k, slope) in slopes.iter_mut().enumerate() {
            let [p, q] = [1, 2].map(|i| mesh.vertices[t.corners[(k + i) % 3]].position);
            let fixed = [p, q].iter().all(|v| v[0] == 3.0) || [p, q].iter().all(|v| v[1] == -2.0);
            *slope = if fixed { 0.0 } else { next() };
        }
    }
    field
}

/// Value and slopes that a jet stands for in this problem, by hand: the wall starts at (1, 0) with 0.5 and falls by one
/// along the footing, to which it is otherwise at rest.
fn by_hand(jet: StreamJet, [x, y]: [f64; 2]) -> [f64; 3] {
    match jet {
        StreamJet::Free { s, sx, sy } => [s, sx, sy],
        // n = (0, -1), slope along (-1, 0): -1.
        StreamJet::Wall { line: 4, across, .. } => [x - 0.5, 1.0, -across],
        // n = (2, 0).
        StreamJet::Wall { line: 0, across, .. } => [-0.5, 2.0 * across, 0.0],
        StreamJet::Corner { .. } if y == 0.0 && x == 0.0 => [-0.5, 1.0, 0.0],
        _ => [-0.5, 0.0, 0.0],
    }
}

/// The power of such a flow, by sums: dissipation and footing, times a factor on their strength, weight and load. The shear
/// rate may be taken to be linear between the nodes of each part.
fn sums(statement: &Statement, field: &UpperField, factor: f64, linear: bool, n: usize) -> f64 {
    let mesh = &field.mesh;
    let mut stored = std::collections::BTreeMap::new();
    let mut power = 0.0;
    for (t, flow) in mesh.triangles.iter().zip(&field.flows) {
        let Flow::Stream { corners, slopes } = *flow else { panic!("no stream") };
        let p = t.corners.map(|v| mesh.vertices[v].position);
        let jets = [0, 1, 2].map(|k| by_hand(field.stream[corners[k]].jet, p[k]));
        let across = [0, 1, 2].map(|k| {
            let [a, b] = [1, 2].map(|i| t.corners[(k + i) % 3]);
            // The first triangle that has an edge says what its slope is.
            let known: Option<&f64> = stored.get(&[b, a]);
            let slope = known.map_or(slopes[k], |slope| -slope);
            stored.insert([a, b], slope);
            slope
        });
        let parts = solve(p, jets, across);
        let centroid = [0, 1].map(|i| (p[0][i] + p[1][i] + p[2][i]) / 3.0);
        let rate = |k: usize, at: [f64; 2]| {
            let d = |order| derivative(&parts[k], at, order);
            (2.0 * d([1, 1])).hypot(d([0, 2]) - d([2, 0]))
        };
        let at_nodes = [0, 1, 2].map(|k| [p[(k + 1) % 3], p[(k + 2) % 3], centroid].map(|at| rate(k, at)));
        let of = |k: usize, at: [f64; 2], weights: [f64; 3]| {
            let d = |order| derivative(&parts[k], at, order);
            let between: f64 = at_nodes[k].iter().zip(weights).map(|(r, w)| r * w).sum();
            let rate = if linear { between } else { rate(k, at) };
            let c = 0.8 + 0.1 * at[0] - 0.2 * at[1];
            let [gx, gy] = statement.gravity;
            factor * c * rate - 1.3 * (gx * d([0, 1]) - gy * d([1, 0]))
        };
        power += integral(p, n, of);
        for k in 0..3 {
            let [a, b] = [1, 2].map(|i| p[(k + i) % 3]);
            if a[1] != 0.0 || b[1] != 0.0 {
                continue;
            }
            // Walked to the left along the top.
            for i in 0..n * n {
                let s = (i as f64 + 0.5) / (n * n) as f64;
                let x = a[0] + s * (b[0] - a[0]);
                let (vx, vy) =
                    (derivative(&parts[k], [x, 0.0], [0, 1]), -derivative(&parts[k], [x, 0.0], [1, 0]));
                let density = if x < 1.0 {
                    assert!((vy + 1.0).abs() < 1e-9, "{vy}");
                    factor * 0.4 * (vx - 0.25).abs()
                } else {
                    let f = (3.0 - x) / 2.0;
                    (0.3 + 0.6 * f) * vy + (0.2 - 0.3 * f) * vx
                };
                power += density * (a[0] - b[0]) / (n * n) as f64;
            }
        }
    }
    power
}

#[test]
fn random_flows_have_the_power_that_sums_find() {
    for seed in 0..4 {
        for (size, gravity) in [(0.0, [0.0, -1.0]), (0.3, [0.4, -1.0]), (2.0, [0.4, -1.0])] {
            let (statement, wall_of) = footing(gravity);
            let field = random_flow(&statement, &wall_of, size, seed);
            let bound = prove_upper(&statement, &field).unwrap();
            let sum = sums(&statement, &field, 1.0, false, 24);
            let above = sums(&statement, &field, 1.0, true, 24);
            // The slip of the footing is bounded by its values at control points.
            let slip = 0.05 * size;
            assert!(bound > sum && bound > above - 2e-3 * sum.abs(), "{seed} {size}: {bound} {above} {sum}");
            assert!(bound < above + slip + 2e-3 * sum.abs(), "{seed} {size}: {bound} {above} {sum}");
        }
    }
}

/// Without strength all is linear in the flow, and nothing is bounded by more than it is.
#[test]
fn the_power_of_loads_is_exact() {
    let (mut statement, wall_of) = footing([0.4, -1.0]);
    statement.regions[0].material.cohesion = Linear::default();
    let Some(footing) = statement.boundaries.last_mut() else { panic!("no footing") };
    footing.condition = Condition::Face { delta_deg: 0.0, adhesion: 1e-14 };
    for seed in 0..3 {
        let field = random_flow(&statement, &wall_of, 1.0, seed);
        let bound = prove_upper(&statement, &field).unwrap();
        let sum = sums(&statement, &field, 0.0, false, 40);
        assert!((bound - sum).abs() < 2e-3, "{bound} {sum}");
    }
}
