use super::EffectId;
use crate::{Effect, Parameter, Range, SensorSite, Site};

/// The gain of the sensor is off: `F' = F (1 + s)`.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.scale(a.amplitude);
        Ok(())
    },
    ..Effect::new(
        EffectId::ForceScale,
        Site::Sensor(SensorSite::ForceGain),
        Parameter { name: "scale", unit: "1" },
        Range::either(0.03, 0.15),
    )
};
