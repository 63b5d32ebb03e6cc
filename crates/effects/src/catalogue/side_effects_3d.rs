use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The ends of a plate of finite width shear soil too: a factor 1 + kappa H / w.
pub(super) struct SideEffects;

impl Effect for SideEffects {
    fn id(&self) -> &'static str {
        "side_effects_3d"
    }

    fn title(&self) -> &'static str {
        "soil shears at the ends of the plate"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "kappa", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::positive(0.2, 3.0)
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
        c.ln_factor += (amplitude * stroke.depth_m / stroke.width_m).ln_1p();
        Ok(())
    }
}
