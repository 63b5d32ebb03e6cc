use thiserror::Error;

use super::super::MeshError;

/// Why a mesh cannot be written to a file, or a file holds no mesh. Lines of files are counted from 1.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FileError {
    /// Something else than the format says.
    #[error("line {line}: expected {expected}, found \"{found}\"")]
    Syntax {
        /// Line of the file.
        line: usize,
        /// What the format says.
        expected: &'static str,
        /// What is there, shortened.
        found: String,
    },
    /// The file ends too soon.
    #[error("the file ends at line {line} where {expected} should follow; is it complete?")]
    Ends {
        /// Last line of the file.
        line: usize,
        /// What the format says.
        expected: &'static str,
    },
    /// A version of the format that is not read.
    #[error("line {line}: the format is \"{found}\"; MSH 4.1 and 2.2 are read, as ASCII, save it as such")]
    Version {
        /// Line of the file.
        line: usize,
        /// The version, or "binary".
        found: String,
    },
    /// Elements other than points, straight lines and triangles.
    #[error(
        "line {line}: elements of type {kind}; only points (15), straight lines (1) and triangles with three nodes \
         (2) are read, mesh in two dimensions with order 1 and without recombination"
    )]
    Element {
        /// Line of the file.
        line: usize,
        /// gmsh's number of the type.
        kind: u64,
    },
    /// A node or element has the number of another.
    #[error("line {line}: there is another {what} with the number {tag}")]
    Twice {
        /// Line of the file.
        line: usize,
        /// "node", "triangle", or the like.
        what: &'static str,
        /// Its number in the file.
        tag: u64,
    },
    /// An element uses a node, or is in an entity, that does not exist.
    #[error("line {line}: there is no {what} with the number {tag}")]
    Missing {
        /// Line of the file.
        line: usize,
        /// "node", or the like.
        what: &'static str,
        /// The number that is named.
        tag: u64,
    },
    /// A node is off the plane of the others.
    #[error(
        "node {tag} has the third coordinate {z}, another one {other}; the mesh must be in a plane z = constant"
    )]
    NotFlat {
        /// Number of the node in the file.
        tag: u64,
        /// Its third coordinate.
        z: f64,
        /// That of the first node.
        other: f64,
    },
    /// A surface in two groups, or a curve in very many.
    #[error(
        "line {line}: the entity is in {count} physical groups; a surface can be in 1, which is the region, and a curve \
         in 16"
    )]
    Groups {
        /// Line of the file.
        line: usize,
        /// How many groups.
        count: usize,
        /// How many are allowed.
        limit: usize,
    },
    /// A file without triangles.
    #[error(
        "there are no triangles; mesh in two dimensions, and save all elements or those of a group of surfaces"
    )]
    NoTriangles,
    /// A triangle without area.
    #[error("line {line}: triangle {tag} has the area {area}; it must not be zero")]
    Flat {
        /// Line of the file.
        line: usize,
        /// Number of the triangle in the file.
        tag: u64,
        /// Its area.
        area: f64,
    },
    /// Two triangles on the same side of an edge.
    #[error(
        "line {line}: triangle {tag} overlaps another one, they are on the same side of the edge from node {from} to \
         node {to}"
    )]
    Overlap {
        /// Line of the file.
        line: usize,
        /// Number of the triangle in the file.
        tag: u64,
        /// A node.
        from: u64,
        /// A node.
        to: u64,
    },
    /// A line element that is not an edge of a triangle.
    #[error(
        "line {line}: line element {tag} is not an edge of a triangle; embed its curve in the surface, or take it out \
         of the physical groups"
    )]
    LooseLine {
        /// Line of the file.
        line: usize,
        /// Number of the line element in the file.
        tag: u64,
    },
    /// Data that cannot be written.
    #[error("field \"{name}\": {what} is {value}; it must be {allowed}")]
    BadField {
        /// Name of the field.
        name: String,
        /// What is wrong.
        what: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// The outline that a file's mesh has is no good.
    #[error("the mesh in the file has an outline that cannot be used: {0}")]
    Outline(#[from] MeshError),
}
