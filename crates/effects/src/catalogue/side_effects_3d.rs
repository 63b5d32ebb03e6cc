use super::EffectId;
use crate::{Effect, Parameter, Range, Site, SoilSite};

/// The ends of a plate of finite width shear soil too: `F' = F (1 + kappa H / w)`.
///
/// Source: own derivation. The surfaces that shear at the two ends grow with the square of the depth H, the slip surface
/// between them with H times the width w.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.ln_factor += libm::log1p(a.amplitude * a.stroke.depth_m / a.stroke.width_m);
        Ok(())
    },
    ..Effect::new(
        EffectId::SideEffects3d,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "kappa", unit: "1" },
        Range::positive(0.2, 3.0),
    )
};
