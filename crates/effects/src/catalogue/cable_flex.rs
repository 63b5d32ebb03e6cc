use super::{Effect, Reading};
use crate::{Channel, Parameter, Range, Shape, Stroke};

/// Cables stretch more than the flexion model takes out: displacement grows with force where the stretch is beyond all
/// encoders (shape 0), motor-side minus external position where it is between them (1), or both (2).
pub(super) struct CableFlex;

impl Effect for CableFlex {
    fn id(&self) -> &'static str {
        "cable_flex"
    }

    fn title(&self) -> &'static str {
        "cables stretch under load"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "compliance_m_per_n", unit: "m/N" }
    }

    fn range(&self) -> Range {
        Range::positive(0.0002, 0.0008)
    }

    fn acts_on_force(&self) -> bool {
        false
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::Displacement, Channel::MotorExtGap, Channel::GapSlope]
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[0.0, 1.0, 2.0] })
    }

    fn needs(&self, shape: f64) -> Option<Channel> {
        (shape > 0.5).then_some(Channel::GapSlope)
    }

    fn shift(
        &self,
        channel: Channel,
        amplitude: f64,
        shape: f64,
        _stroke: &Stroke,
        reading: &Reading,
    ) -> f64 {
        match (channel, shape > 0.5) {
            (Channel::Displacement, _) if shape > 0.5 && shape < 1.5 => 0.0,
            (Channel::Displacement, _) | (Channel::MotorExtGap, true) => amplitude * reading.force_n,
            (Channel::GapSlope, true) => amplitude,
            _ => 0.0,
        }
    }
}
