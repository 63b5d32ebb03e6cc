//! What a problem file asks for.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::describe::{Aim, Quantity};
use soilctl_limit_analysis::{Described, Description};

/// What a problem file asks bounds on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Asked {
    /// Force of the structure on the soil along its motion in kN per metre of width.
    ForceKnPerM,
    /// Factor on the live loads.
    LoadFactor,
    /// Factor on the unit weights.
    WeightFactor,
    /// Horizontal acceleration over gravity.
    AccelerationOverG,
    /// Factor by which strength can be divided.
    FactorOfSafety,
}

impl From<Quantity> for Asked {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::ForceKnPerM => Self::ForceKnPerM,
            Quantity::LoadFactor => Self::LoadFactor,
            Quantity::WeightFactor => Self::WeightFactor,
            Quantity::Acceleration => Self::AccelerationOverG,
        }
    }
}

impl Asked {
    /// Of a file; a factor of safety is searched by bounding another quantity.
    pub(super) fn of(description: &Description, described: &Described) -> Self {
        match description.objective {
            Aim::StrengthReduction {} => Self::FactorOfSafety,
            _ => described.quantity.into(),
        }
    }

    /// In words, with its unit.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::ForceKnPerM => "force of the structure on the soil, along its motion (kN/m)",
            Self::LoadFactor => "factor on the live loads",
            Self::WeightFactor => "factor on the unit weights",
            Self::AccelerationOverG => "horizontal acceleration over gravity",
            Self::FactorOfSafety => "factor of safety, by which strength can be divided",
        }
    }
}
