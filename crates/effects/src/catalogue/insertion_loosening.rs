use super::{Effect, Response};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Pushing the plate in loosens dense soil around it; the loss of friction fades with depth over the shape's length
/// in m. The amplitude is the loss at the mean depth (Hong 2001, section 6.7).
pub(super) struct InsertionLoosening;

impl Effect for InsertionLoosening {
    fn id(&self) -> &'static str {
        "insertion_loosening"
    }

    fn title(&self) -> &'static str {
        "insertion of the plate loosens dense soil"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "loss_deg", unit: "deg" }
    }

    fn range(&self) -> Range {
        Range::positive(2.0, 15.0)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[0.012, 0.03, 0.1] })
    }

    fn apply(
        &self,
        amplitude: f64,
        shape: f64,
        stroke: &Stroke,
        reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.phi_deg -= amplitude * ((reference.depth_m - stroke.depth_m) / shape).exp();
        Ok(())
    }

    fn responses(&self) -> &'static [Response] {
        &[
            Response { channel: Channel::PostSlope, mean: 0.6, sd: 0.5 },
            Response { channel: Channel::ResidualRatio, mean: 0.2, sd: 0.15 },
        ]
    }

    fn response(&self, _channel: Channel, shape: f64, stroke: &Stroke, reference: &Reference) -> f64 {
        ((reference.depth_m - stroke.depth_m) / shape).exp()
    }
}
