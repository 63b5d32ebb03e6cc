use super::Effect;
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
        if let Some(distance_m) = stroke.wall_m {
            c.ln_factor += (amplitude * (-distance_m / shape).exp()).max(-0.99).ln_1p();
        }
        Ok(())
    }
}
