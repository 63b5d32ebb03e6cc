use super::{Effect, Reading};
use crate::{Channel, Parameter, Range, Stroke};

/// Friction of the drive: the motors push harder than the soil pushes back.
pub(super) struct BackdriveFriction;

impl Effect for BackdriveFriction {
    fn id(&self) -> &'static str {
        "backdrive_friction"
    }

    fn title(&self) -> &'static str {
        "the drive takes force by friction"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "friction_n", unit: "N" }
    }

    fn range(&self) -> Range {
        Range::positive(1.1, 2.7)
    }

    fn acts_on_force(&self) -> bool {
        false
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::CmdMinusForce]
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
