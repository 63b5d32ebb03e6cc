use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The gain of the sensor is off; the scale is read over true force, minus 1.
pub(super) struct ForceScale;

impl Effect for ForceScale {
    fn id(&self) -> &'static str {
        "force_scale"
    }

    fn title(&self) -> &'static str {
        "the sensor's gain is off"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "scale", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.03, 0.15)
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
        c.ln_factor += amplitude.max(-0.99).ln_1p();
        Ok(())
    }
}
