use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The soil is denser below: the force over the square of depth grows by the gradient for each metre, relative to
/// the mean depth.
pub(super) struct DensityGradient;

/// ln(1 + x), and what carries it on smoothly where that would leave no force.
fn ln_factor(x: f64) -> f64 {
    if x > -0.8 { x.ln_1p() } else { 0.2_f64.ln() + 5.0 * (x + 0.8) }
}

impl Effect for DensityGradient {
    fn id(&self) -> &'static str {
        "density_gradient"
    }

    fn title(&self) -> &'static str {
        "the soil is denser below"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "gradient_per_m", unit: "1/m" }
    }

    fn range(&self) -> Range {
        Range::either(2.0, 31.5)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        stroke: &Stroke,
        reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        c.ln_factor += ln_factor(amplitude * (stroke.depth_m - reference.depth_m));
        Ok(())
    }
}
