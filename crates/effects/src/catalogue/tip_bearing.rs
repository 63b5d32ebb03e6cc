use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Stroke};

/// The edge of the plate bears on the soil at low tool angles: a force that grows with depth, not with its square,
/// and fades towards 90 deg. The amplitude is its share of the force at 70 deg and the mean depth.
pub(super) struct TipBearing;

impl Effect for TipBearing {
    fn id(&self) -> &'static str {
        "tip_bearing"
    }

    fn title(&self) -> &'static str {
        "the edge bears on the soil at low tool angles"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "force_rel_70", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::positive(0.04, 0.25)
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
        let lean = ((90.0 - stroke.alpha_deg) / 20.0).max(0.0);
        c.ln_factor += (amplitude * lean * reference.depth_m / stroke.depth_m).ln_1p();
        Ok(())
    }
}
