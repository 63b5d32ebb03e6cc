use super::{EffectId, distance};
use crate::{Covariate, Effect, Site, SoilSite};

/// A wall of the box stiffens the wedge: `F' = F (1 + a exp(-d / l))`, with the distance d to the nearest wall, the relative
/// change a at no distance and, as shape, the decay length l in m.
///
/// Source: own; an exponential decay is assumed.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(distance::DECAY),
    varies_with: Some(Covariate::Wall),
    apply: |a, c| distance::fade(a, a.stroke.wall_m, c),
    ..Effect::new(
        EffectId::WallProximity,
        Site::Soil(SoilSite::Strength),
        distance::AMPLITUDE,
        distance::RANGE,
    )
};
