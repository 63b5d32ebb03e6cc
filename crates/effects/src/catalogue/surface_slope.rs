use super::EffectId;
use crate::{Covariate, Effect, Parameter, Range, Shape, Site, SurfaceSite};

/// The surface is a plane that is not level: a stroke at the base angle theta climbs by `beta = b cos(theta - theta0)`. The
/// shape is the azimuth theta0, in deg of base angle, at which a stroke climbs most.
///
/// Source: own derivation, for small slopes. About 5 % of force a degree (Hong 2001, section 6.7).
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape {
        parameter: Some(Parameter { name: "azimuth_deg", unit: "deg" }),
        values: &[
            -157.5, -135.0, -112.5, -90.0, -67.5, -45.0, -22.5, 0.0, 22.5, 45.0, 67.5, 90.0, 112.5, 135.0,
            157.5, 180.0,
        ],
    }),
    varies_with: Some(Covariate::BaseAngle),
    apply: |a, c| {
        if let Some(base_deg) = a.stroke.base_deg {
            c.beta_deg += a.amplitude * libm::cos((base_deg - a.shape).to_radians());
        }
        Ok(())
    },
    ..Effect::new(
        EffectId::SurfaceSlope,
        Site::Surface(SurfaceSite::Slope),
        Parameter { name: "slope_deg", unit: "deg" },
        Range::positive(2.0, 5.0),
    )
};
