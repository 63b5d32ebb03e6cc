//! Splits a piece of a line or guide at its middle.

use spade::Triangulation;

use super::MeshError;
use super::triangulation::{EdgeId, VertexId};
use super::work::{Kind, Node, Work};
use crate::vector::{along, distance};

impl Work<'_> {
    /// Splits a constraint edge at its middle; `None` if it is too short to be split.
    ///
    /// The middle of a line's piece is off the edge by a rounding error, so the edge is released, the vertex added,
    /// and the halves made constraints again.
    pub(super) fn split(&mut self, edge: EdgeId) -> Result<Option<usize>, MeshError> {
        let [a, b] = self.edge_ends(edge);
        let (from, to) = (self.nodes[a], self.nodes[b]);
        let (at, kind) = if let Some((line, _)) = self.line_between(a, b) {
            let ends = self.domain.statement.lines[line];
            let place = |n: Node| match n.kind {
                Kind::Line { s, .. } => s,
                Kind::Corner(c) if c == ends.from => 0.0,
                _ => 1.0,
            };
            let s = 0.5 * (place(from) + place(to));
            (self.domain.on_line(line, s), Kind::Line { line, s })
        } else {
            let faces = self.cdt.undirected_edge(edge).as_directed().face().as_inner().map(|f| f.fix());
            let Some(region) = faces.and_then(|f| self.region(f)) else { return Ok(None) };
            (along(from.at, to.at, 0.5), Kind::Guide(region))
        };
        if distance(from.at, to.at) < self.wanted.range[0] {
            return Ok(None);
        }
        let size = self.size_near(at, &[a, b])?;
        let added = self.sides(edge);
        self.cdt.remove_constraint_edge(edge);
        let failure = || MeshError::Numerical { x: at[0], y: at[1], reason: "cannot split an edge".into() };
        let middle = self.insert(Node { at, kind, size }, a)?.ok_or_else(failure)?;
        for end in [a, b] {
            let [u, v] = [end, middle].map(VertexId::from_index);
            if self.cdt.try_add_constraint(u, v).len() != 1 {
                return Err(failure());
            }
        }
        self.triangles += added;
        self.wanted.allow(self.triangles)?;
        Ok(Some(middle))
    }

    /// How many sides of an edge are in a region.
    fn sides(&self, edge: EdgeId) -> usize {
        let directed = self.cdt.undirected_edge(edge).as_directed();
        [directed, directed.rev()]
            .into_iter()
            .filter(|e| e.face().as_inner().is_some_and(|f| self.region(f.fix()).is_some()))
            .count()
    }
}
