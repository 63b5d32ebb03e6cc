use super::EffectId;
use crate::{Covariate, Effect, Parameter, Range, Site, SoilSite};

/// The force grows with a power of the speed: `F' = F (v / v0)^n` about the geometric mean v0 of the campaign's speeds.
///
/// Source: empirical power law.
pub(super) static EFFECT: Effect = Effect {
    varies_with: Some(Covariate::Speed),
    apply: |a, c| {
        c.ln_factor += a.amplitude * a.stroke.ln_speed.unwrap_or(0.0);
        Ok(())
    },
    ..Effect::new(
        EffectId::RateEffect,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "n", unit: "1" },
        Range::positive(0.02, 0.12),
    )
};
