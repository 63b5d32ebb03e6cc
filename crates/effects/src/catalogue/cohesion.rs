use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// Cohesion or adhesion of the soil: a force that grows with depth, not with its square.
pub(super) struct Cohesion;

impl Effect for Cohesion {
    fn id(&self) -> &'static str {
        "cohesion"
    }

    fn title(&self) -> &'static str {
        "the soil has cohesion"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "cohesion_pa", unit: "Pa" }
    }

    fn range(&self) -> Range {
        Range::positive(10.0, 200.0)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.cohesion_pa += amplitude;
        Ok(())
    }
}
