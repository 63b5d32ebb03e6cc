use serde::{Deserialize, Serialize};

/// A stress field in space about one end of a thin upright plate, which proves a lower bound if it is statically
/// admissible.
///
/// Numbers are in units of the plate's depth and of the soil's weight: the plate is where `x = 0`, `-1 < z < 0` and
/// `s < 0`, with its end at `s = 0`; the surface is `z = 0`. `x` is ahead, where the plate moves to, `s` across. The
/// tetrahedra fill a box, and the plate goes through it from its end to the side where `s` is least; beyond that side
/// follows the [section](Self::section). Pressures are positive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpaceStress {
    /// Vertices: x, s, z.
    pub vertices: Vec<[f64; 3]>,
    /// Tetrahedra, by their vertices in any order.
    pub tetrahedra: Vec<[usize; 4]>,
    /// For each face what presses on it at its three vertices, in increasing order of these. Faces are all triples of
    /// vertices of a tetrahedron, increasing, in lexicographic order. What presses is the stress (pressure positive)
    /// times the unit normal, which follows from the face's vertices in increasing order by the right-hand rule. At
    /// faces on the plate it is that of the soil ahead.
    pub tractions: Vec<[[f64; 3]; 3]>,
    /// The same in the soil behind the plate, for the faces on the plate only.
    pub behind: Vec<[[f64; 3]; 3]>,
    /// The stress between the ends.
    pub section: SpaceSection,
}

/// The plane stress field between the ends of a plate, of a [`SpaceStress`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpaceSection {
    /// Vertices: x, z.
    pub vertices: Vec<[f64; 2]>,
    /// Triangles, by their vertices in any order.
    pub triangles: Vec<[usize; 3]>,
    /// For each triangle the face, on the side of the box where the section follows, in which it lies.
    pub parents: Vec<usize>,
    /// For each edge what presses on it at its two vertices, as for faces of tetrahedra. The normal of an edge is the
    /// way from its lesser vertex to its greater one, turned right.
    pub tractions: Vec<[[f64; 2]; 2]>,
    /// The same in the soil behind the plate, for the edges on the plate only.
    pub behind: Vec<[[f64; 2]; 2]>,
}
