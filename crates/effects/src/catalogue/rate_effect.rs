use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The force grows with a power of the speed.
pub(super) struct RateEffect;

impl Effect for RateEffect {
    fn id(&self) -> &'static str {
        "rate_effect"
    }

    fn title(&self) -> &'static str {
        "the force depends on speed"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "n", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::positive(0.02, 0.12)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.ln_factor += amplitude * stroke.ln_speed.unwrap_or(0.0);
        Ok(())
    }
}
