use serde::{Deserialize, Serialize};

/// A limit-analysis problem: soil in plane strain and one rigid structure that is pushed.
///
/// x points to the right, y upwards; tension is positive. Lengths, unit weights and stresses are in any units that fit
/// together (stress = unit weight times length), angles in degrees. What the numbers mean is said in the
/// [documentation of the crate](crate).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Statement {
    /// Corner points, x and y.
    pub points: Vec<[f64; 2]>,
    /// Straight lines between points. Two lines may meet at a common point and nowhere else. At most 256.
    pub lines: Vec<Line>,
    /// Soil. Regions do not overlap.
    pub regions: Vec<Region>,
    /// Body force where the unit weight is one; the second component is below zero.
    pub gravity: [f64; 2],
    /// The y at which the reference pressure is the surcharge; the level of the free surface beyond far lines.
    pub datum: f64,
    /// Pressure on free sides, at least zero.
    pub surcharge: f64,
    /// Velocity of the structure. Bounds are on its force times this.
    pub velocity: [f64; 2],
    /// What holds on boundary sides of lines, at most one entry for each side.
    pub boundaries: Vec<Boundary>,
}

/// A straight line between two points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// Index of the first point.
    pub from: usize,
    /// Index of the last point.
    pub to: usize,
}

/// One side of a line: the left one when it is walked from its first point to its last (`forward`), or from its last
/// to its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LineUse {
    /// Index of the line.
    pub line: usize,
    /// Whether the line is walked from its first point to its last.
    pub forward: bool,
}

/// A region of one soil.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// Closed loops of lines, walked end to end with the region on the left: the outer loop counter-clockwise, holes
    /// clockwise. A line that a region uses in both senses is a slit, such as a thin plate.
    pub loops: Vec<Vec<LineUse>>,
    /// Its soil.
    pub material: Material,
}

/// A Mohr-Coulomb soil with associated flow.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Friction angle in degrees, from 0 up to (not including) 90.
    pub phi_deg: f64,
    /// Cohesion (stress), at least zero.
    pub cohesion: f64,
    /// Unit weight (force per volume), at least zero.
    pub unit_weight: f64,
}

/// What holds on one side of a line. A side of a region without such an entry is an interface with other soil.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Boundary {
    /// Index of the line.
    pub line: usize,
    /// Whether it is the left side of the line walked from its first point to its last, or that of the line walked
    /// backwards.
    pub forward: bool,
    /// The condition.
    pub condition: Condition,
}

impl Boundary {
    /// The side on which it holds.
    #[must_use]
    pub fn side(&self) -> LineUse {
        LineUse { line: self.line, forward: self.forward }
    }
}

/// A boundary condition.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Condition {
    /// Loaded by the surcharge, as a pressure.
    Free,
    /// No velocity; any traction.
    Fixed,
    /// No velocity across; no shear traction.
    Smooth,
    /// The soil goes on for ever beyond the line, the same as inside along it, under a level free surface at the datum.
    Far,
    /// A face of the structure, without tension: shear traction up to `adhesion - normal stress * tan(delta)`.
    Face {
        /// Friction angle of the interface in degrees, from 0 up to (not including) 90.
        delta_deg: f64,
        /// Adhesion (stress), at least zero. With `delta_deg` zero, only zero is covered.
        adhesion: f64,
    },
}

impl Condition {
    /// Whether the condition says what the shear stress along the line is.
    pub(crate) fn shear_is_given(self) -> bool {
        match self {
            Self::Smooth | Self::Far => true,
            Self::Face { delta_deg, adhesion } => delta_deg == 0.0 && adhesion == 0.0,
            Self::Free | Self::Fixed => false,
        }
    }
}
