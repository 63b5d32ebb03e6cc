use super::EffectId;
use crate::{Covariate, Effect, Parameter, Range, Site, SoilSite};

/// Preparations get denser or looser: `F' = F (1 + d b)`, with b from 0 (first batch) to 1 (last).
///
/// Source: own; linear in the number of the batch.
pub(super) static EFFECT: Effect = Effect {
    varies_with: Some(Covariate::Batch),
    apply: |a, c| {
        c.scale(a.amplitude * a.stroke.batch_fraction.unwrap_or(0.0));
        Ok(())
    },
    ..Effect::new(
        EffectId::PreparationDrift,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "drift_rel", unit: "1" },
        Range::either(0.03, 0.4),
    )
};
