use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// The surface is not level. The shape is the azimuth, in deg of base angle, at which a stroke climbs most; a
/// stroke at another base angle sees the cosine of the difference.
pub(super) struct SurfaceSlope;

impl Effect for SurfaceSlope {
    fn id(&self) -> &'static str {
        "surface_slope"
    }

    fn title(&self) -> &'static str {
        "the surface is not level"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "slope_deg", unit: "deg" }
    }

    fn range(&self) -> Range {
        Range::positive(2.0, 5.0)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape {
            parameter: Some(Parameter { name: "azimuth_deg", unit: "deg" }),
            values: &[
                -157.5, -135.0, -112.5, -90.0, -67.5, -45.0, -22.5, 0.0, 22.5, 45.0, 67.5, 90.0, 112.5,
                135.0, 157.5, 180.0,
            ],
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
        if let Some(base_deg) = stroke.base_deg {
            c.beta_deg += amplitude * (base_deg - shape).to_radians().cos();
        }
        Ok(())
    }
}
