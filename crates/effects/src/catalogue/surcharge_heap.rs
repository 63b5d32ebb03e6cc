use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, Site, SurfaceSite};

/// Soil heaped ahead of the plate presses on the surface by q: a force `q L w N_q`. A heap of uniform height h presses with
/// `q = gamma h`, which is how heap heights tell.
///
/// Source: the load factor `N_q` is that of Chen & Liu's upper bound (see [`crate::DirectMechanics`]).
pub(super) static EFFECT: Effect = Effect {
    apply: |a, c| {
        c.surcharge_pa += a.amplitude;
        Ok(())
    },
    linked: &[Channel::HeapHeight],
    shift: |_, amplitude, _, reading| amplitude / reading.unit_weight_n_m3,
    ..Effect::new(
        EffectId::SurchargeHeap,
        Site::Surface(SurfaceSite::Load),
        Parameter { name: "surcharge_pa", unit: "Pa" },
        Range::positive(5.0, 150.0),
    )
};
