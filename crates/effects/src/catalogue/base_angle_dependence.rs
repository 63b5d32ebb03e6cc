use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// The reading depends on the base angle. The amplitude is its relative change over the range of base angles: from
/// one end to the other (shape 1), or from the middle to the ends (shape 2).
pub(super) struct BaseAngleDependence;

impl Effect for BaseAngleDependence {
    fn id(&self) -> &'static str {
        "base_angle_dependence"
    }

    fn title(&self) -> &'static str {
        "the reading depends on the base angle"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "base_rel", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.03, 0.35)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[1.0, 2.0] })
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
        let x = stroke.base_position.unwrap_or(0.0);
        let pattern = if shape < 1.5 { 0.5 * x } else { x * x };
        c.ln_factor += (amplitude * pattern).max(-0.99).ln_1p();
        Ok(())
    }
}
