use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Moist soil has an apparent cohesion that dries out; the shape is the time in which it falls to 1/e, as a
/// fraction of the campaign.
pub(super) struct MoistureDrying;

impl Effect for MoistureDrying {
    fn id(&self) -> &'static str {
        "moisture_drying"
    }

    fn title(&self) -> &'static str {
        "moisture dries out over the campaign"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "cohesion_pa", unit: "Pa" }
    }

    fn range(&self) -> Range {
        Range::positive(10.0, 200.0)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape {
            parameter: Some(Parameter { name: "decay_fraction", unit: "1" }),
            values: &[0.15, 0.3, 0.6, 1.2],
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
        if let Some(time) = stroke.time_fraction {
            c.cohesion_pa += amplitude * (-time / shape).exp();
        }
        Ok(())
    }
}
