use super::EffectId;
use crate::{Effect, Parameter, Range, Site, SoilSite};

/// Friction falls with the logarithm of normal stress: `phi' = phi - a log10(sigma / sigma0)`. The stress of a stroke is the
/// geometric mean of the weight of the soil above the edge and of the plate's pressure, so it grows with depth and with the
/// square root of the coefficient: `sigma / sigma0 = (H / H0) sqrt(K / K0)`, about the mean depth and tool angle.
///
/// Source: Lee & Seed 1967; Hong 2001, section 6.6, for the slope. The stress of a stroke: own derivation. A floor, above some
/// 10 kPa, is beyond what a small plate reaches.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        let here = a.mechanics.net(a.stroke.alpha_deg, 0.0, c.phi_deg, c.delta_deg)?.weight;
        let mean = a.mechanics.net(a.reference.alpha_deg, 0.0, c.phi_deg, c.delta_deg)?.weight;
        let decades = libm::log10(a.stroke.depth_m / a.reference.depth_m) + 0.5 * libm::log10(here / mean);
        c.phi_deg -= a.amplitude * decades;
        Ok(())
    },
    ..Effect::new(
        EffectId::StressDependentFriction,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "slope_deg_per_decade", unit: "deg" },
        Range::positive(3.0, 6.0),
    )
};
