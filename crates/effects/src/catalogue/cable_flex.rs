use super::EffectId;
use crate::{Channel, DriveSite, Effect, Parameter, Range, Shape, Site};

/// Cables stretch by `C F` more than the flexion model takes out, with the compliance C as amplitude: displacement grows with
/// force where the stretch is beyond all encoders (shape 0), motor-side minus external position where it is between them (1),
/// or both (2).
///
/// Source: Hooke's law.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[0.0, 1.0, 2.0] }),
    needs: Some(Channel::GapSlope),
    linked: &[Channel::Displacement, Channel::MotorExtGap, Channel::GapSlope],
    shift: |channel, amplitude, shape, reading| match (channel, shape > 0.5) {
        (Channel::Displacement, _) if shape > 0.5 && shape < 1.5 => 0.0,
        (Channel::Displacement, _) | (Channel::MotorExtGap, true) => amplitude * reading.force_n,
        (Channel::GapSlope, true) => amplitude,
        _ => 0.0,
    },
    ..Effect::new(
        EffectId::CableFlex,
        Site::Drive(DriveSite::Stretch),
        Parameter { name: "compliance_m_per_n", unit: "m/N" },
        Range::positive(0.0002, 0.0008),
    )
};
