use super::{Effect, Reading};
use crate::{Channel, Parameter, Range, Stroke};

/// Free play between motor and joint, as far as one-sided load leaves it.
pub(super) struct Backlash;

impl Effect for Backlash {
    fn id(&self) -> &'static str {
        "backlash"
    }

    fn title(&self) -> &'static str {
        "free play between motor and joint"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "gap_m", unit: "m" }
    }

    fn range(&self) -> Range {
        Range::positive(0.0004, 0.0012)
    }

    fn acts_on_force(&self) -> bool {
        false
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::MotorExtGap]
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
