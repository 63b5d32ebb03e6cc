//! From nodes and elements to a mesh with an outline.

use super::super::super::extract::{Mesh, Place, Vertex};
use super::super::super::outline::{Line, Outline};
use super::super::super::vector::{along, between, dot};
use super::super::FileError;
use super::edges::hard_edges;
use super::loops::regions;
use super::parts::Parts;
use super::read::{Raw, read};
use super::runs::{Run, runs};

/// A physical group of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// Its number.
    pub tag: i64,
    /// Its name, if it has one.
    pub name: Option<String>,
}

/// A mesh from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The outline that the mesh has.
    pub outline: Outline,
    /// The mesh.
    pub mesh: Mesh,
    /// For each region, the physical group that it is. A surface in no group is a region without.
    pub regions: Vec<Option<Group>>,
    /// For each line of the outline, the physical groups that its curve is in.
    pub lines: Vec<Vec<Group>>,
}

/// Reads a mesh from a file of gmsh: MSH 4.1 or 2.2, ASCII.
///
/// Nodes and triangles are ordered by their numbers in the file. Each physical group of surfaces is a region, in the
/// order of their numbers, and after them each surface that is in no group. Lines of the outline are made of the edges
/// on the boundary, the edges between regions, and line elements inside a region, which are slits: of these, if any line
/// element is in a group, only those that are in one. A curve's edges in a straight run (within 1e-12 of the largest
/// coordinate) are one line, and all other edges are a line each. Line elements in a group named "guides" are
/// [guide edges](Mesh::guide_edges) instead. Vertices inside a line are moved onto it exactly.
///
/// Time and memory grow with the length of the file, whatever is in it.
///
/// # Errors
///
/// [`FileError`] for what is not in the format, with the line in the file, for elements of higher order, quadrilaterals
/// and volumes, for triangles that overlap or have no area, and for a mesh that has no valid outline, such as one whose
/// two sides of a slit have different nodes.
pub fn read_msh(bytes: &[u8]) -> Result<Imported, FileError> {
    let mut raw = read(bytes)?;
    let parts = Parts::new(&mut raw)?;
    let (edges, guides) = hard_edges(&mut raw, &parts)?;
    let runs = runs(&parts, edges);
    let (outline, corner) = outline(&raw, &parts, &runs);
    outline.check()?;
    let mut vertices: Vec<Vertex> =
        parts.points.iter().map(|&position| Vertex { position, place: Place::Inside }).collect();
    for (line, run) in runs.iter().enumerate() {
        let ends = outline.lines[line];
        let [a, b] = [ends.from, ends.to].map(|p| outline.points[p]);
        let way = between(a, b);
        for &v in &run.vertices[1..run.vertices.len() - 1] {
            let s = dot(between(a, vertices[v].position), way) / dot(way, way);
            vertices[v] = Vertex { position: along(a, b, s), place: Place::OnLine { line, s } };
        }
    }
    for (point, &v) in corner.iter().enumerate() {
        vertices[v].place = Place::Corner(point);
    }
    let group = |dimension, tag| Group { tag, name: raw.names.get(&(dimension, tag)).cloned() };
    let regions = parts.groups.iter().map(|g| g.map(|tag| group(2, tag))).collect();
    let groups = |run: &Run| run.groups.iter().map(|&tag| group(1, tag)).collect();
    let groups = runs.iter().map(groups).collect();
    let lines = runs.into_iter().map(|r| r.vertices).collect();
    let mesh = Mesh { vertices, triangles: parts.triangles, lines, guide_edges: guides };
    Ok(Imported { outline, mesh, regions, lines: groups })
}

/// The outline, and the vertex at each of its points.
fn outline(raw: &Raw, parts: &Parts, runs: &[Run]) -> (Outline, Vec<usize>) {
    let mut corner: Vec<usize> = runs.iter().flat_map(Run::ends).collect();
    // Points of the geometry first, in their order.
    corner.sort_by_key(|&v| (raw.points.get(&parts.tags[v]).copied().unwrap_or(i64::MAX), v));
    corner.dedup();
    let mut point = vec![0; parts.points.len()];
    for (i, &v) in corner.iter().enumerate() {
        point[v] = i;
    }
    let lines = runs.iter().map(|r| r.ends().map(|v| point[v])).map(|[from, to]| Line { from, to }).collect();
    let points = corner.iter().map(|&v| parts.points[v]).collect();
    let mut outline = Outline { points, lines, regions: Vec::new() };
    outline.regions = regions(&outline, runs, parts.groups.len());
    (outline, corner)
}
