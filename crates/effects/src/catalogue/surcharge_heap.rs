use super::{Effect, Reading};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// Soil heaped ahead of the plate presses on the surface. A heap of uniform height h presses with density times
/// gravity times h, which is how heap heights tell.
pub(super) struct SurchargeHeap;

impl Effect for SurchargeHeap {
    fn id(&self) -> &'static str {
        "surcharge_heap"
    }

    fn title(&self) -> &'static str {
        "soil is heaped ahead of the plate"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "surcharge_pa", unit: "Pa" }
    }

    fn range(&self) -> Range {
        Range::positive(5.0, 150.0)
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
        c.surcharge_pa += amplitude;
        Ok(())
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::HeapHeight]
    }

    fn shift(
        &self,
        _channel: Channel,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        reading: &Reading,
    ) -> f64 {
        amplitude / reading.unit_weight_n_m3
    }
}
