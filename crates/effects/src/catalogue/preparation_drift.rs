use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// Batches get denser or looser: the force changes steadily by the drift from the first batch to the last.
pub(super) struct PreparationDrift;

impl Effect for PreparationDrift {
    fn id(&self) -> &'static str {
        "preparation_drift"
    }

    fn title(&self) -> &'static str {
        "preparations drift from batch to batch"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "drift_rel", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.03, 0.4)
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
        c.ln_factor += (amplitude * stroke.batch_fraction.unwrap_or(0.0)).max(-0.99).ln_1p();
        Ok(())
    }
}
