use super::EffectId;
use crate::{Effect, Parameter, Range, SensorSite, Site};

/// The plate is not at the recorded angle: `alpha' = alpha + a`.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.alpha_deg += a.amplitude;
        Ok(())
    },
    ..Effect::new(
        EffectId::ToolAngleOffset,
        Site::Sensor(SensorSite::ToolAngle),
        Parameter { name: "offset_deg", unit: "deg" },
        Range::either(1.0, 5.0),
    )
};
