use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Another force model holds. The shape is its index among the alternatives, the amplitude how far the way to it is
/// gone.
pub(super) struct ModelForm;

impl Effect for ModelForm {
    fn id(&self) -> &'static str {
        "model_form"
    }

    fn title(&self) -> &'static str {
        "another force model holds"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "blend", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::positive(0.8, 1.25)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: Some(Parameter { name: "model", unit: "1" }), values: &[0.0, 1.0, 2.0, 3.0] })
    }

    fn apply(
        &self,
        amplitude: f64,
        shape: f64,
        stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        // The index comes from the list of shapes.
        let which = shape as usize;
        c.ln_factor +=
            amplitude * mechanics.ln_alternative(which, stroke.alpha_deg, c.phi_deg, c.delta_deg)?;
        Ok(())
    }
}
