use super::EffectId;
use crate::{Effect, Parameter, Range, Site, SoilSite};

/// ln(1 + x), and the tangent in its place where that would leave no force.
fn ln_factor(x: f64) -> f64 {
    if x > -0.8 { libm::log1p(x) } else { libm::log(0.2_f64) + 5.0 * (x + 0.8) }
}

/// The soil is denser below: `F' = F (1 + g (H - H0))` about the mean depth H0, so g is the relative change of `F / H^2` a
/// metre.
///
/// Source: own; linear in depth. Below a fifth of the force the logarithm goes on along its tangent.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.ln_factor += ln_factor(a.amplitude * (a.stroke.depth_m - a.reference.depth_m));
        Ok(())
    },
    ..Effect::new(
        EffectId::DensityGradient,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "gradient_per_m", unit: "1/m" },
        Range::either(2.0, 31.5),
    )
};
