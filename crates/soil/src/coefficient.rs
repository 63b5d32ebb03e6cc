use serde::{Deserialize, Serialize};

use crate::Angle;

/// Earth-pressure coefficient normalised by the slant length: `K_L = 2 F / (gamma L^2 w)`.
///
/// Appendix C of Hong (2001) and every `k_*` value of the command line are in this convention.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SlantCoefficient(pub f64);

/// Earth-pressure coefficient normalised by the vertical depth: `K_H = 2 F / (gamma H^2 w)`.
///
/// Textbook formulas (Coulomb, Chen & Liu) are in this convention.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(transparent)]
pub struct DepthCoefficient(pub f64);

impl SlantCoefficient {
    /// The same force in the other normalisation: `K_H = K_L / sin(alpha)^2`.
    #[must_use]
    pub fn to_depth(self, tool_angle: Angle) -> DepthCoefficient {
        DepthCoefficient(self.0 / tool_angle.sin().powi(2))
    }
}

impl DepthCoefficient {
    /// The same force in the other normalisation: `K_L = K_H sin(alpha)^2`.
    #[must_use]
    pub fn to_slant(self, tool_angle: Angle) -> SlantCoefficient {
        SlantCoefficient(self.0 * tool_angle.sin().powi(2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_two_normalisations_are_inverse(k in 0.01..1e3, alpha in 20.0..140.0) {
            let alpha = Angle::from_degrees(alpha);
            let back = SlantCoefficient(k).to_depth(alpha).to_slant(alpha);
            prop_assert!((back.0 - k).abs() <= 1e-13 * k);
        }
    }
}
