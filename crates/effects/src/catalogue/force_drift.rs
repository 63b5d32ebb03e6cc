use super::EffectId;
use crate::{Channel, Covariate, Effect, Parameter, Range, SensorSite, Shape, Site};

/// The zero of the sensor drifts steadily: `F' = F + b t`, with the time t from 0 (first stroke) to 1 (last); free-air
/// readings show it. An arm that takes them off each stroke (shape 1) reads the true force.
///
/// Source: own; linear in time.
pub(super) static EFFECT: Effect = Effect {
    varies_with: Some(Covariate::Time),
    shape: Some(Shape { parameter: None, values: &[0.0, 1.0] }),
    needs: Some(Channel::AirAcross),
    apply: |a, c| {
        let drift_n = a.amplitude * a.stroke.time_fraction.unwrap_or(0.0);
        c.bias_n += if a.shape > 0.5 { 0.0 } else { drift_n };
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
