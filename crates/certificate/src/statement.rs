use serde::{Deserialize, Serialize};

/// A limit-analysis problem: soil in plane strain, what holds and loads it, and the load that is to be bounded.
///
/// x points to the right, y upwards; tension is positive. Lengths, unit weights and stresses are in any units that fit
/// together (stress = unit weight times length), angles in degrees. What the numbers mean is said in the
/// [documentation of the crate](crate).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Statement {
    /// Corner points, x and y.
    pub points: Vec<[f64; 2]>,
    /// Straight lines between points. Two lines may meet at a common point and nowhere else. At most 1024.
    pub lines: Vec<Line>,
    /// Soil. Regions do not overlap.
    pub regions: Vec<Region>,
    /// Body force where the unit weight is one; the second component is at most zero, and below zero if the first one
    /// is not zero.
    pub gravity: [f64; 2],
    /// The y at which the reference pressure is the surcharge.
    pub datum: f64,
    /// Pressure on free sides and on the surface beyond far lines, at least zero.
    pub surcharge: f64,
    /// What is bounded.
    pub objective: Objective,
    /// What holds on boundary sides of lines, at most one entry for each side.
    pub boundaries: Vec<Boundary>,
    /// Width of the structure across the plane, above zero, if it has ends: the soil goes on beyond them, and bounds are
    /// those of a body in space, per unit width of the structure. Plane strain if it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Bars, sheets and beams in the soil. No line belongs to two of them, and no point, but where an end of one is attached to a beam.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<Member>,
}

/// A straight member in the soil, thin: a bar, a sheet, a tie, all perfectly flexible, or a beam, which bends. It carries an axial force
/// and takes the soil along up to what its faces bear, or its [grip](Grip) if it is a row of bars; a beam carries a moment and a shear force besides, and may have soil on one of
/// its sides only, which is [`Lined`](Condition::Lined) then. Forces are per unit width.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Member {
    /// Its name; no proof depends on it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// The sides of lines on its left, from its start to its end: it goes along them. Either one line, or level ones, or upright
    /// ones, for only these are proven to be in one line.
    pub path: Vec<LineUse>,
    /// Greatest tension (force), at least zero.
    pub tension: f64,
    /// Greatest compression (force), at least zero; a sheet bears none.
    #[serde(default, skip_serializing_if = "is_none")]
    pub compression: f64,
    /// Shear traction that each face bears over that which the soil beside it bears at the same effective normal stress: above
    /// zero, at most one.
    pub bond: f64,
    /// Whether its start and its end are attached to what is there, which then takes any force along the member: a face of the
    /// structure, a fixed side, a smooth one at right angles, or a beam. Ends that are not bear no force. An end of a beam can be
    /// attached to a fixed side, which takes its shear force and its moment too.
    #[serde(default, skip_serializing_if = "is_loose")]
    pub attached: [bool; 2],
    /// What a beam bears by bending; a member without it is flexible.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bending: Option<Bending>,
    /// What a row of bars takes from the soil, which goes on between them: an entry for each line of the path, in order. A member
    /// without it is a sheet or a beam, which parts the soil and has faces. With it `bond` is one, and there is no `bending`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pullout: Option<Vec<Grip>>,
}

/// What soil that goes on between the bars of a row hands to them along a line, either way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Grip {
    /// Greatest force over length (stress) at the first and the last point of the line itself, at least zero; linear between.
    pub resistance: [f64; 2],
    /// The fractions of the line between which there is this much; elsewhere there is none. The first is at least zero, the second
    /// not less than that and at most one.
    #[serde(default = "whole", skip_serializing_if = "is_whole")]
    pub part: [f64; 2],
}

fn whole() -> [f64; 2] {
    [0.0, 1.0]
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_whole(part: &[f64; 2]) -> bool {
    *part == whole()
}

/// What a beam bears across itself. Its greatest forces do not depend on each other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bending {
    /// Greatest bending moment (force times length over width, so a force), above zero.
    pub moment: f64,
    /// Greatest shear force (force), above zero.
    pub shear: f64,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_none(force: &f64) -> bool {
    *force == 0.0
}

fn is_loose(attached: &[bool; 2]) -> bool {
    *attached == [false; 2]
}

impl Statement {
    /// The same with a structure of this width.
    #[must_use]
    pub fn with_width(self, width: f64) -> Self {
        Self { width: Some(width), ..self }
    }
}

/// What is bounded.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Objective {
    /// The force of the structure on the soil, times its velocity.
    Structure {
        /// The structure's velocity.
        velocity: [f64; 2],
    },
    /// The factor on all live [loads](Condition::Loaded). Structures do not move.
    Loads,
    /// The factor on a body force that is added to gravity. Structures do not move.
    Body {
        /// The body force where the unit weight is one.
        gravity: [f64; 2],
    },
    /// The factor on everything that acts: gravity, water, surcharge and loads. Cohesion, adhesion and tension divided by
    /// it just suffice. Structures do not move.
    Everything,
}

impl Objective {
    /// Velocity of the structure: zero unless its force is the objective.
    #[must_use]
    pub fn velocity(&self) -> [f64; 2] {
        match self {
            Self::Structure { velocity } => *velocity,
            Self::Loads | Self::Body { .. } | Self::Everything => [0.0; 2],
        }
    }
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

impl Line {
    /// First and last point in the sense in which it is walked.
    #[must_use]
    pub fn walked(self, forward: bool) -> [usize; 2] {
        if forward { [self.from, self.to] } else { [self.to, self.from] }
    }

    /// Whether a point is one of its ends.
    #[must_use]
    pub fn touches(self, point: usize) -> bool {
        self.from == point || self.to == point
    }
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

impl LineUse {
    /// The other side of the line.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { forward: !self.forward, ..self }
    }
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

/// A soil with associated flow, of Mohr and Coulomb's strength or, with an [envelope](Envelope), of one that grows less and less with
/// pressure.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Friction angle in degrees, from 0 up to (not including) 90.
    pub phi_deg: f64,
    /// Cohesion (stress), at least zero all over the region.
    pub cohesion: Linear,
    /// Unit weight (force per volume), at least zero.
    pub unit_weight: f64,
    /// Pressure of the water in the pores. Strength depends on the effective stress, which is the stress plus this.
    #[serde(default, skip_serializing_if = "Linear::is_zero")]
    pub pore_pressure: Linear,
    /// Greatest effective tension (stress), at least zero; none but what friction and cohesion allow if it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
    /// What limits the strength beside friction angle and cohesion, which are those at the least pressure then. The friction angle is
    /// above zero and the cohesion is the same everywhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub envelope: Option<Envelope>,
    /// Clay whose strength depends on the direction of the stress; the cohesion is that under the greatest pressure upright then. The friction
    /// angle is zero, and tension is not limited.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub anisotropy: Option<Anisotropy>,
}

/// Undrained strength that depends on the direction of the stress: with `c` the cohesion and stresses positive in tension, the soil bears
///
/// ```text
/// (((xx - yy)/2 - c (1 - passive)/2) / (c (1 + passive)/2))^2 + (xy / (c shear))^2 <= 1
/// ```
///
/// in plane strain, an ellipse (Davis and Christian 1971; the plane form of NGI-ADP, Grimstad, Andresen and Jostad 2012).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Anisotropy {
    /// Strength over the cohesion where the greatest pressure is level; above zero.
    pub passive: f64,
    /// The greatest shear stress on level and upright planes over the cohesion; above zero.
    pub shear: f64,
}

/// A curved strength envelope, between two made of straight lines. Lower bounds hold for soil that bears what the inner one says, upper
/// bounds for soil that bears no more than the outer one, so both hold for all soils between.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Envelope {
    /// Lines that the inner one has beside that of the material's friction angle and cohesion, steepest first. Each is the lowest
    /// somewhere: at less tension than those before it, at more than those after it.
    pub inside: Vec<StrengthLine>,
    /// All lines of the outer one in the same order, nowhere below the inner one; if there are none they are one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outside: Vec<StrengthLine>,
}

/// A straight line that a shear strength is below.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StrengthLine {
    /// Friction angle in degrees, from 0 up to (not including) 90.
    pub phi_deg: f64,
    /// Cohesion (stress), at least zero.
    pub cohesion: f64,
}

/// A quantity that is linear over a region: `at_origin + gradient . (x, y)`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Linear {
    /// Value at the origin of coordinates, be it inside the region or not.
    pub at_origin: f64,
    /// Slopes along x and y.
    #[serde(default, skip_serializing_if = "is_level")]
    pub gradient: [f64; 2],
}

fn is_level(gradient: &[f64; 2]) -> bool {
    *gradient == [0.0; 2]
}

impl Linear {
    /// The same everywhere.
    #[must_use]
    pub const fn uniform(value: f64) -> Self {
        Self { at_origin: value, gradient: [0.0; 2] }
    }

    /// Its value at a point, rounded.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> f64 {
        self.at_origin + self.gradient[0] * x + self.gradient[1] * y
    }

    /// Whether it is zero everywhere.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.at_origin == 0.0 && is_level(&self.gradient)
    }
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
    /// Loaded by given tractions, linear along the line.
    Loaded {
        /// Pressure at the start and the end of the line itself, whichever side this is.
        pressure: [f64; 2],
        /// Shear traction on the soil at the same two ends, along the side walked with the soil on the left.
        shear: [f64; 2],
        /// Whether the load is multiplied by the factor that [`Objective::Loads`] bounds. With any other objective it is
        /// like all loads.
        live: bool,
    },
    /// A beam lies along the soil, loaded from outside by tractions that are linear along the line. It must be a piece of a
    /// [member](Member) that bends.
    Lined {
        /// Pressure on the beam at the start and the end of the line itself, whichever side this is.
        pressure: [f64; 2],
        /// Shear traction on the beam at the same two ends, along the side walked with the soil on the left.
        shear: [f64; 2],
        /// As that of [loaded](Condition::Loaded) sides.
        live: bool,
    },
    /// Under open water that is one with the water in the pores: the load is a pressure, the soil's pore pressure along the line.
    Submerged,
    /// No velocity; any traction.
    Fixed,
    /// No velocity across; no shear traction.
    Smooth,
    /// The soil goes on for ever beyond the line, the same as inside along it, under a level surface, as high as the
    /// upper end of the far side, that carries the surcharge.
    Far,
    /// A face of the structure, without tension: shear traction up to `adhesion - normal stress * tan(delta)`.
    Face {
        /// Friction angle of the interface in degrees, from 0 up to (not including) 90.
        delta_deg: f64,
        /// Adhesion (stress), at least zero. With `delta_deg` zero: if it is zero, the face bears pressure only; if not,
        /// any normal stress, but it is covered for soil without friction only.
        adhesion: f64,
    },
}

impl Statement {
    /// Pore pressure of the soil on this side of a line, at the line's first and last point; none where no soil is.
    #[must_use]
    pub fn pore_pressure(&self, side: LineUse) -> [f64; 2] {
        let owner =
            self.regions.iter().find(|region| region.loops.iter().flatten().any(|other| *other == side));
        let ends =
            self.lines.get(side.line).map(|line| [line.from, line.to].map(|point| self.points.get(point)));
        match (owner, ends) {
            (Some(region), Some([Some(a), Some(b)])) => [a, b].map(|p| region.material.pore_pressure.at(*p)),
            _ => [0.0; 2],
        }
    }
}

impl Condition {
    /// Whether nothing acts on the grains there, with this surcharge on free lines: no load, or no more than the pore water bears.
    #[must_use]
    pub fn leaves_bare(self, surcharge: f64) -> bool {
        match self {
            Self::Free => surcharge == 0.0,
            Self::Submerged => true,
            Self::Loaded { .. }
            | Self::Lined { .. }
            | Self::Fixed
            | Self::Smooth
            | Self::Far
            | Self::Face { .. } => false,
        }
    }

    /// Whether it says what acts from outside: on the soil, or on a beam along it.
    #[must_use]
    pub fn is_loaded(self) -> bool {
        self.traction_is_given() || matches!(self, Self::Lined { .. })
    }

    /// Whether it says what the shear stress along the line is: on smooth lines, frictionless faces without adhesion, and
    /// far lines.
    #[must_use]
    pub fn shear_is_given(self) -> bool {
        match self {
            Self::Smooth | Self::Far => true,
            Self::Face { delta_deg, adhesion } => delta_deg == 0.0 && adhesion == 0.0,
            Self::Free | Self::Loaded { .. } | Self::Lined { .. } | Self::Submerged | Self::Fixed => false,
        }
    }

    /// Whether it says what the tractions on the soil are: on free, loaded and submerged lines.
    #[must_use]
    pub fn traction_is_given(self) -> bool {
        match self {
            Self::Free | Self::Loaded { .. } | Self::Submerged => true,
            Self::Lined { .. } | Self::Fixed | Self::Smooth | Self::Far | Self::Face { .. } => false,
        }
    }

    /// Whether it says, in soil without friction, what the velocity across the line is: zero, or that of the structure.
    #[must_use]
    pub fn is_wall(self) -> bool {
        match self {
            Self::Fixed | Self::Far | Self::Smooth => true,
            Self::Face { delta_deg, adhesion } => delta_deg == 0.0 && adhesion > 0.0,
            Self::Free | Self::Loaded { .. } | Self::Lined { .. } | Self::Submerged => false,
        }
    }
}
