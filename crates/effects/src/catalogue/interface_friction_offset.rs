use super::{Effect, Reading, Response};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// The true interface friction differs from the set-point: the plate lifts or sinks at failure. The force turns to the true
/// friction once failed soil slips; before that it does so, too (shape 0), or a controller holds it at the set-point (1).
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
        &[Channel::FrictionAngle, Channel::SlipAngle]
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[0.0, 1.0] })
    }

    fn needs(&self, shape: f64) -> Option<Channel> {
        (shape > 0.5).then_some(Channel::SlipAngle)
    }

    fn shift(
        &self,
        channel: Channel,
        amplitude: f64,
        shape: f64,
        _stroke: &Stroke,
        _reading: &Reading,
    ) -> f64 {
        if channel == Channel::FrictionAngle && shape > 0.5 { 0.0 } else { amplitude }
    }

    fn responses(&self) -> &'static [Response] {
        &[Response { channel: Channel::ZDrift, mean: 0.0, sd: 0.001 }]
    }

    fn response(&self, _channel: Channel, _shape: f64, _stroke: &Stroke, _reference: &Reference) -> f64 {
        1.0
    }
}
