use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The reading depends on how far the arm reaches; the amplitude is its relative change from 12 in to 17 in.
pub(super) struct RadiusDependence;

impl Effect for RadiusDependence {
    fn id(&self) -> &'static str {
        "radius_dependence"
    }

    fn title(&self) -> &'static str {
        "the reading depends on the radius"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "radius_rel", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.03, 0.35)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.ln_factor += (amplitude * stroke.radius_position.unwrap_or(0.0)).max(-0.99).ln_1p();
        Ok(())
    }
}
