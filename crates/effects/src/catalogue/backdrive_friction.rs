use super::EffectId;
use crate::{Channel, DriveSite, Effect, Parameter, Range, Site};

/// Friction of the drives: the motors push harder than the soil pushes back, by the amplitude in N.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    linked: &[Channel::CmdMinusForce],
    shift: |_, amplitude, _, _| amplitude,
    ..Effect::new(
        EffectId::BackdriveFriction,
        Site::Drive(DriveSite::Friction),
        Parameter { name: "friction_n", unit: "N" },
        Range::positive(1.1, 2.7),
    )
};
