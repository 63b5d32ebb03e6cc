use super::EffectId;
use crate::{Effect, Parameter, Range, Site, SoilSite};

/// The edge of the plate bears on the soil at low tool angles: a force that grows with depth, not with its square, and fades
/// towards 90 deg, `F' = F (1 + a max(0, (90 deg - alpha) / 20 deg) H0 / H)`. The amplitude is its share of the force at 70 deg
/// and the mean depth H0.
///
/// Source: own; the pressure under an edge grows with depth (Terzaghi 1943), the way it fades with the angle is assumed.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        let lean = ((90.0 - a.stroke.alpha_deg) / 20.0).max(0.0);
        c.ln_factor += libm::log1p(a.amplitude * lean * a.reference.depth_m / a.stroke.depth_m);
        Ok(())
    },
    ..Effect::new(
        EffectId::TipBearing,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "force_rel_70", unit: "1" },
        Range::positive(0.04, 0.25),
    )
};
