use std::fmt;

use soilctl_effects::EffectId;

/// What is hidden in a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// An effect of the catalogue.
    Effect(EffectId),
    /// Something that no effect of the catalogue describes.
    Outside(Outside),
}

/// What no effect of the catalogue describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outside {
    /// Some neighbouring batches differ from all others.
    OneOffBatches,
    /// The force waves over the base angle.
    BaseWaves,
    /// Tool angle and depth act together.
    AlphaByDepth,
    /// Only the middle speed differs.
    MiddleSpeed,
    /// The force waves over time.
    WarmAfternoon,
    /// Only the middle depths differ.
    MiddleDepth,
}

impl Outside {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::OneOffBatches,
        Self::BaseWaves,
        Self::AlphaByDepth,
        Self::MiddleSpeed,
        Self::WarmAfternoon,
        Self::MiddleDepth,
    ];

    /// Name in answers.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::OneOffBatches => "one_off_batches",
            Self::BaseWaves => "base_waves",
            Self::AlphaByDepth => "alpha_by_depth",
            Self::MiddleSpeed => "middle_speed",
            Self::WarmAfternoon => "warm_afternoon",
            Self::MiddleDepth => "middle_depth",
        }
    }
}

impl From<EffectId> for Cause {
    fn from(id: EffectId) -> Self {
        Self::Effect(id)
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Effect(id) => id.name(),
            Self::Outside(outside) => outside.name(),
        })
    }
}
