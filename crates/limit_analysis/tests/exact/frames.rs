//! The same problem seen from elsewhere has the same bounds, but for what rounding does to its meshes.

use soilctl_certificate::{Linear, Objective, Statement};

use crate::common::soil;
use crate::grounds::slope;
use crate::solve;

/// Points moved, and gravity and body force turned with them.
fn moved(
    it: &Statement,
    point: impl Fn([f64; 2]) -> [f64; 2],
    turn: impl Fn([f64; 2]) -> [f64; 2],
) -> Statement {
    let Objective::Body { gravity } = it.objective else { panic!("a factor on the weight") };
    Statement {
        points: it.points.iter().map(|p| point(*p)).collect(),
        gravity: turn(it.gravity),
        objective: Objective::Body { gravity: turn(gravity) },
        ..it.clone()
    }
}

/// Left for right: loops and sides are walked the other way.
fn mirrored(it: &Statement) -> Statement {
    let flip = |[x, y]: [f64; 2]| [-x, y];
    let mut it = moved(it, flip, flip);
    for ring in it.regions.iter_mut().flat_map(|r| &mut r.loops) {
        ring.reverse();
        ring.iter_mut().for_each(|side| side.forward = !side.forward);
    }
    it.boundaries.iter_mut().for_each(|b| b.forward = !b.forward);
    it
}

fn bounds(it: Statement) -> [f64; 2] {
    let bounds = solve(it, 700);
    [bounds.lower.value, bounds.upper.value]
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_problems_have_the_same_bounds_in_every_frame() {
    let it = slope(soil(10.0, 1.0), 60.0);
    let reference = bounds(it.clone());
    let shift = [3.5, 2.25];
    let mut shifted = moved(&it, |[x, y]| [x + shift[0], y + shift[1]], |g| g);
    shifted.datum += shift[1];
    let (sin, cos) = 0.15_f64.sin_cos();
    let turn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
    let turned = moved(&it, turn, turn);
    // Lengths in halves, stresses in eighths of what they were.
    let mut units = moved(&it, |p| p.map(|x| 2.0 * x), |g| g);
    units.regions[0].material.unit_weight = 4.0;
    units.regions[0].material.cohesion = Linear::uniform(8.0);
    for (name, other) in
        [("shifted", shifted), ("mirrored", mirrored(&it)), ("turned", turned), ("in other units", units)]
    {
        let other = bounds(other);
        println!("{name}: {other:?} for {reference:?}");
        let same = reference.iter().zip(other).all(|(a, b)| (a - b).abs() < 0.01 * a);
        assert!(same, "{name}: {other:?} for {reference:?}");
        assert!(other[0] <= reference[1] && reference[0] <= other[1]);
    }
}
