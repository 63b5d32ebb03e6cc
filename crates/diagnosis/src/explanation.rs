use std::fmt;

use soilctl_effects::{Covariate, EffectId};

/// What a campaign may be explained by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Explanation {
    /// An effect of the catalogue.
    Effect(EffectId),
    /// Something that is not in the catalogue; written as `unknown:` and what it depends on.
    Unknown(Dependence),
}

/// What a shape without a name depends on: one covariate, or the product of two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dependence {
    /// The covariate.
    pub on: Covariate,
    /// The other one of a product.
    pub times: Option<Covariate>,
}

impl From<Covariate> for Dependence {
    fn from(on: Covariate) -> Self {
        Self { on, times: None }
    }
}

impl fmt::Display for Dependence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.times {
            Some(times) => write!(f, "{} x {times}", self.on),
            None => write!(f, "{}", self.on),
        }
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Effect(id) => write!(f, "{id}"),
            Self::Unknown(dependence) => write!(f, "unknown:{dependence}"),
        }
    }
}
