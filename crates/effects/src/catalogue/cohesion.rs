use super::EffectId;
use crate::{Effect, Parameter, Range, Site, SoilSite};

/// Cohesion c of the soil (Coulomb's `tau = c + sigma tan phi`): a force `c L w N_c` that grows with depth, not with its
/// square.
///
/// Source: the load factor `N_c` is that of Chen & Liu's upper bound (see [`crate::DirectMechanics`]).
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.cohesion_pa += a.amplitude;
        Ok(())
    },
    ..Effect::new(
        EffectId::Cohesion,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "cohesion_pa", unit: "Pa" },
        Range::positive(10.0, 200.0),
    )
};
