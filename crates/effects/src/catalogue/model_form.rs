use super::EffectId;
use crate::{Effect, Parameter, Range, Shape, Site};

/// Another force model holds: `ln F' = ln F + b (ln K_other - ln K)`. The shape is the index of the other model among
/// [`crate::ALTERNATIVE_MODELS`], the amplitude b how far the way to it is gone.
///
/// Source: own; a straight line between two models in the logarithm.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape {
        parameter: Some(Parameter { name: "model", unit: "1" }),
        values: &[0.0, 1.0, 2.0, 3.0],
    }),
    apply: |a, c| {
        // The index comes from the list of shapes.
        let which = a.shape as usize;
        c.ln_factor +=
            a.amplitude * a.mechanics.ln_alternative(which, a.stroke.alpha_deg, c.phi_deg, c.delta_deg)?;
        Ok(())
    },
    ..Effect::new(
        EffectId::ModelForm,
        Site::Model,
        Parameter { name: "blend", unit: "1" },
        Range::positive(0.8, 1.25),
    )
};
