//! What holds along a boundary.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::Condition;

/// What holds along a boundary of the soil, as problem files call it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BoundaryKind {
    /// No stress.
    Free,
    /// Given stresses.
    Load,
    /// No motion.
    Fixed,
    /// No motion across it, and no shear stress.
    Smooth,
    /// Where the soil goes on beyond the mesh.
    Far,
    /// A face of a structure.
    Face,
}

impl BoundaryKind {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Free, Self::Load, Self::Fixed, Self::Smooth, Self::Far, Self::Face];

    /// In one word, as in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Load => "load",
            Self::Fixed => "fixed",
            Self::Smooth => "smooth",
            Self::Far => "far",
            Self::Face => "face",
        }
    }
}

impl From<&Condition> for BoundaryKind {
    fn from(condition: &Condition) -> Self {
        match condition {
            Condition::Free => Self::Free,
            Condition::Loaded { .. } | Condition::Lined { .. } | Condition::Submerged => Self::Load,
            Condition::Fixed => Self::Fixed,
            Condition::Smooth => Self::Smooth,
            Condition::Far => Self::Far,
            Condition::Face { .. } => Self::Face,
        }
    }
}
