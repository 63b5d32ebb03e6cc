use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, SensorSite, Site};

/// The zero of the sensor is off: `F' = F + b`, and free-air readings show b.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.bias_n += a.amplitude;
        Ok(())
    },
    linked: &[Channel::TareBefore, Channel::TareAfter],
    shift: |_, amplitude, _, _| amplitude,
    ..Effect::new(
        EffectId::ForceBias,
        Site::Sensor(SensorSite::ForceZero),
        Parameter { name: "bias_n", unit: "N" },
        Range::either(0.1, 0.5),
    )
};
