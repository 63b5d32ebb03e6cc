//! What is kept of a URDF. Lengths are in m, angles in rad.

use nalgebra::{Isometry3, Unit, Vector3};

/// A body, or a frame without one.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Its name, which no other link has.
    pub name: String,
    /// What is drawn of it.
    pub visuals: Vec<Visual>,
}

/// A shape of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Visual {
    /// From the shape's frame to the link's.
    pub origin: Isometry3<f64>,
    /// The shape.
    pub geometry: Geometry,
    /// Red, green, blue and opacity, each from 0 to 1; `None` if the document gives none.
    pub colour: Option<[f64; 4]>,
}

/// A shape in its own frame. All sizes are above zero.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Geometry {
    /// A box about the origin.
    Box {
        /// Its edges along x, y and z in m.
        size_m: [f64; 3],
    },
    /// A cylinder about the origin, along z.
    Cylinder {
        /// Its radius in m.
        radius_m: f64,
        /// Its length in m.
        length_m: f64,
    },
    /// A ball about the origin.
    Sphere {
        /// Its radius in m.
        radius_m: f64,
    },
    /// A cylinder about the origin, along z, with half a ball on each end.
    Capsule {
        /// Its radius in m.
        radius_m: f64,
        /// Length of the cylinder in m.
        length_m: f64,
    },
    /// A file of triangles.
    Mesh {
        /// Its name, as the document has it; it may start with `package://` or `file://`.
        filename: String,
        /// Factors along x, y and z; a negative one mirrors.
        scale: [f64; 3],
    },
}

/// What holds two links together.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its name, which no other joint has.
    pub name: String,
    /// How it moves.
    pub kind: JointKind,
    /// Place of the link it hangs on, in [`Urdf::links`](crate::Urdf::links).
    pub parent: usize,
    /// Place of the link that hangs on it.
    pub child: usize,
    /// From the joint's frame, at position 0, to that of the parent link.
    pub origin: Isometry3<f64>,
    /// What it turns about or slides along, in its own frame.
    pub axis: Unit<Vector3<f64>>,
    /// The joint it follows, if it does not move by itself.
    pub mimic: Option<Mimic>,
    /// The range of its position; only what the document says, kinematics keep to no limits.
    pub limits: Option<Limits>,
}

/// How a joint moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// Turns about its axis, within limits.
    Revolute,
    /// Turns about its axis, without limits.
    Continuous,
    /// Slides along its axis.
    Prismatic,
    /// Does not move.
    Fixed,
    /// Moves in all ways.
    Floating,
    /// Moves in a plane.
    Planar,
}

impl JointKind {
    /// As URDF calls it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Revolute => "revolute",
            Self::Continuous => "continuous",
            Self::Prismatic => "prismatic",
            Self::Fixed => "fixed",
            Self::Floating => "floating",
            Self::Planar => "planar",
        }
    }

    pub(crate) fn from_word(word: &str) -> Option<Self> {
        [Self::Revolute, Self::Continuous, Self::Prismatic, Self::Fixed, Self::Floating, Self::Planar]
            .into_iter()
            .find(|kind| kind.word() == word)
    }

    /// Whether its position is one number.
    #[must_use]
    pub const fn has_position(self) -> bool {
        matches!(self, Self::Revolute | Self::Continuous | Self::Prismatic)
    }
}

/// A joint's position follows from that of another: `multiplier * position + offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mimic {
    /// The joint that is followed.
    pub joint: String,
    /// By how much its position counts.
    pub multiplier: f64,
    /// What is added, in rad or m.
    pub offset: f64,
}

/// The range of a joint's position in rad or m, from the smaller to the larger, both finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The smallest position.
    pub lower: f64,
    /// The largest position.
    pub upper: f64,
}
