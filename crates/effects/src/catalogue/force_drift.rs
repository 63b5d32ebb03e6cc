use super::{Effect, Reading};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The zero of the sensor drifts steadily over the campaign; the amplitude is the drift from the first to the last
/// stroke.
pub(super) struct ForceDrift;

impl Effect for ForceDrift {
    fn id(&self) -> &'static str {
        "force_drift"
    }

    fn title(&self) -> &'static str {
        "the sensor's zero drifts"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "drift_n", unit: "N" }
    }

    fn range(&self) -> Range {
        Range::either(0.1, 1.0)
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
        c.bias_n += amplitude * stroke.time_fraction.unwrap_or(0.0);
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
        stroke: &Stroke,
        _reading: &Reading,
    ) -> f64 {
        amplitude * stroke.time_fraction.unwrap_or(0.0)
    }
}
