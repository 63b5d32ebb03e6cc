use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Soil disturbed by an earlier stroke nearby; the change fades with distance. The amplitude is the relative change
/// at no distance, the shape the decay length in m.
pub(super) struct AdjacentStroke;

impl Effect for AdjacentStroke {
    fn id(&self) -> &'static str {
        "adjacent_stroke"
    }

    fn title(&self) -> &'static str {
        "earlier strokes disturbed the soil"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "amplitude", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.06, 0.5)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape {
            parameter: Some(Parameter { name: "decay_m", unit: "m" }),
            values: &[0.02, 0.035, 0.06, 0.1, 0.15],
        })
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
        if let Some(distance_m) = stroke.gap_prior_m {
            c.ln_factor += (amplitude * (-distance_m / shape).exp()).max(-0.99).ln_1p();
        }
        Ok(())
    }
}
