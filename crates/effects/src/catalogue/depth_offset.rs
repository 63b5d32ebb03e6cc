use super::EffectId;
use crate::{Effect, Parameter, Range, Site, SurfaceSite};

/// The touch-off is wrong: the true depth is the recorded one plus the offset, and the force grows with its square.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.depth_m += a.amplitude;
        Ok(())
    },
    ..Effect::new(
        EffectId::DepthOffset,
        Site::Surface(SurfaceSite::Height),
        Parameter { name: "offset_m", unit: "m" },
        Range::either(0.0005, 0.0025),
    )
};
