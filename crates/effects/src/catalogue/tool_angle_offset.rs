use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The plate is not at the recorded angle.
pub(super) struct ToolAngleOffset;

impl Effect for ToolAngleOffset {
    fn id(&self) -> &'static str {
        "tool_angle_offset"
    }

    fn title(&self) -> &'static str {
        "tool angles are off by a constant"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "offset_deg", unit: "deg" }
    }

    fn range(&self) -> Range {
        Range::either(1.0, 5.0)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.alpha_deg += amplitude;
        Ok(())
    }
}
