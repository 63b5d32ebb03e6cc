use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, SensorSite, Site};

/// Encoder steps at the tip are coarser than the instrument is said to have; the amplitude is the true step.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    linked: &[Channel::XStep],
    shift: |_, amplitude, _, reading| (amplitude - reading.encoder_step_m).max(0.0),
    ..Effect::new(
        EffectId::EncoderQuantisation,
        Site::Sensor(SensorSite::EncoderStep),
        Parameter { name: "step_m", unit: "m" },
        Range::positive(0.0004, 0.002),
    )
};
