//! Members are straight, lie in soil, and keep apart from each other.

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
        let mut on: Vec<Option<usize>> = vec![None; statement.points.len()];
        for (member, m) in statement.members.iter().enumerate() {
            self.check_path(member, m)?;
            for (number, left) in m.path.iter().copied().enumerate() {
                if pieces[left.line].replace(Piece { member, number, left }).is_some() {
                    return Err(bad(member, "a line belongs to a member only once"));
                }
                for point in statement.lines[left.line].walked(left.forward) {
                    if on[point].is_some_and(|other| other != member) {
                        return Err(not_covered(member, "members that meet"));
                    }
                    on[point] = Some(member);
                }
            }
            for end in [false, true] {
                self.end_of(member, end)?;
            }
        }
        Ok(pieces)
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
            for side in [*side, side.reversed()] {
                if self.owner(side).is_none() || self.condition(side).is_some() {
                    return Err(bad(member, "there must be soil, and no boundary, on both sides of it"));
                }
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
            let point = walked(side)[0];
            if self.boundaries_at(point).next().is_some() {
                return Err(not_covered(member, "a member that touches a boundary between its ends"));
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
        if !m.attached[usize::from(end)] {
            return Ok(Attached::Nothing);
        }
        let (point, direction) = self.member_end(member, end);
        let mut found = Attached::Nothing;
        for (line, condition) in self.boundaries_at(point) {
            let here = match condition {
                Condition::Free | Condition::Loaded { .. } | Condition::Submerged => continue,
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
        if found == Attached::Nothing {
            return Err(bad(member, "an end is attached, but there is nothing that it could be attached to"));
        }
        Ok(found)
    }

    /// The point at the start or the end of a member, and the direction of its line there, from its start to its end.
    fn member_end(&self, member: usize, end: bool) -> (usize, Vector) {
        let path = &self.statement.members[member].path;
        let side = path[if end { path.len() - 1 } else { 0 }];
        let d = self.direction(side.line);
        let ends = self.statement.lines[side.line].walked(side.forward);
        (ends[usize::from(end)], if side.forward { d } else { -d })
    }

    /// Velocity along a member of what its start or its end is attached to; nothing if it is not attached.
    pub(crate) fn velocity_at_end(
        &self,
        member: usize,
        end: bool,
    ) -> Result<Option<Interval>, CertificateError> {
        Ok(match self.end_of(member, end)? {
            Attached::Nothing => None,
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
