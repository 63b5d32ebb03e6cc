//! What members have to do with the gap: where they stretch without the force that they bear.

use soilctl_certificate::Side;

use crate::fields::{StressField, VelocityField};
use crate::members::{MemberEdge, velocity_at_end};
use crate::problem::Problem;
use crate::vector::Point;

/// Velocity of a member at the control points of an edge beside it, as the triangle there sees the edge, and the member's bond.
pub(super) fn beside(problem: &Problem, velocity: &VelocityField, side: Side) -> Option<([Point; 3], f64)> {
    let (edge, along, across) =
        velocity.members.iter().find(|(edge, ..)| edge.side == side || edge.other == side)?;
    let t = edge.along();
    let mut control =
        [0, 1, 2].map(|i| [along[i] * t[0] - across[i] * t[1], along[i] * t[1] + across[i] * t[0]]);
    if edge.other == side {
        control.reverse();
    }
    Some((control, problem.members()[edge.member].bond))
}

/// A quadratic polynomial from its Bernstein coefficients.
fn at(c: &[f64; 3], s: f64) -> f64 {
    (1.0 - s) * (1.0 - s) * c[0] + 2.0 * s * (1.0 - s) * c[1] + s * s * c[2]
}

/// The axial force somewhere along a member.
fn force(stress: &StressField, member: usize, place: f64) -> f64 {
    let of = |(edge, values): &(MemberEdge, [f64; 3])| {
        let [from, to] = edge.place;
        let [a, m, b] = *values;
        at(&[a, 2.0 * m - 0.5 * (a + b), b], ((place - from) / (to - from)).clamp(0.0, 1.0))
    };
    let edges = || stress.members.iter().filter(|(edge, _)| edge.member == member);
    edges().find(|(edge, _)| place <= edge.place[1]).or_else(|| edges().next_back()).map_or(0.0, of)
}

/// Adds what members dissipate and their axial forces do not match: half of it to the triangle on each side.
pub(super) fn add_shares(
    problem: &Problem,
    velocity: &VelocityField,
    stress: &StressField,
    shares: &mut [f64],
) {
    let pieces = &velocity.members;
    for (i, (edge, along, _)) in pieces.iter().enumerate() {
        let m = &problem.members()[edge.member];
        let spent =
            |change: f64| stress.part * (m.tension * change.max(0.0) + m.compression * (-change).max(0.0));
        let [a, b, c] = *along;
        let mut share = spent(b - a) + spent(c - b) - work(stress, edge, along);
        let jump = |change: f64, place: f64| spent(change) - change * force(stress, edge.member, place);
        let is_of = |other: &&(MemberEdge, [f64; 3], [f64; 3])| other.0.member == edge.member;
        if i.checked_sub(1).and_then(|i| pieces.get(i)).filter(is_of).is_none()
            && let Some(v) = velocity_at_end(problem, edge.member, 0)
        {
            share += jump(a - v, edge.place[0]);
        }
        match pieces.get(i + 1).filter(is_of) {
            Some((_, next, _)) => share += jump(next[0] - c, edge.place[1]),
            None => {
                if let Some(v) = velocity_at_end(problem, edge.member, 1) {
                    share += jump(v - c, edge.place[1]);
                }
            }
        }
        for side in [edge.side, edge.other] {
            shares[side.triangle] += 0.5 * share;
        }
    }
}

/// The integral of the axial force over the velocity along an edge. Between the ends of edges of both meshes it is that of a cubic.
fn work(stress: &StressField, edge: &MemberEdge, along: &[f64; 3]) -> f64 {
    let [from, to] = edge.place;
    let mut cuts = vec![from, to];
    for (other, _) in stress.members.iter().filter(|(other, _)| other.member == edge.member) {
        cuts.extend(other.place.iter().copied().filter(|p| *p > from && *p < to));
    }
    cuts.sort_by(f64::total_cmp);
    let piece = |w: &[f64]| {
        let [p, q] = [w[0], w[1]];
        let middle = 0.5 * (p + q);
        // Inside, where it is clear which edge counts.
        let inner = |place: f64| {
            let mut edges = stress.members.iter().filter(|(other, _)| other.member == edge.member);
            let on = edges.clone().find(|(other, _)| middle <= other.place[1]).or_else(|| edges.next_back());
            on.map_or(0.0, |(other, values)| {
                let [a, m, b] = *values;
                at(
                    &[a, 2.0 * m - 0.5 * (a + b), b],
                    (place - other.place[0]) / (other.place[1] - other.place[0]),
                )
            })
        };
        let rate = |place: f64| {
            let s = (place - from) / (to - from);
            2.0 * ((1.0 - s) * (along[1] - along[0]) + s * (along[2] - along[1])) / (to - from)
        };
        [(1.0, p), (4.0, middle), (1.0, q)].iter().map(|(w, s)| w / 6.0 * inner(*s) * rate(*s)).sum::<f64>()
            * (q - p)
    };
    cuts.windows(2).map(piece).sum()
}
