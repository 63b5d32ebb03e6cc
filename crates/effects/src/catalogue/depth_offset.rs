use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The touch-off is wrong: the true depth is the recorded one plus the offset.
pub(super) struct DepthOffset;

impl Effect for DepthOffset {
    fn id(&self) -> &'static str {
        "depth_offset"
    }

    fn title(&self) -> &'static str {
        "depths are off by a constant"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "offset_m", unit: "m" }
    }

    fn range(&self) -> Range {
        Range::either(0.0005, 0.0025)
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
        c.depth_m += amplitude;
        Ok(())
    }
}
