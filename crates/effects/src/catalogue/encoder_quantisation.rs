use super::{Effect, Reading};
use crate::{Channel, Parameter, Range, Stroke};

/// Encoder steps at the tip are coarser than the instrument is said to have.
pub(super) struct EncoderQuantisation;

impl Effect for EncoderQuantisation {
    fn id(&self) -> &'static str {
        "encoder_quantisation"
    }

    fn title(&self) -> &'static str {
        "encoder steps are coarse"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "step_m", unit: "m" }
    }

    fn range(&self) -> Range {
        Range::positive(0.0004, 0.002)
    }

    fn acts_on_force(&self) -> bool {
        false
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::XStep]
    }

    fn shift(
        &self,
        _channel: Channel,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        reading: &Reading,
    ) -> f64 {
        (amplitude - reading.encoder_step_m).max(0.0)
    }
}
