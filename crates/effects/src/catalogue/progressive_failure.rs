use super::{Effect, Response};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Friction is not fully mobilised where failure is gradual, so the force is read low (Rowe & Peaker 1965; Hong
/// 2001, section 7.5.1): mostly at 90 deg and above. The shape is the tool angle at which half of the deficit is
/// reached.
pub(super) struct ProgressiveFailure;

/// Share of the deficit at a tool angle: none well below the middle, all of it well above.
fn share(alpha_deg: f64, middle_deg: f64) -> f64 {
    0.5 * (1.0 + ((alpha_deg - middle_deg) / 4.0).tanh())
}

impl Effect for ProgressiveFailure {
    fn id(&self) -> &'static str {
        "progressive_failure"
    }

    fn title(&self) -> &'static str {
        "force read low where failure is gradual"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "deficit", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::positive(0.05, 0.18)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[85.0, 95.0] })
    }

    fn apply(
        &self,
        amplitude: f64,
        shape: f64,
        stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.ln_factor += (1.0 - amplitude * share(stroke.alpha_deg, shape)).max(1e-6).ln();
        Ok(())
    }

    fn responses(&self) -> &'static [Response] {
        &[
            Response { channel: Channel::PostSlope, mean: 0.4, sd: 0.4 },
            Response { channel: Channel::Displacement, mean: 0.1, sd: 0.1 },
            Response { channel: Channel::ResidualRatio, mean: 0.1, sd: 0.1 },
        ]
    }

    fn response(&self, channel: Channel, shape: f64, stroke: &Stroke, _reference: &Reference) -> f64 {
        let depth_m = if channel == Channel::Displacement { stroke.depth_m } else { 1.0 };
        depth_m * share(stroke.alpha_deg, shape)
    }
}
