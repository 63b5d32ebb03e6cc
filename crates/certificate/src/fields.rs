//! The two kinds of field that prove a bound.

use serde::{Deserialize, Serialize};

use crate::mesh::Mesh;

/// A velocity field, which proves an upper bound if it is kinematically admissible.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UpperField {
    /// The mesh.
    pub mesh: Mesh,
    /// The flow on each triangle: quadratic in soil with friction, by a stream function in soil without.
    pub flows: Vec<Flow>,
    /// Velocities of the control points of quadratic flows.
    pub velocities: Vec<Velocity>,
    /// Copies of vertices for the stream function.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stream: Vec<StreamCopy>,
    /// What is added to the stream function along each wall.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub walls: Vec<f64>,
    /// How members move: an entry for each triangle edge on the left of one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MemberFlow>,
}

/// How a piece of a [member](crate::Member) moves, along one triangle edge on its left.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MemberFlow {
    /// Index of the triangle.
    pub triangle: usize,
    /// The corner opposite to the edge, 0 to 2.
    pub corner: usize,
    /// Its motion at the edge's start, in the middle and at its end: the velocity is the quadratic polynomial with these Bernstein
    /// coefficients. It may jump from one edge to the next.
    pub motion: [MemberMotion; 3],
    /// Of a row of bars: how much faster than this they move along themselves, likewise. The motion is that of the soil right at the bars
    /// then, from which that beside it may slide away.
    #[serde(default, skip_serializing_if = "sticks")]
    pub slip: [f64; 3],
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn sticks(slip: &[f64; 3]) -> bool {
    *slip == [0.0; 3]
}

/// A Bernstein coefficient of a member's velocity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum MemberMotion {
    /// That of the soil, which is the same on both sides: triangles there share the control point or the vertex copy, or both
    /// are at rest.
    Soil,
    /// Along the member as given, across it as the soil that keeps its volume: that on the left, if both do.
    Along {
        /// Velocity along the member.
        along: f64,
    },
    /// Any.
    Free {
        /// Velocity along the member.
        along: f64,
        /// Velocity across it, to its left.
        across: f64,
    },
}

/// The flow on one triangle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Flow {
    /// The velocity is a quadratic polynomial in Bernstein-Bezier form, `sum_i l_i^2 b_i + sum_{i<j} 2 l_i l_j b_ij` in
    /// the triangle's barycentric coordinates `l`. The entries are indices of control points: at corners 0, 1, 2, then on
    /// edges 0, 1, 2. Triangles move together where they have control points in common; where those of a common edge
    /// differ, they slide over each other.
    Quadratic([usize; 6]),
    /// The velocity is `(s_y, -s_x)` of a stream function `s`, the same piecewise cubic as the stress function of a lower
    /// bound.
    Stream {
        /// Indices of the copies at corners 0, 1, 2.
        corners: [usize; 3],
        /// For each edge, the slope across its middle, along the edge vector turned left. Where triangles share the copies
        /// at both ends of an edge, that of the first of them counts for both.
        slopes: [f64; 3],
    },
}

/// A copy of a vertex: triangles that share it share the value and the slopes of the stream function there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StreamCopy {
    /// Index of the vertex.
    pub vertex: usize,
    /// Value and slopes.
    pub jet: StreamJet,
}

/// Value and slopes `(s, sx, sy)` of the stream function at a vertex copy.
///
/// A *wall* is a run of boundary sides of soil without friction along which the velocity across is given: zero along
/// fixed, far and smooth sides, that of the structure along faces with adhesion but no friction. There the stream function
/// is known up to a constant, the entry in [`UpperField::walls`]: it is zero at the start of the run's first side (walked
/// with the soil on the left) and grows by what the given velocity carries out of the soil: from `a` to `b` by `V_x (b -
/// a)_y - V_y (b - a)_x`. Runs are counted in the order of the least index of their sides in
/// [`Statement::boundaries`](crate::Statement::boundaries); a closed one starts with that side.
///
/// All copies at the ends of an edge on a wall must be of the kind `Wall` or `Corner`, all others `Free` or `Kinked`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum StreamJet {
    /// Any.
    Free {
        /// Value.
        s: f64,
        /// Slope along x.
        sx: f64,
        /// Slope along y.
        sy: f64,
    },
    /// On one side of a wall: slopes are those along the side plus `across n`, `n` being the line's `to - from` turned
    /// left. On fixed and far sides `across` is zero, and so are the slopes across the middles of edges.
    Wall {
        /// Index of the wall.
        wall: usize,
        /// Index of the line.
        line: usize,
        /// Slope across over the length of `n`.
        across: f64,
    },
    /// On the other side of a member than another copy, which is of the kind `Free`: value and slopes are those there, and
    /// `jump n` more, `n` being the line's `to - from` turned left. So soil slides along the member, and none passes through it.
    Kinked {
        /// Index of the other copy of the same vertex.
        copy: usize,
        /// Index of a line of the member, on which the vertex is.
        line: usize,
        /// What the slope across is more, over the length of `n`.
        jump: f64,
    },
    /// Across the edge towards another vertex from another copy: the value is that there, and slopes are `jump n` more, `n` being the edge vector
    /// turned left. So soil slips along the edge, and none passes through it, though none of it slips at the edge's other end. This is for the
    /// toe of a wall that moves on ground that does not, where all velocities meet.
    Slip {
        /// Index of the other copy of the same vertex.
        copy: usize,
        /// Index of the vertex at the other end of the edge.
        towards: usize,
        /// What the slope across is more, over the length of `n`.
        jump: f64,
    },
    /// The same on one side of a wall, which the other copy, or that on which it depends and so on, is on next to it: slopes are those along
    /// the side, and along the edge those of the other copy.
    SlipAtWall {
        /// Index of the other copy of the same vertex.
        copy: usize,
        /// Index of the vertex at the other end of the edge.
        towards: usize,
    },
    /// Where two sides of a wall meet that are not parallel: both slopes follow from them. Also where they are parallel and
    /// move alike: the soil moves with them then.
    Corner {
        /// Index of the wall.
        wall: usize,
    },
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

/// An Airy stress function, which proves a lower bound if its stresses are statically admissible: a piecewise cubic with
/// continuous slopes on Clough-Tocher macro-elements. What the numbers mean is said in the
/// [documentation of the crate](crate#lower-bound).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LowerField {
    /// The mesh.
    pub mesh: Mesh,
    /// For each triangle, indices of the vertex copies at its corners.
    pub corners: Vec<[usize; 3]>,
    /// Copies of vertices. At a vertex on a slit each side may have its own.
    pub copies: Vec<VertexCopy>,
    /// One affine function for each run of free or loaded boundary, in the order of the least index of its sides in
    /// [`Statement::boundaries`](crate::Statement::boundaries). Along the run the stress function equals it plus what the
    /// loads demand. The first is zero. Any number of *branches* may follow: what the function has beyond itself on the way
    /// around a body that carries a force. Files call them chains.
    #[serde(rename = "chains")]
    pub gauges: Vec<Gauge>,
    /// For each line of the statement, the slope `grad f . n` at its start, `n` being `to - from` turned left. Only
    /// used for lines of given shear on which no vertex copy belongs to a gauge, and of a run of such lines that follow
    /// each other in one direction only for the first, by its index in the statement's boundaries.
    pub lines: Vec<f64>,
    /// For each triangle edge, the slope across its middle, along the edge vector turned left (into the triangle); that
    /// beyond the gauge of its ends where these are relative to other gauges in the triangle beyond.
    pub slopes: Vec<[f64; 3]>,
    /// Horizontal normal stress, beyond the reference, in the soil below the level far lines.
    pub far_stress: f64,
    /// The factor on live loads or on the body force, which is what is proven; not used for a structure.
    #[serde(default)]
    pub multiplier: f64,
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

/// An affine function `constant + gradient . (x, y)`, which carries no stress: a stress function is known up to one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gauge {
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
/// gauge `base`, or to nothing where there is no `base`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Jet {
    /// Those of a gauge at this place, loads included, exactly: the gauge of the run, or a branch.
    #[serde(rename = "chain")]
    Gauge {
        /// Index of the gauge.
        #[serde(rename = "chain")]
        gauge: usize,
    },
    /// Any.
    Free {
        /// Index of the gauge.
        base: usize,
        /// Value.
        f: f64,
        /// Slope along x.
        fx: f64,
        /// Slope along y.
        fy: f64,
    },
    /// Value and slopes next to apexes are those beyond the surface's polynomial.
    ///
    /// Next to one apex `T`: with `r` from `T` to here, slopes are `3 f r/|r|^2 + turn (-r_y, r_x)`. On a line of
    /// given shear, `turn` is not used; the slope across the line replaces it.
    OneApex {
        /// Index of the gauge of the apex.
        base: usize,
        /// Index of the vertex copy at the apex.
        apex: usize,
        /// Value.
        f: f64,
        /// Slope across `r`, over the length of `r`.
        turn: f64,
    },
    /// Next to any number of apexes on one side: slopes are `3 f n/(n . r)`, with `n` the side's normal and `r` from the side to here; at
    /// the datum `(0, 3 f/(y - datum))`.
    ManyApexes {
        /// Index of the gauge of the apexes.
        base: usize,
        /// Value.
        f: f64,
    },
    /// All zero.
    Zero {
        /// Index of the gauge.
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
    /// On the other side of a member than another copy, of any other kind: value and slopes are those there, and `jump n` more, `n`
    /// being the line's `to - from` turned left. The jump is the member's axial force over the length of `n`: tension, if the
    /// slope along `n` is greater on the side to which `n` points.
    Kinked {
        /// Index of the other copy of the same vertex.
        copy: usize,
        /// Index of a line of the member, on which the vertex is.
        line: usize,
        /// What the slope across is more, over the length of `n`.
        jump: f64,
    },
}

impl Jet {
    /// The gauge that the values are relative to; none where the slope across a line of given shear is part of them.
    pub(crate) fn base(self) -> Option<usize> {
        match self {
            Self::Gauge { gauge: base }
            | Self::Free { base, .. }
            | Self::OneApex { base, .. }
            | Self::ManyApexes { base, .. }
            | Self::Zero { base } => Some(base),
            Self::OneLine { .. } | Self::TwoLines { .. } | Self::Kinked { .. } => None,
        }
    }

    /// The same relative to another gauge, and next to another apex if next to one.
    pub(crate) fn on(self, base: usize, apex: usize) -> Self {
        match self {
            Self::Gauge { .. } => Self::Gauge { gauge: base },
            Self::Free { f, fx, fy, .. } => Self::Free { base, f, fx, fy },
            Self::OneApex { f, turn, .. } => Self::OneApex { base, apex, f, turn },
            Self::ManyApexes { f, .. } => Self::ManyApexes { base, f },
            Self::Zero { .. } => Self::Zero { base },
            other @ (Self::OneLine { .. } | Self::TwoLines { .. } | Self::Kinked { .. }) => other,
        }
    }
}

/// Rigid blocks in translation, which prove an upper bound for a structure with ends if they move as the soil allows. Of
/// what is symmetric about y = 0, the half where y is positive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mechanism {
    /// Vertices of the blocks.
    pub vertices: Vec<Position>,
    /// For each block its velocity: along x and y of space, and along the statement's y.
    pub velocities: Vec<[f64; 3]>,
    /// All facets, each once: those of one block close up.
    pub facets: Vec<Facet>,
}

/// Where a vertex is in space: x as in the statement, y across, z upwards as the statement's y.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Position {
    /// Below the surface: x, y, z.
    Inside([f64; 3]),
    /// Exactly on the surface: x, y.
    Surface([f64; 2]),
    /// Exactly in the plate's plane: distance down from the plate's upper edge over the plate's length, and y.
    Plate([f64; 2]),
}

/// A triangle of a block's surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Facet {
    /// Index of the block.
    pub block: usize,
    /// Indices of its vertices, counter-clockwise as seen from outside the block.
    pub corners: [usize; 3],
    /// What is on the other side.
    pub beyond: BeyondFacet,
}

/// What is beyond a facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum BeyondFacet {
    /// Soil that does not move.
    Rest,
    /// Another block, by its index; the facet is that one's too, seen from the other side.
    Block(usize),
    /// The air.
    Surface,
    /// The plate.
    Plate,
    /// The mirror image.
    Symmetry,
}
