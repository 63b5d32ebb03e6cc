//! What members have to do with the gap: where they stretch without the force that they bear.

use soilctl_certificate::{Bending, Side};

use crate::fields::{Forces, MemberVelocity, StressField, VelocityField};
use crate::members::{MemberEdge, beam_at_end, velocity_at_end};
use crate::problem::Problem;
use crate::vector::{Point, between, dot, length};

/// Velocity of a member at the control points of an edge beside it, as the triangle there sees the edge, and the member's bond.
pub(super) fn beside(problem: &Problem, velocity: &VelocityField, side: Side) -> Option<([Point; 3], f64)> {
    let MemberVelocity { edge, along, across, .. } =
        velocity.members.iter().find(|piece| piece.edge.faces().any(|face| face == side))?;
    let t = edge.along();
    let mut control =
        [0, 1, 2].map(|i| [along[i] * t[0] - across[i] * t[1], along[i] * t[1] + across[i] * t[0]]);
    if edge.sides[1] == Some(side) {
        control.reverse();
    }
    Some((control, problem.members()[edge.member].bond))
}

/// A quadratic polynomial from its Bernstein coefficients.
fn at(c: &[f64; 3], s: f64) -> f64 {
    (1.0 - s) * (1.0 - s) * c[0] + 2.0 * s * (1.0 - s) * c[1] + s * s * c[2]
}

/// A cubic polynomial from its Bernstein coefficients.
fn cubic(c: &[f64; 4], s: f64) -> f64 {
    (1.0 - s) * at(&[c[0], c[1], c[2]], s) + s * at(&[c[1], c[2], c[3]], s)
}

/// Something that a member bears somewhere along itself.
fn borne(stress: &StressField, member: usize, place: f64, what: impl Fn(&Forces, f64) -> f64) -> f64 {
    let of = |(edge, forces): &(MemberEdge, Forces)| {
        let [from, to] = edge.place;
        what(forces, ((place - from) / (to - from)).clamp(0.0, 1.0))
    };
    let edges = || stress.members.iter().filter(|(edge, _)| edge.member == member);
    edges().find(|(edge, _)| place <= edge.place[1]).or_else(|| edges().next_back()).map_or(0.0, of)
}

fn axial(forces: &Forces, s: f64) -> f64 {
    at(&forces.axial, s)
}

/// What a row of bars takes from the soil: by what the force grows along the edge.
fn taken(edge: &MemberEdge, forces: &Forces, s: f64) -> f64 {
    slope(edge, &forces.axial, s)
}

/// What slip of a row of bars in the soil takes up and their forces do not match.
fn slipped(problem: &Problem, stress: &StressField, piece: &MemberVelocity) -> f64 {
    let MemberVelocity { edge, slip, .. } = piece;
    let Some(gripped) = edge.gripped(&problem.members()[edge.member]) else { return 0.0 };
    let [from, to] = gripped.most;
    let [a, b, c] = slip.map(f64::abs);
    let spent = edge.length() * (from * (3.0 * a + 2.0 * b + c) + to * (a + 2.0 * b + 3.0 * c)) / 12.0;
    stress.part * spent - work_of(stress, edge, taken, |s| at(slip, s))
}

fn moment(forces: &Forces, s: f64) -> f64 {
    forces.bent.map_or(0.0, |(moment, _)| cubic(&moment, s))
}

fn shear(forces: &Forces, s: f64) -> f64 {
    forces.bent.map_or(0.0, |(_, shear)| at(&shear, s))
}

/// Adds what members dissipate and their forces do not match: half of it to the triangle on each side.
pub(super) fn add_shares(
    problem: &Problem,
    velocity: &VelocityField,
    stress: &StressField,
    shares: &mut [f64],
) {
    let pieces = &velocity.members;
    for (i, piece) in pieces.iter().enumerate() {
        let MemberVelocity { edge, across, .. } = piece;
        let along = &piece.own();
        let m = &problem.members()[edge.member];
        let spent =
            |change: f64| stress.part * (m.tension * change.max(0.0) + m.compression * (-change).max(0.0));
        let [a, b, c] = *along;
        let force = |place: f64| borne(stress, edge.member, place, axial);
        let mut share = spent(b - a) + spent(c - b) - work(stress, edge, axial, |s| slope(edge, along, s));
        let jump = |change: f64, place: f64| spent(change) - change * force(place);
        share += slipped(problem, stress, piece);
        let is_of = |other: &&MemberVelocity| other.edge.member == edge.member;
        let next = pieces.get(i + 1).filter(is_of);
        let is_first = i.checked_sub(1).and_then(|i| pieces.get(i)).filter(is_of).is_none();
        if is_first && let Some(v) = end_of_member(problem, velocity, edge.member, 0) {
            share += jump(a - v, edge.place[0]);
        }
        match next {
            Some(next) => share += jump(next.own()[0] - c, edge.place[1]),
            None => {
                if let Some(v) = end_of_member(problem, velocity, edge.member, 1) {
                    share += jump(v - c, edge.place[1]);
                }
            }
        }
        if let Some(most) = m.bending {
            // What clamps an end is at rest.
            let clamp = m.attached[1].then_some((0.0, 0.0));
            let after = next.map(|next| (slope(&next.edge, &next.across, 0.0), next.across[0])).or(clamp);
            share += bent(most, edge, across, after, stress);
            if is_first && m.attached[0] {
                share += turned(most, edge, edge.place[0], [slope(edge, across, 0.0), across[0]], stress);
            }
        }
        let faces = edge.faces().count() as f64;
        for side in edge.faces() {
            shares[side.triangle] += share / faces;
        }
    }
}

/// The same of bending: virtual work demands `int M u'' + sum M [u'] - sum V [u]` with `u` the velocity across. Along an edge and from it to
/// what follows, whose slope and velocity there are given.
fn bent(
    most: Bending,
    edge: &MemberEdge,
    across: &[f64; 3],
    next: Option<(f64, f64)>,
    stress: &StressField,
) -> f64 {
    let [from, to] = [0.0, 1.0].map(|s| slope(edge, across, s));
    let curvature = (to - from) / edge.length();
    let within = stress.part * most.moment * (to - from).abs() - work(stress, edge, moment, |_| curvature);
    let to_next = next.map_or(0.0, |(turns, velocity)| {
        turned(most, edge, edge.place[1], [turns - to, velocity - across[2]], stress)
    });
    within + to_next
}

/// The same of a turn and a step at one place.
fn turned(most: Bending, edge: &MemberEdge, place: f64, [turn, step]: [f64; 2], stress: &StressField) -> f64 {
    let spent = stress.part * (most.moment * turn.abs() + most.shear * step.abs());
    spent - turn * borne(stress, edge.member, place, moment) + step * borne(stress, edge.member, place, shear)
}

/// Velocity along a member of what an end of it is attached to.
fn end_of_member(problem: &Problem, velocity: &VelocityField, member: usize, end: usize) -> Option<f64> {
    let Some(beam) = beam_at_end(problem, member, end) else { return velocity_at_end(problem, member, end) };
    let at = problem.member_ends(member)[end];
    let (t, [along, across]) = velocity.members.iter().filter(|piece| piece.edge.member == beam).find_map(
        |MemberVelocity { edge, along, across, .. }| {
            let i = if edge.ends[1] == at { 2 } else { 0 };
            (i == 2 || edge.ends[0] == at).then(|| (edge.along(), [along[i], across[i]]))
        },
    )?;
    let [from, to] = problem.member_ends(member);
    let d = between(from, to);
    let vector = [along * t[0] - across * t[1], along * t[1] + across * t[0]];
    Some(dot(vector, d) / length(d))
}

/// The slope of a quadratic velocity along an edge.
fn slope(edge: &MemberEdge, c: &[f64; 3], s: f64) -> f64 {
    2.0 * ((1.0 - s) * (c[1] - c[0]) + s * (c[2] - c[1])) / edge.length()
}

/// The integral of a force over a rate along an edge. Between the ends of edges of both meshes it is that of a cubic.
fn work(
    stress: &StressField,
    edge: &MemberEdge,
    what: impl Fn(&Forces, f64) -> f64,
    rate: impl Fn(f64) -> f64,
) -> f64 {
    work_of(stress, edge, |_, forces, s| what(forces, s), rate)
}

/// The same of what follows from a force on an edge of the stress field.
fn work_of(
    stress: &StressField,
    edge: &MemberEdge,
    what: impl Fn(&MemberEdge, &Forces, f64) -> f64,
    rate: impl Fn(f64) -> f64,
) -> f64 {
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
            on.map_or(0.0, |(other, forces)| {
                what(other, forces, (place - other.place[0]) / (other.place[1] - other.place[0]))
            })
        };
        let parts = [(1.0, p), (4.0, middle), (1.0, q)];
        let sum: f64 = parts.iter().map(|(w, s)| w / 6.0 * inner(*s) * rate((s - from) / (to - from))).sum();
        sum * (q - p)
    };
    cuts.windows(2).map(piece).sum()
}
