use super::EffectId;
use crate::{Channel, Covariate, Effect, Parameter, Range, SensorSite, Site};

/// The zero of the sensor drifts steadily: `F' = F + b t`, with the time t from 0 (first stroke) to 1 (last); free-air
/// readings show it.
///
/// Source: own; linear in time.
pub(super) static EFFECT: Effect = Effect {
    varies_with: Some(Covariate::Time),
    apply: |a, c| {
        c.bias_n += a.amplitude * a.stroke.time_fraction.unwrap_or(0.0);
        Ok(())
    },
    linked: &[Channel::TareBefore, Channel::TareAfter],
    shift: |_, amplitude, _, reading| amplitude * reading.stroke.time_fraction.unwrap_or(0.0),
    ..Effect::new(
        EffectId::ForceDrift,
        Site::Sensor(SensorSite::ForceZeroDrift),
        Parameter { name: "drift_n", unit: "N" },
        Range::either(0.1, 1.0),
    )
};
