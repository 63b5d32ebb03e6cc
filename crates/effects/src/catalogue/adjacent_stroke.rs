use super::{EffectId, distance};
use crate::{Covariate, Effect, Site, SoilSite};

/// Soil disturbed by an earlier stroke nearby: `F' = F (1 + a exp(-d / l))`, with the distance d to the nearest earlier
/// stroke, the relative change a at no distance and, as shape, the decay length l in m.
///
/// Source: own; an exponential decay is assumed.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(distance::DECAY),
    varies_with: Some(Covariate::PriorGap),
    apply: |a, c| distance::fade(a, a.stroke.gap_prior_m, c),
    ..Effect::new(
        EffectId::AdjacentStroke,
        Site::Soil(SoilSite::Strength),
        distance::AMPLITUDE,
        distance::RANGE,
    )
};
