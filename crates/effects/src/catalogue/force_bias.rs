use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, SensorSite, Shape, Site};

/// The zero of the sensor is off: `F' = F + b`, and free-air readings show b. An arm that takes them off each stroke (shape 1) reads the true
/// force.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[0.0, 1.0] }),
    needs: Some(Channel::AirAcross),
    apply: |a, c| {
        c.bias_n += if a.shape > 0.5 { 0.0 } else { a.amplitude };
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
