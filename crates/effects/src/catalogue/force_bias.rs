use super::{Effect, Reading};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The zero of the sensor is off; free-air readings show it.
pub(super) struct ForceBias;

impl Effect for ForceBias {
    fn id(&self) -> &'static str {
        "force_bias"
    }

    fn title(&self) -> &'static str {
        "the sensor's zero is off"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "bias_n", unit: "N" }
    }

    fn range(&self) -> Range {
        Range::either(0.1, 0.5)
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
        c.bias_n += amplitude;
        Ok(())
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::TareBefore, Channel::TareAfter]
    }

    fn shift(
        &self,
        _channel: Channel,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        _reading: &Reading,
    ) -> f64 {
        amplitude
    }
}
