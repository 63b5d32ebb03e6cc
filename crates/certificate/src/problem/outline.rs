//! Lines do not cross and regions do not overlap.

use super::slot;
use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::statement::{LineUse, Statement};

/// Checks that two lines meet at most at a common point, and that nothing lies twice under regions.
pub(super) fn check(statement: &Statement, owners: &[[Option<usize>; 2]]) -> Result<(), CertificateError> {
    for b in 0..statement.lines.len() {
        for a in 0..=b {
            if !apart(statement, a, b) {
                let place = if a == b { format!("line {a}") } else { format!("lines {a} and {b}") };
                let problem =
                    if a == b { "has no length" } else { "cross, touch or overlap beside a common point" };
                return Err(CertificateError::BadStatement { place, problem });
            }
        }
    }
    // Sides with nothing on the other side of their line.
    let outer: Vec<LineUse> = (0..statement.lines.len())
        .flat_map(|line| [true, false].map(|forward| LineUse { line, forward }))
        .filter(|s| owners[s.line][slot(*s)].is_some() && owners[s.line][1 - slot(*s)].is_none())
        .collect();
    for side in &outer {
        if !empty_beyond(statement, &outer, *side) {
            let place = format!("line {}", side.line);
            let problem = "regions overlap, or a loop has its region on the right";
            return Err(CertificateError::BadStatement { place, problem });
        }
    }
    Ok(())
}

/// Whether two different lines are proven to have nothing in common but an end point; for one line, whether it has a
/// length.
fn apart(statement: &Statement, a: usize, b: usize) -> bool {
    let [l, m] = [a, b].map(|i| statement.lines[i]);
    let exact = |i: usize| statement.points[i];
    let point = |i: usize| Vector::point(exact(i));
    if a == b {
        return exact(l.from) != exact(l.to);
    }
    let range = |i: usize, j: usize, axis: usize| {
        let (p, q) = (exact(i)[axis], exact(j)[axis]);
        (p.min(q), p.max(q))
    };
    let far_apart = (0..2).any(|axis| {
        let (p, q) = (range(l.from, l.to, axis), range(m.from, m.to, axis));
        p.1 < q.0 || q.1 < p.0
    });
    if far_apart {
        return true;
    }
    for (common, i) in [(l.from, l.to), (l.to, l.from)] {
        for (other, j) in [(m.from, m.to), (m.to, m.from)] {
            if common == other {
                // Not along the same ray.
                let (p, q) = (point(i) - point(common), point(j) - point(common));
                return p.cross(q).is_not_zero() || (-p.dot(q)).is_positive();
            }
        }
    }
    let one_side = |i: usize, j: usize, p: usize, q: usize| {
        let d = point(j) - point(i);
        let (p, q) = (d.cross(point(p) - point(i)), d.cross(point(q) - point(i)));
        (p.is_positive() && q.is_positive()) || ((-p).is_positive() && (-q).is_positive())
    };
    one_side(l.from, l.to, m.from, m.to) || one_side(m.from, m.to, l.from, l.to)
}

/// Whether it is proven that no region lies on the right of a side that has soil only on its left.
///
/// The number of regions over a point is the sum of winding numbers of all loops; it is counted by the lines that a ray
/// from the point to infinity crosses. If it is zero beyond every such side, it is nowhere more than one: on the way
/// from where it is greatest to infinity it would first fall, across such a side, to something above zero.
fn empty_beyond(statement: &Statement, outer: &[LineUse], side: LineUse) -> bool {
    /// Slopes of the rays that are tried; one that runs through a corner counts nothing.
    const RAYS: [f64; 9] = [0.0, 0.37, -0.41, 1.13, -1.27, 3.1, -2.9, 9.7, -10.3];
    let walked =
        |s: LineUse| statement.lines[s.line].walked(s.forward).map(|i| Vector::point(statement.points[i]));
    let [from, to] = walked(side);
    let along = to - from;
    let middle = from + along * Interval::point(0.5);
    RAYS.iter().any(|slope| {
        let ray = along * Interval::point(*slope) - along.turned();
        let others = outer.iter().filter(|o| o.line != side.line);
        let count: Option<i64> = others.map(|o| crossing(middle, ray, walked(*o))).sum();
        count == Some(0)
    })
}

/// What crossing the line on the way along a ray from `start` takes away from the number of regions; nothing if that is
/// not certain.
fn crossing(start: Vector, ray: Vector, [from, to]: [Vector; 2]) -> Option<i64> {
    let (p, q) = (from - start, to - start);
    let (left_p, left_q) = (ray.cross(p), ray.cross(q));
    let above = |x: Interval| x.is_not_zero().then(|| x.is_positive());
    let (p_is_left, q_is_left) = (above(left_p)?, above(left_q)?);
    if p_is_left == q_is_left {
        return Some(0);
    }
    // Where the line meets the ray's line, measured along the ray, times `left_q - left_p`.
    let ahead = above(ray.dot(p) * left_q - ray.dot(q) * left_p)? == q_is_left;
    Some(match (ahead, q_is_left) {
        (false, _) => 0,
        (true, true) => 1,
        (true, false) => -1,
    })
}
