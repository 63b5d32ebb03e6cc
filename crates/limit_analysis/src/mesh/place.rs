//! Puts fans into the mesh before it is triangulated.

use super::MeshError;
use super::fan::Disc;
use super::wanted::Wanted;
use super::work::{Held, Kind, Node};
use crate::vector::{Point, distance};

/// Adds the vertices of a fan and returns its edges. `corner` is the node of its corner, and `first` that of the first
/// vertex after the corner on a line, which is at the fan's radius, by the line and whether it starts at the corner.
pub(super) fn place(
    disc: &Disc,
    wanted: &Wanted,
    nodes: &mut Vec<Node>,
    corner: usize,
    first: impl Fn((usize, bool)) -> usize,
) -> Result<Held, MeshError> {
    let mut held = Held::new();
    for sector in &disc.sectors {
        let spokes = sector.spokes(disc.angle);
        let mut ring = Vec::with_capacity(spokes.len());
        for (i, spoke) in spokes.iter().enumerate() {
            let end = if i == 0 {
                first(sector.lines[0])
            } else if i + 1 == spokes.len() {
                first(sector.lines[1])
            } else {
                let at: Point = disc.end(sector, spoke.turn);
                nodes.push(Node { at, kind: Kind::Guide(sector.region), size: wanted.at(at)? });
                nodes.len() - 1
            };
            ring.push(end);
            held.insert([corner.min(end), corner.max(end)], spoke.guide);
        }
        for pair in ring.windows(2) {
            let chord = distance(nodes[pair[0]].at, nodes[pair[1]].at);
            for &node in pair {
                nodes[node].size = nodes[node].size.min(chord);
            }
            held.insert([pair[0].min(pair[1]), pair[0].max(pair[1])], false);
        }
    }
    Ok(held)
}
