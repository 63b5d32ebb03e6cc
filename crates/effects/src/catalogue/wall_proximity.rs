use super::{Effect, distance};
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// A wall of the box stiffens the wedge; the change fades with distance. The amplitude is the relative change at no
/// distance, the shape the decay length in m.
pub(super) struct WallProximity;

impl Effect for WallProximity {
    fn id(&self) -> &'static str {
        "wall_proximity"
    }

    fn title(&self) -> &'static str {
        "a wall of the box is near"
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
        distance::fade(amplitude, shape, stroke.wall_m, c);
        Ok(())
    }
}
