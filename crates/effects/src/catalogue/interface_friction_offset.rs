use super::{Effect, Reading, Response};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The true interface friction differs from the set-point: the plate lifts or sinks at failure.
pub(super) struct InterfaceFrictionOffset;

impl Effect for InterfaceFrictionOffset {
    fn id(&self) -> &'static str {
        "interface_friction_offset"
    }

    fn title(&self) -> &'static str {
        "interface friction differs from its set-point"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "offset_deg", unit: "deg" }
    }

    fn range(&self) -> Range {
        Range::either(3.0, 6.0)
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
        c.delta_deg = (c.delta_deg + amplitude).max(0.0);
        Ok(())
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::FrictionAngle]
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

    fn responses(&self) -> &'static [Response] {
        &[Response { channel: Channel::ZDrift, mean: 0.0, sd: 0.001 }]
    }

    fn response(&self, _channel: Channel, _shape: f64, _stroke: &Stroke, _reference: &Reference) -> f64 {
        1.0
    }
}
