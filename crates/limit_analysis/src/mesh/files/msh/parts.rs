//! Nodes and triangles of a file in the numbers of the mesh.

use std::collections::BTreeSet;

use super::super::super::extract::Triangle;
use super::super::super::vector::{Point, distance, twice_area};
use super::super::FileError;
use super::read::Raw;

/// Third coordinates may differ by this fraction of the largest coordinate.
const FLAT: f64 = 1e-9;

/// A triangle's area must be more than this fraction of the square of its longest edge.
const THIN: f64 = 1e-12;

/// Nodes and triangles in the numbers of the mesh.
pub(super) struct Parts {
    /// The file's number of each vertex, ascending.
    pub(super) tags: Vec<u64>,
    pub(super) points: Vec<Point>,
    pub(super) triangles: Vec<Triangle>,
    /// Every edge of every triangle as that runs along it, sorted, and the region of the triangle.
    pub(super) sides: Vec<([usize; 2], usize)>,
    /// Physical group of each region, if it has one.
    pub(super) groups: Vec<Option<i64>>,
}

impl Parts {
    pub(super) fn new(raw: &mut Raw) -> Result<Self, FileError> {
        let mut elements = std::mem::take(&mut raw.elements[2]);
        if elements.is_empty() {
            return Err(FileError::NoTriangles);
        }
        elements.sort_by_key(|e| e.tag);
        if let Some(pair) = elements.windows(2).find(|p| p[0].tag == p[1].tag) {
            return Err(FileError::Twice { line: pair[1].line, what: "triangle", tag: pair[1].tag });
        }
        let mut tags: Vec<u64> = elements.iter().flat_map(|e| e.nodes).collect();
        tags.sort_unstable();
        tags.dedup();
        let keys: Vec<(bool, i64)> = elements
            .iter()
            .map(|e| raw.groups(e, 2).first().map_or((true, e.entity), |&group| (false, group)))
            .collect();
        let order: Vec<(bool, i64)> = keys.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        let groups = order.iter().map(|&(bare, tag)| (!bare).then_some(tag)).collect();
        let points = vertices(raw, &tags);
        let mut parts = Self { tags, points, triangles: Vec::new(), sides: Vec::new(), groups };
        for (e, key) in elements.iter().zip(&keys) {
            let region = order.binary_search(key).unwrap_or_default();
            let mut corners = [0; 3];
            for (corner, tag) in corners.iter_mut().zip(e.nodes) {
                if !raw.nodes.contains_key(&tag) {
                    return Err(FileError::Missing { line: e.line, what: "node", tag });
                }
                *corner = parts.vertex(tag).unwrap_or_default();
            }
            let at = corners.map(|v| parts.points[v]);
            let longest = (0..3).map(|i| distance(at[i], at[(i + 1) % 3])).fold(0.0, f64::max);
            let area = 0.5 * twice_area(at);
            if area.is_nan() || area.abs() <= THIN * longest * longest {
                return Err(FileError::Flat { line: e.line, tag: e.tag, area });
            }
            if area < 0.0 {
                corners.swap(1, 2);
            }
            parts.triangles.push(Triangle { corners, region });
        }
        flat(raw, &parts.tags)?;
        let sides = |t: &Triangle| [0, 1, 2].map(|i| [t.corners[i], t.corners[(i + 1) % 3]]);
        let mut all: Vec<([usize; 2], usize)> =
            (0..).zip(&parts.triangles).flat_map(|(i, t)| sides(t).map(|s| (s, i))).collect();
        all.sort_unstable();
        if let Some(pair) = all.windows(2).find(|p| p[0].0 == p[1].0) {
            let ([from, to], e) = (pair[1].0.map(|v| parts.tags[v]), &elements[pair[1].1]);
            return Err(FileError::Overlap { line: e.line, tag: e.tag, from, to });
        }
        parts.sides = all.into_iter().map(|(side, i)| (side, parts.triangles[i].region)).collect();
        Ok(parts)
    }

    /// The vertex with a number in the file, if a triangle uses it.
    pub(super) fn vertex(&self, tag: u64) -> Option<usize> {
        self.tags.binary_search(&tag).ok()
    }

    /// The region on the left of an edge.
    pub(super) fn left(&self, edge: [usize; 2]) -> Option<usize> {
        self.sides.binary_search_by_key(&edge, |s| s.0).ok().map(|i| self.sides[i].1)
    }
}

/// Positions of nodes; of those that are missing, which is found out later, the origin.
fn vertices(raw: &Raw, tags: &[u64]) -> Vec<Point> {
    tags.iter().map(|tag| raw.nodes.get(tag).map_or([0.0; 2], |&[x, y, _]| [x, y])).collect()
}

/// Checks that all nodes are in one plane.
fn flat(raw: &Raw, tags: &[u64]) -> Result<(), FileError> {
    let nodes = || tags.iter().filter_map(|tag| raw.nodes.get(tag).map(|at| (*tag, *at)));
    let largest = nodes().flat_map(|(_, at)| at).fold(0f64, |m, c| m.max(c.abs()));
    let other = nodes().next().map_or(0.0, |(_, at)| at[2]);
    match nodes().find(|(_, at)| (at[2] - other).abs() > FLAT * largest) {
        Some((tag, [_, _, z])) => Err(FileError::NotFlat { tag, z, other }),
        None => Ok(()),
    }
}
