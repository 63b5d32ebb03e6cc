use serde::{Deserialize, Serialize};

/// Triangles that cover the regions of a [`Statement`](crate::Statement).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// Vertices.
    pub vertices: Vec<Vertex>,
    /// Triangles.
    pub triangles: Vec<Triangle>,
}

/// A vertex of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vertex {
    /// Where it is, x and y: exactly, if it is [`Place::Inside`]; otherwise the place counts and this is for show.
    pub position: [f64; 2],
    /// What it is on.
    pub place: Place,
}

/// What a vertex is on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Place {
    /// Exactly at a point of the statement.
    Corner {
        /// Index of the point.
        point: usize,
    },
    /// Exactly at `from + s (to - from)` of a line of the statement, in real arithmetic.
    OnLine {
        /// Index of the line.
        line: usize,
        /// Fraction of the way along the line, between 0 and 1.
        s: f64,
    },
    /// On no line.
    Inside,
}

/// A triangle of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Triangle {
    /// Indices of its corners, counter-clockwise. Edge `k` lies opposite to corner `k`; it runs from corner `k + 1` to
    /// corner `k + 2`, modulo 3.
    pub corners: [usize; 3],
    /// Index of the region in which it lies.
    pub region: usize,
}

/// An edge of a triangle as the triangle sees it: the one opposite to a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Side {
    /// Index of the triangle.
    pub triangle: usize,
    /// The corner opposite to the edge, 0 to 2.
    pub corner: usize,
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "triangle {}, edge {}", self.triangle, self.corner)
    }
}
