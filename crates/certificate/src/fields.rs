//! The two kinds of field that prove a bound.

use serde::{Deserialize, Serialize};

use crate::mesh::Mesh;

/// A flow of the soil, which proves an upper bound. On a triangle the velocity is a quadratic polynomial in
/// Bernstein-Bezier form, `sum_i l_i^2 b_i + sum_{i<j} 2 l_i l_j b_ij` in the triangle's barycentric coordinates `l`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UpperField {
    /// The mesh.
    pub mesh: Mesh,
    /// For each triangle, indices of its control points: at corners 0, 1, 2, then on edges 0, 1, 2.
    pub nodes: Vec<[usize; 6]>,
    /// Velocities of the control points. Triangles move together where they have control points in common; where
    /// those of a common edge differ, they slide over each other.
    pub velocities: Vec<Velocity>,
}

/// Velocity of a control point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Velocity {
    /// At rest.
    Zero,
    /// `value (to - from)` of a line: exactly along it.
    Slide {
        /// Index of the line.
        line: usize,
        /// Factor.
        value: f64,
    },
    /// Any velocity.
    Free {
        /// To the right.
        x: f64,
        /// Upwards.
        y: f64,
    },
}

/// A stress function, which proves a lower bound: a Clough-Tocher piecewise cubic with continuous slopes. What the
/// numbers mean is said in the [documentation of the crate](crate#lower-bound).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LowerField {
    /// The mesh.
    pub mesh: Mesh,
    /// For each triangle, indices of the vertex copies at its corners.
    pub corners: Vec<[usize; 3]>,
    /// Copies of vertices. At a vertex on a slit each side may have its own.
    pub copies: Vec<VertexCopy>,
    /// Affine functions that the stress function equals along runs of free boundary. The first is zero.
    pub chains: Vec<Chain>,
    /// For each line of the statement, the slope `grad f . n` at its start, `n` being `to - from` turned left. Only
    /// used for lines of given shear on which no vertex copy belongs to a chain.
    pub lines: Vec<f64>,
    /// For each triangle edge, the slope across its middle, along the edge vector turned left (into the triangle).
    pub slopes: Vec<[f64; 3]>,
    /// Horizontal normal stress, beyond the reference, in the soil below the level far lines.
    pub far_stress: f64,
}

/// A copy of a vertex: triangles that share it share the value and the slopes of the stress function there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VertexCopy {
    /// Index of the vertex.
    pub vertex: usize,
    /// Value and slopes.
    pub jet: Jet,
}

/// An affine function `constant + gradient . (x, y)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chain {
    /// Value at the origin.
    pub constant: f64,
    /// Slopes.
    pub gradient: Gradient,
}

/// Slopes of an affine function.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Gradient {
    /// Any slopes.
    Free {
        /// Along x.
        x: f64,
        /// Along y.
        y: f64,
    },
    /// `value (to - from)` of a line.
    Along {
        /// Index of the line.
        line: usize,
        /// Factor.
        value: f64,
    },
}

/// Value and slopes `(f, fx, fy)` of the stress function at a vertex copy, relative to the affine function of the
/// chain `base`, or to nothing where there is no `base`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Jet {
    /// Those of a chain, exactly.
    Chain {
        /// Index of the chain.
        chain: usize,
    },
    /// Any.
    Free {
        /// Index of the chain.
        base: usize,
        /// Value.
        f: f64,
        /// Slope along x.
        fx: f64,
        /// Slope along y.
        fy: f64,
    },
    /// Next to one apex `T`: with `r` from `T` to here, slopes are `3 f r/|r|^2 + turn (-r_y, r_x)`. On a line of
    /// given shear, `turn` is not used; the slope across the line replaces it.
    OneApex {
        /// Index of the chain of the apex.
        base: usize,
        /// Index of the vertex copy at the apex.
        apex: usize,
        /// Value.
        f: f64,
        /// Slope across `r`, over the length of `r`.
        turn: f64,
    },
    /// Next to any number of apexes: slopes are `(0, 3 f/(y - datum))`.
    ManyApexes {
        /// Index of the chain of the apexes.
        base: usize,
        /// Value.
        f: f64,
    },
    /// All zero.
    Zero {
        /// Index of the chain.
        base: usize,
    },
    /// On a line of given shear with slope `g` across: slopes are `g n/|n|^2 + along (n_y, -n_x)`.
    OneLine {
        /// Index of the line.
        line: usize,
        /// Value.
        f: f64,
        /// Slope along the line, over the length of `n`.
        along: f64,
    },
    /// Where two lines of given shear meet: their slopes across give both slopes.
    TwoLines {
        /// Value.
        f: f64,
    },
}
