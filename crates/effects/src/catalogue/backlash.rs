use super::EffectId;
use crate::{Channel, DriveSite, Effect, Parameter, Range, Site};

/// Free play between motor and joint, as far as one-sided load leaves it: the motors' side of an axis is ahead of the
/// external encoder by the amplitude in m.
///
/// Source: definition.
pub(super) static EFFECT: Effect = Effect {
    linked: &[Channel::MotorExtGap],
    shift: |_, amplitude, _, _| amplitude,
    ..Effect::new(
        EffectId::Backlash,
        Site::Drive(DriveSite::FreePlay),
        Parameter { name: "gap_m", unit: "m" },
        Range::positive(0.0004, 0.0012),
    )
};
