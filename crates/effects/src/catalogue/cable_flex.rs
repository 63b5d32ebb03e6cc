use super::{Effect, Reading};
use crate::{Channel, Parameter, Range, Stroke};

/// Cables stretch more than the flexion model takes out: displacement grows with force.
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
        &[Channel::Displacement]
    }

    fn shift(
        &self,
        _channel: Channel,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        reading: &Reading,
    ) -> f64 {
        amplitude * reading.force_n
    }
}
