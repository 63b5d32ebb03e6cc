//! Members: lines along which the slope of the stress function across may jump, by the axial force.
//!
//! Let `t` point along a member and `n` to its left. The function is the same on both sides, and so is its slope along `t`; the
//! slope along `n` is more on the left than on the right by the axial force `N`: what the stress along `t` adds up to across the
//! member. The tractions of the function on the soil on both sides then add up to `t dN/ds`, which the member takes from there
//! along itself, and nothing across.
//! The slope across an edge is quadratic, and so is `N`: it is within its limits if its three Bernstein coefficients are.
//! An end that is not attached has `N = 0`; one that is attached to the structure hands `N` to it.
//!
//! A row of bars between which the soil goes on takes `dN/ds` from it, linear along an edge, which its resistance limits. It has no faces. Where
//! there is no resistance, nor is it proven to be there all along an edge, `N` does not change: both kinks there are one and the same
//! number, and the slope across the middle on the right is not read but follows.

use super::{StressFunction, ends};
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::problem::{Attached, Gripped, Problem, Stress};
use crate::tiling::{MemberEdge, OnMember, after};

use super::loads::Station;

/// What the slope across, to the left of the member, is more on the left than on the right: at a copy on its left and one on its right,
/// over the length of the line's vector, with that vector; nothing if that is not known to be all by which the jets there differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kink {
    jump: Interval,
    line: Option<usize>,
}

impl Kink {
    /// Whether it is another one exactly, so that the member bears the same force.
    fn is_same(&self, other: &Self) -> bool {
        let is_none = |kink: &Self| kink.jump.is_zero();
        let is_one =
            self.line == other.line && (self.jump.lo(), self.jump.hi()) == (other.jump.lo(), other.jump.hi());
        is_one || (is_none(self) && is_none(other))
    }
}

/// The kink between two copies of a vertex on a member, if their jets differ by no more than such a jump.
pub(super) fn kink(
    problem: &Problem,
    field: &LowerField,
    stations: &[Option<Station>],
    on: &OnMember,
    [left, right]: [usize; 2],
) -> Option<Kink> {
    let none = Kink { jump: Interval::ZERO, line: None };
    if left == right {
        return Some(none);
    }
    let [l, r] = [left, right].map(|copy| field.copies[copy]);
    if l.vertex != r.vertex {
        return None;
    }
    // The line's own normal may point to the right of the member.
    let of = |line: usize, jump: f64, sign: f64| {
        let piece = problem.piece(line).filter(|p| p.member == on.piece.member)?;
        let sense = if piece.left.forward { sign } else { -sign };
        Some(Kink { jump: Interval::point(sense * jump), line: Some(line) })
    };
    match (l.jet, r.jet) {
        (Jet::Kinked { copy, line, jump }, _) if copy == right => of(line, jump, 1.0),
        (_, Jet::Kinked { copy, line, jump }) if copy == left => of(line, jump, -1.0),
        (Jet::Gauge { gauge: a }, Jet::Gauge { gauge: b }) => {
            (a == b && stations[left].is_some() && stations[left] == stations[right]).then_some(none)
        }
        // Beyond one and the same polynomial, which is checked where surfaces are known.
        (Jet::Zero { base: a }, Jet::Zero { base: b }) => (a == b).then_some(none),
        _ => None,
    }
}

/// An edge of a member in words.
pub(super) fn place(edge: &MemberEdge) -> String {
    let side = edge.first().map_or_else(String::new, |side| format!(", {side}"));
    format!("member {}{side}", edge.member())
}

/// What a member bears along an edge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SectionForces {
    /// The axial force: its Bernstein coefficients.
    pub(crate) axial: [Interval; 3],
    /// Of a beam, what it bears by bending.
    pub(crate) bent: Option<Bent>,
}

/// Bernstein coefficients of what a beam bears by bending.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bent {
    pub(crate) moment: [Interval; 4],
    pub(crate) shear: [Interval; 3],
}

impl StressFunction<'_> {
    /// Checks the forces in all members and what their faces bear, given the stresses of each triangle. Returns the power of what
    /// is attached to the structure.
    pub(super) fn check_members(
        &self,
        stresses: impl Fn(usize) -> [[Stress; 3]; 3],
    ) -> Result<Interval, CertificateError> {
        let mut power = Interval::ZERO;
        let edges = self.tiling.along_members();
        for (i, edge) in edges.iter().enumerate() {
            let member = edge.member();
            let forces = self.section_forces(edge)?;
            self.check_force(edge, forces.axial)?;
            self.check_grip(edge, forces.axial)?;
            if let Some(bent) = forces.bent {
                self.check_bending(edge, bent)?;
            }
            for (face, side) in edge.sides.into_iter().enumerate() {
                let Some(side) = side else { continue };
                self.check_bond(side, &stresses(side.triangle)[side.corner], member, face)?;
            }
            let is_other =
                |j: Option<usize>| j.and_then(|j| edges.get(j)).is_none_or(|next| next.member() != member);
            let [a, _, b] = forces.axial;
            for (end, is_end, force) in
                [(false, is_other(i.checked_sub(1)), a), (true, is_other(Some(i + 1)), b)]
            {
                if is_end {
                    power = power + self.check_end(edge, end, force)?;
                }
            }
        }
        Ok(power)
    }

    /// What the start or the end of a member does on what it is attached to.
    fn check_end(&self, edge: &MemberEdge, end: bool, force: Interval) -> Result<Interval, CertificateError> {
        let member = edge.member();
        match self.problem.end_of(member, end)? {
            Attached::Ground | Attached::Beam(_) => return Ok(Interval::ZERO),
            Attached::Structure => {
                let velocity = self.problem.velocity_at_end(member, end)?.unwrap_or(Interval::ZERO);
                // The structure pulls the start backwards.
                return Ok(if end { force * velocity } else { -(force * velocity) });
            }
            Attached::Nothing => {}
        }
        let is_free =
            if self.problem.bends(member) { self.beam_edge(edge)?.ends_free(end) } else { force.is_zero() };
        if is_free {
            return Ok(Interval::ZERO);
        }
        let problem = "an end that is attached to nothing must bear no force";
        Err(CertificateError::BadField { place: format!("member {member}"), problem })
    }

    /// The forces in all members, edge by edge.
    pub(super) fn member_forces(&self) -> Result<Vec<SectionForces>, CertificateError> {
        self.tiling.along_members().iter().map(|edge| self.section_forces(edge)).collect()
    }

    fn section_forces(&self, edge: &MemberEdge) -> Result<SectionForces, CertificateError> {
        if self.problem.bends(edge.member()) {
            return Ok(self.beam_edge(edge)?.forces());
        }
        match edge.both() {
            Some([side, other]) => {
                Ok(SectionForces { axial: self.axial_force(side, other, &edge.on)?, bent: None })
            }
            None => Err(CertificateError::BadField {
                place: format!("member {}", edge.member()),
                problem: "there must be soil on both sides of it",
            }),
        }
    }

    /// The axial force of a member along an edge on its left: its Bernstein coefficients.
    fn axial_force(&self, side: Side, other: Side, on: &OnMember) -> Result<[Interval; 3], CertificateError> {
        let [start, end] = ends(self.field, side);
        let [other_end, other_start] = ends(self.field, other);
        let kinks = self.kinks(side, other, on).filter(|_| {
            [(start, other_start), (end, other_end)]
                .into_iter()
                .all(|(left, right)| self.jets[left].surface == self.jets[right].surface)
        });
        let Some(kinks) = kinks else {
            let problem = "the stress function is not proven to be the same on both sides of the member";
            return Err(CertificateError::BadField { place: side.to_string(), problem });
        };
        let [a, b] = kinks.map(|kink| {
            let length =
                kink.line.map_or(Interval::ZERO, |line| self.problem.direction(line).square().sqrt());
            kink.jump * length
        });
        let corners = self.tiling.corners(side.triangle);
        let edge = corners[after(side.corner, 2)] - corners[after(side.corner, 1)];
        let slope = |side: Side| Interval::point(self.field.slopes[side.triangle][side.corner]);
        let apex = |copy: usize| self.apexes[copy];
        if [start, end].map(apex) != [other_start, other_end].map(apex) {
            let what = "a member that meets free ground without cohesion on one side only";
            return Err(CertificateError::NotCovered { place: side.to_string(), what });
        }
        if self.is_free(on) {
            if !kinks[0].is_same(&kinks[1]) {
                let problem = "the force in a bar must not change where the soil hands it none";
                return Err(CertificateError::BadField { place: side.to_string(), problem });
            }
            // The slope across on its right is what makes it so.
            return Ok([a; 3]);
        }
        if apex(start) || apex(end) {
            // Next to an apex stored slopes are not used. Those across, beyond a cubic that is known to second order at the apex, grow
            // with the square of the distance from it, up to that at the other end, which is one on both sides.
            return Ok([a, Interval::ZERO, b]);
        }
        // That on the right is along the vector turned right.
        let middle = (slope(side) + slope(other)) / edge.square().sqrt();
        Ok([a, Interval::point(2.0) * middle - (a + b).half(), b])
    }

    /// The kinks at the start and the end of an edge on a member's left, if the jets there differ by no more.
    fn kinks(&self, side: Side, other: Side, on: &OnMember) -> Option<[Kink; 2]> {
        let [start, end] = ends(self.field, side);
        let [other_end, other_start] = ends(self.field, other);
        let at = |pair: [usize; 2]| kink(self.problem, self.field, &self.stations, on, pair);
        Some([at([start, other_start])?, at([end, other_end])?])
    }

    /// Whether soil hands a bar no force along an edge, or is not proven to be able to along all of it.
    fn is_free(&self, on: &OnMember) -> bool {
        matches!(self.problem.gripped(on), Some(Gripped::Free | Gripped::Partly(_)))
    }

    /// Where soil hands a bar no force, the slope across the middle of an edge on its right follows from that on its left and the
    /// force, which is one along the edge: along the edge's vector turned left, which is the other way round on the right. Nothing elsewhere.
    pub(super) fn slope_beside_bar(&self, side: Side, other: Side, on: &OnMember) -> Option<Interval> {
        if on.is_left || !self.is_free(on) {
            return None;
        }
        let [kink, _] = self.kinks(other, side, on)?;
        let left = Interval::point(self.field.slopes[other.triangle][other.corner]);
        let along = self.along(other);
        let force = kink.line.map_or(Interval::ZERO, |line| {
            let by = self.problem.direction(line).dot(along);
            kink.jump * if self.problem.piece(line).is_some_and(|p| p.left.forward) { by } else { -by }
        });
        Some(force - left)
    }

    /// The edge of a triangle as a vector.
    fn along(&self, side: Side) -> Vector {
        let corners = self.tiling.corners(side.triangle);
        corners[after(side.corner, 2)] - corners[after(side.corner, 1)]
    }

    /// Checks that a row of bars takes no more from the soil along an edge than it can: its force is quadratic there, so what it takes is
    /// linear, as its resistance is.
    fn check_grip(&self, edge: &MemberEdge, [a, b, c]: [Interval; 3]) -> Result<(), CertificateError> {
        // Where there is no resistance the force is one by construction.
        let Some(Gripped::Whole(resistance)) = self.problem.gripped(&edge.on) else { return Ok(()) };
        let [start, end] = self.tiling.ends_on_member(edge);
        let half = (end - start).square().sqrt().half();
        for (node, (taken, resistance)) in [b - a, c - b].into_iter().zip(resistance).enumerate() {
            let most = self.divisor.part(resistance) * half;
            if let Some(spare) = [most - taken, most + taken].into_iter().find(|s| !s.is_at_least_zero()) {
                return Err(CertificateError::NotProven {
                    quantity: "pullout resistance of the bar to spare, times half the length of the edge,",
                    place: format!("{}, {}", place(edge), ["its start", "its end"][node]),
                    low: spare.lo(),
                    unit: "force",
                });
            }
        }
        Ok(())
    }

    fn check_force(&self, edge: &MemberEdge, coefficients: [Interval; 3]) -> Result<(), CertificateError> {
        let member = edge.member();
        let m = &self.problem.statement.members[member];
        let [tension, compression] =
            [m.tension, m.compression].map(|force| self.divisor.part(Interval::point(force)));
        for (i, force) in coefficients.into_iter().enumerate() {
            for (quantity, spare) in [
                ("tension of the member to spare", tension - force),
                ("compression of the member to spare", compression + force),
            ] {
                if !spare.is_at_least_zero() {
                    let place = format!("{}, control point {i} of 3", place(edge));
                    let (low, unit) = (spare.lo(), "force");
                    return Err(CertificateError::NotProven { quantity, place, low, unit });
                }
            }
        }
        Ok(())
    }

    /// Checks that the traction of the soil on a member's face is one that the face can bear; it is linear along the edge, and so are
    /// cohesion and pore pressure. What bears as much as the soil needs no check.
    fn check_bond(
        &self,
        side: Side,
        part: &[Stress; 3],
        member: usize,
        face: usize,
    ) -> Result<(), CertificateError> {
        let bond = self.problem.statement.members[member].bond;
        if bond == 1.0 {
            return Ok(());
        }
        let corners = self.tiling.corners(side.triangle);
        let [start, end] = [1, 2].map(|i| corners[after(side.corner, i)]);
        let t: Vector = end - start;
        for (node, (stress, p)) in part.iter().zip([start, end]).enumerate() {
            let limit = self.limit(side.triangle, p);
            let effective = stress.with_mean(limit.pore_pressure);
            // Times the square of the edge's length.
            let normal = effective.between(t.turned(), t.turned());
            let shear = stress.between(t, t.turned());
            let part = |bears: Interval| Interval::point(bond) * bears;
            let mut spares = (limit.shear_strengths(normal, t))
                .flat_map(|[forwards, backwards]| [part(forwards) - shear, part(backwards) + shear]);
            if let Some(spare) = spares.find(|s| !s.is_at_least_zero()) {
                let (face, node) = (["left", "right"][face], ["its start", "its end"][node]);
                return Err(CertificateError::NotProven {
                    quantity: "grip of the member to spare, times the square of the edge's length,",
                    place: format!("member {member}, {face} face, {side}, {node}"),
                    low: spare.lo(),
                    unit: "force",
                });
            }
        }
        Ok(())
    }
}
