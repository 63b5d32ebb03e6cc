//! What rows of bars take from the soil along an edge.

use super::Problem;
use crate::interval::Interval;
use crate::statement::Grip;
use crate::tiling::OnMember;

/// The resistance to slip of a row of bars along an edge.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Gripped {
    /// There is none on the whole edge.
    Free,
    /// There is some on a part of the edge, and nowhere more than this at the start and the end as the member goes, linear between.
    Partly([Interval; 2]),
    /// It is this at the start and the end, linear between.
    Whole([Interval; 2]),
}

impl Problem<'_> {
    /// What a row of bars takes from the soil along an edge; nothing of sheets and beams, which have faces.
    pub(crate) fn gripped(&self, on: &OnMember) -> Option<Gripped> {
        let grips = self.statement.members[on.piece.member].pullout.as_ref()?;
        let Grip { resistance, part } = *grips.get(on.piece.number)?;
        let [from, to] = resistance.map(Interval::point);
        let mut at_ends = on.part.map(|s| (from + (to - from) * Interval::point(s)).or_zero());
        if !on.piece.left.forward {
            at_ends.reverse();
        }
        let [start, end] = on.part;
        // Fractions are numbers of the statement and of the mesh, so comparing them is exact.
        Some(if resistance == [0.0; 2] || end <= part[0] || start >= part[1] {
            Gripped::Free
        } else if part[0] <= start && end <= part[1] {
            Gripped::Whole(at_ends)
        } else {
            Gripped::Partly(at_ends)
        })
    }
}
