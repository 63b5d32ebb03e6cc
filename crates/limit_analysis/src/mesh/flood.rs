//! Which region a triangle is in: flood fill across edges that are not on lines.

use spade::Triangulation;
use spade::handles::FixedDirectedEdgeHandle;

use super::triangulation::Cdt;

/// What is on the left of a directed edge: `None` if the edge is on no line, `Some(None)` for the outside.
pub(super) type Claim = Option<Option<usize>>;

/// Two edges around one piece of ground claim it for two regions.
pub(super) struct Conflict {
    pub(super) edges: [FixedDirectedEdgeHandle; 2],
    pub(super) regions: [Option<usize>; 2],
}

/// The region of every face, by face index (index 0 is the unbounded face). `left_of` tells what lines claim.
pub(super) fn flood(
    cdt: &Cdt,
    left_of: impl Fn(FixedDirectedEdgeHandle) -> Claim,
) -> Result<Vec<Option<usize>>, Conflict> {
    let mut region = vec![None; cdt.num_all_faces()];
    let mut seen = vec![false; cdt.num_all_faces()];
    let mut patch = Vec::new();
    for start in cdt.inner_faces() {
        if seen[start.index()] {
            continue;
        }
        seen[start.index()] = true;
        patch.clear();
        patch.push(start.fix());
        let mut claim: Option<(FixedDirectedEdgeHandle, Option<usize>)> = None;
        let mut next = 0;
        while next < patch.len() {
            for edge in cdt.face(patch[next]).adjacent_edges() {
                let found = if edge.rev().is_outer_edge() { Some(None) } else { left_of(edge.fix()) };
                if let Some(found) = found {
                    match claim {
                        None => claim = Some((edge.fix(), found)),
                        Some((first, other)) if other != found => {
                            return Err(Conflict { edges: [first, edge.fix()], regions: [other, found] });
                        }
                        Some(_) => {}
                    }
                } else if let Some(neighbour) = edge.rev().face().as_inner()
                    && !seen[neighbour.index()]
                {
                    seen[neighbour.index()] = true;
                    patch.push(neighbour.fix());
                }
            }
            next += 1;
        }
        if let Some((_, found)) = claim {
            patch.iter().for_each(|face| region[face.index()] = found);
        }
    }
    Ok(region)
}
