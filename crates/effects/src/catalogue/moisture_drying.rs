use super::EffectId;
use crate::{Covariate, Effect, Parameter, Range, Shape, Site, SoilSite};

/// Moist soil has an apparent cohesion that dries out: `c = c0 exp(-t / tau)`, with the time t from 0 (first stroke) to 1
/// (last) and, as shape, the time tau in which it falls to 1/e, as a fraction of the campaign.
///
/// Source: own; drying at a rate in proportion to what is left.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape {
        parameter: Some(Parameter { name: "decay_fraction", unit: "1" }),
        values: &[0.15, 0.3, 0.6, 1.2],
    }),
    varies_with: Some(Covariate::Time),
    apply: |a, c| {
        if let Some(time) = a.stroke.time_fraction {
            c.cohesion_pa += a.amplitude * libm::exp(-time / a.shape);
        }
        Ok(())
    },
    ..Effect::new(
        EffectId::MoistureDrying,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "cohesion_pa", unit: "Pa" },
        Range::positive(10.0, 200.0),
    )
};
