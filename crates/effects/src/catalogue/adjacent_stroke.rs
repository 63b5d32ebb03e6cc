use super::{Effect, distance};
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
        distance::AMPLITUDE
    }

    fn range(&self) -> Range {
        distance::range()
    }

    fn shape(&self) -> Option<Shape> {
        Some(distance::DECAY)
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
        distance::fade(amplitude, shape, stroke.gap_prior_m, c);
        Ok(())
    }
}
