//! Soil without friction that slips along edges which end at the toe of a wall.
//!
//! Where a wall moves on ground that does not, the soil at its toe has all velocities between both, so a stream function has several
//! slopes there, one for each of the triangles around. Across the edge between two of them its value and its slope along the edge are the same,
//! by construction, so the velocity across the edge, minus the derivative of a cubic along it, is one on both sides; the velocity along it jumps, and what
//! that dissipates is counted with all other jumps.

use super::VelocityField;
use super::jets::StreamValue;
use super::walls::{Walls, way};
use crate::CertificateError;
use crate::fields::{Flow, StreamJet, UpperField};
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::problem::Problem;
use crate::tiling::{Tiling, after};

/// Most copies that depend on each other one after the other.
const MOST: usize = 64;

/// Value and slopes of a copy, given those of all that slip nowhere.
pub(super) fn value(
    problem: &Problem,
    tiling: &Tiling,
    field: &UpperField,
    walls: &Walls,
    others: &[StreamValue],
    copy: usize,
) -> Result<StreamValue, CertificateError> {
    let bad =
        |copy: usize, problem| CertificateError::BadField { place: format!("vertex copy {copy}"), problem };
    // From this copy to that on which all depend, with the vertex towards which each slips and, but at walls, its jump.
    let mut chain = Vec::new();
    let mut at = copy;
    while let Some((next, towards, jump)) = slips_from(field.stream[at].jet) {
        if chain.len() == MOST {
            return Err(bad(copy, "it depends on too many copies, or on itself"));
        }
        if field.stream[next].vertex != field.stream[at].vertex {
            return Err(bad(at, "it must depend on a copy of the same vertex"));
        }
        chain.push((at, towards, jump));
        at = next;
    }
    let root = at;
    let mut known = others[root];
    for (at, towards, jump) in chain.into_iter().rev() {
        let along = tiling.position(towards) - tiling.position(field.stream[at].vertex);
        known = match jump {
            Some(jump) => {
                StreamValue { slopes: known.slopes + along.turned() * Interval::point(jump), ..known }
            }
            None => at_wall(problem, field, walls, [at, root], along, known)
                .map_err(|problem| bad(at, problem))?,
        };
    }
    Ok(known)
}

/// The copy from which one slips, the vertex towards which it does, and, but at walls, its jump.
fn slips_from(jet: StreamJet) -> Option<(usize, usize, Option<f64>)> {
    match jet {
        StreamJet::Slip { copy, towards, jump } => Some((copy, towards, Some(jump))),
        StreamJet::SlipAtWall { copy, towards } => Some((copy, towards, None)),
        StreamJet::Free { .. }
        | StreamJet::Wall { .. }
        | StreamJet::Kinked { .. }
        | StreamJet::Corner { .. } => None,
    }
}

/// Value and slopes of a copy on a wall that slips along an edge, given those on the other side of the edge and the copy on which these depend.
fn at_wall(
    problem: &Problem,
    field: &UpperField,
    walls: &Walls,
    [at, root]: [usize; 2],
    along: Vector,
    beside: StreamValue,
) -> Result<StreamValue, &'static str> {
    let place = field.mesh.vertices[field.stream[at].vertex].place;
    let ([Some(own), None], [Some(of_root), None]) = (walls.at(at), walls.at(root)) else {
        return Err("it and the copy on which it depends must each be on one side of a wall");
    };
    if !own.leads_to(problem, &of_root, place) && !of_root.leads_to(problem, &own, place) {
        return Err("the copy on which it depends must be on the next side of the wall");
    }
    let s = way(problem, place, &own).ok_or("it is not on the line of its wall")?;
    let value = Interval::point(field.walls[own.wall]) + own.value(problem, s);
    // Slopes with these products along the wall and along the edge.
    let (p, a) = (problem.direction(own.side.line), own.flow(problem));
    let (q, b) = (along, beside.slopes.dot(along));
    let area = p.cross(q);
    if !area.is_not_zero() {
        return Err("its edge is not proven to have another direction than its wall");
    }
    Ok(StreamValue { value, slopes: (p.turned() * b - q.turned() * a) * (Interval::ONE / area) })
}

impl VelocityField<'_> {
    /// Whether the velocity across an edge is one on both sides, exactly: at each end both have one copy, or one that slips along this edge
    /// from the other's.
    pub(super) fn slips_along(&self, side: Side, other: Side) -> bool {
        let flows = [side, other].map(|s| self.field.flows[s.triangle]);
        let [Flow::Stream { corners: here, .. }, Flow::Stream { corners: there, .. }] = flows else {
            return false;
        };
        let pairs =
            [(1, 2), (2, 1)].map(|(i, j)| (here[after(side.corner, i)], there[after(other.corner, j)]));
        let ends = pairs.map(|(copy, _)| self.field.stream[copy].vertex);
        let slips = |own: usize, base: usize, end: usize| {
            slips_from(self.field.stream[own].jet)
                .is_some_and(|(copy, towards, _)| copy == base && towards == end)
        };
        [(pairs[0], ends[1]), (pairs[1], ends[0])]
            .into_iter()
            .all(|((a, b), far)| a == b || slips(a, b, far) || slips(b, a, far))
    }
}
