use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// Friction falls with the logarithm of normal stress (Lee & Seed 1967; Hong 2001, section 6.6). The stress of a
/// stroke is the geometric mean of the weight of the soil above the edge and of the plate's pressure, so it grows
/// with depth and with the square root of the coefficient. The floor, above some 10 kPa, is beyond what a small
/// plate reaches.
pub(super) struct StressDependentFriction;

impl Effect for StressDependentFriction {
    fn id(&self) -> &'static str {
        "stress_dependent_friction"
    }

    fn title(&self) -> &'static str {
        "friction angle falls with normal stress"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "slope_deg_per_decade", unit: "deg" }
    }

    fn range(&self) -> Range {
        Range::positive(3.0, 6.0)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        stroke: &Stroke,
        reference: &Reference,
        c: &mut Conditions,
        mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        let here = mechanics.net(stroke.alpha_deg, 0.0, c.phi_deg, c.delta_deg)?.weight;
        let mean = mechanics.net(reference.alpha_deg, 0.0, c.phi_deg, c.delta_deg)?.weight;
        let decades = (stroke.depth_m / reference.depth_m).log10() + 0.5 * (here / mean).log10();
        c.phi_deg -= amplitude * decades;
        Ok(())
    }
}
