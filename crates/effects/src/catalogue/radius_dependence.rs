use super::EffectId;
use crate::{Covariate, Effect, Parameter, Range, Site, SoilSite};

/// The reading depends on how far the arm reaches: `F' = F (1 + a x)`, with x from 0 at 12 in to 1 at 17 in. Whether the place in
/// the box or the arm makes it is open, so it is simulated as a strength of the soil.
///
/// Source: own; linear between the two radii of Hong 2001, chapter 6.
pub(super) static EFFECT: Effect = Effect {
    varies_with: Some(Covariate::Radius),
    apply: |a, c| {
        c.scale(a.amplitude * a.stroke.radius_position.unwrap_or(0.0));
        Ok(())
    },
    ..Effect::new(
        EffectId::RadiusDependence,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "radius_rel", unit: "1" },
        Range::either(0.03, 0.35),
    )
};
