//! The edges of a region's triangles are either paired or cover the region's loops once, in the same sense.
//!
//! The boundaries of all triangles of a region add up to its loops then: paired edges cancel. So the number of triangles
//! over a point, all of them counter-clockwise, is the winding number of the loops around it, which is one inside the
//! region and zero outside.

use super::{Beyond, OnLine, OnMember, after, fraction};
use crate::CertificateError;
use crate::mesh::{Mesh, Place, Side};
use crate::problem::Problem;
use crate::statement::LineUse;

/// For each triangle, what its edges adjoin.
type Adjoined = Vec<[Beyond; 3]>;

/// For each triangle, the members on which its edges are.
type OnMembers = Vec<[Option<OnMember>; 3]>;

/// What each triangle edge adjoins, and the member that it is on.
pub(super) fn beyond(
    problem: &Problem,
    mesh: &Mesh,
    across: &[[Option<Side>; 3]],
) -> Result<(Adjoined, OnMembers), CertificateError> {
    let on_loops: Vec<[Option<OnLine>; 3]> = (0..mesh.triangles.len())
        .map(|triangle| [0, 1, 2].map(|corner| on_loop(problem, mesh, Side { triangle, corner })))
        .collect();
    let adjoins = |side: Side| {
        let bad = |problem| Err(CertificateError::BadMesh { place: side.to_string(), problem });
        let on = on_loops[side.triangle][side.corner];
        let Some(other) = across[side.triangle][side.corner] else {
            return match on.and_then(|on| Some(Beyond::Boundary(on, problem.condition(on.side)?))) {
                Some(boundary) => Ok(boundary),
                None => bad("not on a boundary, and no triangle beyond"),
            };
        };
        match (on, on_loops[other.triangle][other.corner]) {
            (Some(on), other_on) => match problem.condition(on.side) {
                Some(condition) => Ok(Beyond::Boundary(on, condition)),
                None if other_on.is_some() => Ok(Beyond::Soil(other)),
                None => bad("on an interface, but the triangle beyond is not of the region beyond"),
            },
            // Edges that cover no loop must cancel among themselves.
            (None, None) if same_region(mesh, side, other) => Ok(Beyond::Soil(other)),
            (None, _) => {
                bad("on no loop of its region, but the triangle beyond is across one or of another region")
            }
        }
    };
    let beyond = (0..mesh.triangles.len()).map(|triangle| {
        let of = |corner| adjoins(Side { triangle, corner });
        Ok([of(0)?, of(1)?, of(2)?])
    });
    let beyond = beyond.collect::<Result<_, _>>()?;
    let member = |on: &Option<OnLine>| on.and_then(|on| on_member(problem, on));
    let members = on_loops.iter().map(|edges| [0, 1, 2].map(|k| member(&edges[k]))).collect();
    check_cover(problem, on_loops.into_iter().flatten().flatten())?;
    Ok((beyond, members))
}

/// The place on a member of an edge of a line.
fn on_member(problem: &Problem, on: OnLine) -> Option<OnMember> {
    let piece = problem.piece(on.side.line)?;
    let is_left = piece.left == on.side;
    let first = if is_left { on.start } else { on.end };
    // Exactly, so that no two places are one.
    let order = if piece.left.forward { first } else { -first };
    let part = [on.start.min(on.end), on.start.max(on.end)];
    Some(OnMember { piece, is_left, place: (piece.number, order), part })
}

fn same_region(mesh: &Mesh, a: Side, b: Side) -> bool {
    mesh.triangles[a.triangle].region == mesh.triangles[b.triangle].region
}

/// The side of a line on which an edge lies, if its region has that on a loop.
fn on_loop(problem: &Problem, mesh: &Mesh, side: Side) -> Option<OnLine> {
    let t = mesh.triangles[side.triangle];
    let [a, b] = [1, 2].map(|i| mesh.vertices[t.corners[after(side.corner, i)]].place);
    let line = match (a, b) {
        (Place::OnLine { line, .. }, _) | (_, Place::OnLine { line, .. }) => line,
        (Place::Corner { point: p }, Place::Corner { point: q }) => problem.line_between(p, q)?,
        _ => return None,
    };
    let (start, end) = (fraction(problem, a, line)?, fraction(problem, b, line)?);
    let used = LineUse { line, forward: start < end };
    (problem.owner(used) == Some(t.region)).then_some(OnLine { side: used, start, end })
}

/// Checks that the edges on each side of a line that is on a loop cover it from end to end, once.
fn check_cover(problem: &Problem, edges: impl Iterator<Item = OnLine>) -> Result<(), CertificateError> {
    let mut covered: Vec<(LineUse, f64, f64)> =
        edges.map(|on| (on.side, on.start.min(on.end), on.start.max(on.end))).collect();
    covered.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut rest = covered.as_slice();
    for line in 0..problem.statement.lines.len() {
        // As `LineUse` is ordered.
        for forward in [false, true] {
            let used = LineUse { line, forward };
            let count = rest.iter().take_while(|c| c.0 == used).count();
            let (here, later) = rest.split_at(count);
            rest = later;
            let joined = here.windows(2).all(|w| w[0].2 == w[1].1);
            let whole = here.first().is_some_and(|c| c.1 == 0.0) && here.last().is_some_and(|c| c.2 == 1.0);
            if problem.owner(used).is_some() && !(joined && whole) {
                let sense = if forward { "forwards" } else { "backwards" };
                let place = format!("line {line} walked {sense}");
                let problem = "triangle edges do not cover it once from end to end";
                return Err(CertificateError::BadMesh { place, problem });
            }
        }
    }
    Ok(())
}
