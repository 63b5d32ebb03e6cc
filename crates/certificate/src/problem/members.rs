//! Members are straight, lie in soil or along it, and keep apart from each other, but where one is attached to a beam.

use super::Problem;
use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::statement::{Condition, LineUse, Member};

/// A line as a part of a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    pub(crate) member: usize,
    /// The place of the line on the member's path.
    pub(crate) number: usize,
    /// The side on the member's left.
    pub(crate) left: LineUse,
}

/// What an end is attached to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Attached {
    Nothing,
    /// Something at rest.
    Ground,
    Structure,
    /// The beam of this index.
    Beam(usize),
}

fn bad(member: usize, problem: &'static str) -> CertificateError {
    CertificateError::BadStatement { place: format!("member {member}"), problem }
}

fn not_covered(member: usize, what: &'static str) -> CertificateError {
    CertificateError::NotCovered { place: format!("member {member}"), what }
}

impl Problem<'_> {
    /// For each line, the member that it is a piece of. Checks all members; nothing of them has been looked at but that numbers and
    /// indices are in range.
    pub(super) fn pieces_of_members(&self) -> Result<Vec<Option<Piece>>, CertificateError> {
        let statement = self.statement;
        let mut pieces: Vec<Option<Piece>> = vec![None; statement.lines.len()];
        let mut on: Vec<Vec<usize>> = vec![Vec::new(); statement.points.len()];
        for (member, m) in statement.members.iter().enumerate() {
            self.check_path(member, m)?;
            for (number, left) in m.path.iter().copied().enumerate() {
                if pieces[left.line].replace(Piece { member, number, left }).is_some() {
                    return Err(bad(member, "a line belongs to a member only once"));
                }
                for point in statement.lines[left.line].walked(left.forward) {
                    if !on[point].contains(&member) {
                        on[point].push(member);
                    }
                }
            }
        }
        for (point, here) in on.iter().enumerate().filter(|(_, here)| here.len() > 1) {
            let ends = |member: usize| [false, true].map(|end| self.member_end(member, end).0);
            let mut loose = here.iter().copied().filter(|member| !self.bends(*member));
            if loose.clone().count() + 1 != here.len() || loose.any(|member| !ends(member).contains(&point)) {
                return Err(not_covered(here[1], "members that meet, other than with an end at a beam"));
            }
        }
        for (i, boundary) in statement.boundaries.iter().enumerate() {
            let on_beam = || pieces[boundary.line].is_some_and(|piece| self.bends(piece.member));
            if matches!(boundary.condition, Condition::Lined { .. }) && !on_beam() {
                let (place, problem) = (format!("boundary {i}"), "it is lined by no member that bends");
                return Err(CertificateError::BadStatement { place, problem });
            }
        }
        for member in 0..statement.members.len() {
            for end in [false, true] {
                self.end_of(member, end)?;
            }
        }
        Ok(pieces)
    }

    /// Whether a member is a beam.
    pub(crate) fn bends(&self, member: usize) -> bool {
        self.statement.members[member].bending.is_some()
    }

    fn check_path(&self, member: usize, m: &Member) -> Result<(), CertificateError> {
        let statement = self.statement;
        let walked = |side: &LineUse| statement.lines[side.line].walked(side.forward);
        if m.path.is_empty() {
            return Err(bad(member, "its path has no line"));
        }
        if m.path.windows(2).any(|w| walked(&w[0])[1] != walked(&w[1])[0]) {
            return Err(bad(member, "each line of its path must start where the one before ends"));
        }
        for side in &m.path {
            let sides = [*side, side.reversed()];
            let is_inside = sides.iter().all(|s| self.owner(*s).is_some() && self.condition(*s).is_none());
            let is_lined = |side: LineUse| {
                matches!(self.condition(side), Some(Condition::Lined { .. }))
                    && self.owner(side.reversed()).is_none()
            };
            if m.bending.is_some() && !is_inside && !sides.into_iter().any(is_lined) {
                return Err(bad(member, "a beam must have soil on both sides of it, or line soil on one"));
            }
            if m.bending.is_none() && !is_inside {
                return Err(bad(member, "there must be soil, and no boundary, on both sides of it"));
            }
        }
        let along = |side: &LineUse| {
            let d = self.direction(side.line);
            if side.forward { d } else { -d }
        };
        let first = along(&m.path[0]);
        let in_line = |side: &LineUse| {
            let d = along(side);
            (first.x.is_zero() && d.x.is_zero() && (d.y * first.y).is_positive())
                || (first.y.is_zero() && d.y.is_zero() && (d.x * first.x).is_positive())
        };
        if m.path.len() > 1 && !m.path.iter().all(in_line) {
            return Err(not_covered(member, "a member of several lines that is neither level nor upright"));
        }
        for side in &m.path[1..] {
            let mut met = self.boundaries_at(walked(side)[0]);
            if met.any(|(_, condition)| m.bending.is_none() || !condition.is_loaded()) {
                return Err(not_covered(
                    member,
                    "a member that touches a boundary between its ends, or a beam that does so where the ground is not free or loaded",
                ));
            }
        }
        Ok(())
    }

    /// Conditions on boundary sides that start or end at a point, each with its line.
    fn boundaries_at(&self, point: usize) -> impl Iterator<Item = (usize, Condition)> {
        let statement = self.statement;
        let here = move |line: usize| statement.lines[line].touches(point);
        statement.boundaries.iter().filter(move |b| here(b.line)).map(|b| (b.line, b.condition))
    }

    /// What the start or the end of a member is attached to. Checks that this may be.
    pub(crate) fn end_of(&self, member: usize, end: bool) -> Result<Attached, CertificateError> {
        let m = &self.statement.members[member];
        let (point, direction) = self.member_end(member, end);
        if m.bending.is_some() {
            return self.end_of_beam(member, point, m.attached[usize::from(end)]);
        }
        if !m.attached[usize::from(end)] {
            return Ok(Attached::Nothing);
        }
        let mut found = Attached::Nothing;
        for (line, condition) in self.boundaries_at(point) {
            let here = match condition {
                Condition::Free
                | Condition::Loaded { .. }
                | Condition::Lined { .. }
                | Condition::Submerged => {
                    continue;
                }
                Condition::Face { .. } => Attached::Structure,
                Condition::Fixed | Condition::Smooth => Attached::Ground,
                Condition::Far => return Err(not_covered(member, "an end attached to a far line")),
            };
            let t = self.direction(line);
            let is_square =
                (direction.x.is_zero() && t.y.is_zero()) || (direction.y.is_zero() && t.x.is_zero());
            if condition.shear_is_given() && !is_square {
                let what =
                    "an end attached to a line of given shear that is not proven to be at right angles";
                return Err(not_covered(member, what));
            }
            if found != Attached::Nothing && found != here {
                return Err(not_covered(
                    member,
                    "an end attached both to the structure and to what is at rest",
                ));
            }
            found = here;
        }
        match (found, self.beam_at(point)) {
            (found, None) if found != Attached::Nothing => Ok(found),
            (Attached::Nothing, Some(beam)) => {
                let is_end = [false, true].into_iter().any(|end| self.member_end(beam, end).0 == point);
                let what = "an end attached to the very end of a beam";
                if is_end { Err(not_covered(member, what)) } else { Ok(Attached::Beam(beam)) }
            }
            (_, Some(_)) => Err(not_covered(member, "an end attached both to a beam and to a boundary")),
            (_, None) => {
                Err(bad(member, "an end is attached, but there is nothing that it could be attached to"))
            }
        }
    }

    /// What an end of a beam at a point is attached to. There it is clamped, or it ends in soil or where the ground is free or loaded.
    fn end_of_beam(
        &self,
        member: usize,
        point: usize,
        is_attached: bool,
    ) -> Result<Attached, CertificateError> {
        let mut held = self.boundaries_at(point).map(|(_, condition)| condition).filter(|c| !c.is_loaded());
        match (is_attached, held.next()) {
            (false, None) => Ok(Attached::Nothing),
            (true, Some(Condition::Fixed)) if held.all(|c| c == Condition::Fixed) => Ok(Attached::Ground),
            (false, Some(_)) => {
                Err(not_covered(member, "an end of a beam that is not attached, at what holds the soil"))
            }
            (true, _) => Err(not_covered(member, "an end of a beam attached to anything but a fixed side")),
        }
    }

    /// The beam that goes through a point.
    fn beam_at(&self, point: usize) -> Option<usize> {
        let touches = |side: &LineUse| self.statement.lines[side.line].touches(point);
        self.statement.members.iter().position(|m| m.bending.is_some() && m.path.iter().any(touches))
    }

    /// The point at the start or the end of a member, and the direction of its line there, from its start to its end.
    fn member_end(&self, member: usize, end: bool) -> (usize, Vector) {
        let path = &self.statement.members[member].path;
        let side = path[if end { path.len() - 1 } else { 0 }];
        let d = self.direction(side.line);
        let ends = self.statement.lines[side.line].walked(side.forward);
        (ends[usize::from(end)], if side.forward { d } else { -d })
    }

    /// The point at the start or the end of a member.
    pub(crate) fn member_end_point(&self, member: usize, end: bool) -> usize {
        self.member_end(member, end).0
    }

    /// Unit vector along a member.
    pub(crate) fn along_member(&self, member: usize) -> Vector {
        let d = self.member_end(member, false).1;
        d * (Interval::ONE / d.square().sqrt())
    }

    /// Velocity along a member of what its start or its end is attached to; nothing if it is not attached, or to a beam.
    pub(crate) fn velocity_at_end(
        &self,
        member: usize,
        end: bool,
    ) -> Result<Option<Interval>, CertificateError> {
        Ok(match self.end_of(member, end)? {
            Attached::Nothing | Attached::Beam(_) => None,
            Attached::Ground => Some(Interval::ZERO),
            Attached::Structure => {
                let (_, d) = self.member_end(member, end);
                let velocity = Vector::point(self.statement.objective.velocity());
                Some(if velocity.is_zero() { Interval::ZERO } else { velocity.dot(d) / d.square().sqrt() })
            }
        })
    }

    /// The piece of a member that a line is.
    pub(crate) fn piece(&self, line: usize) -> Option<Piece> {
        self.pieces.get(line).copied().flatten()
    }
}
