use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, Response, Shape, Site};

/// The true interface friction differs from the set-point, `delta' = delta + a`: the plate lifts or sinks at failure. The
/// force turns to the true friction once failed soil slips; before that it does so, too (shape 0), or a controller holds it
/// at the set-point (1). Soil that fails while the force is held below its friction has the strength of the held angle; held above it, that of
/// its own (2).
///
/// Source: definition. Strength of the drift in height: empirical, of the order of a millimetre either way.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[0.0, 1.0, 2.0] }),
    needs: Some(Channel::SlipAngle),
    apply: |a, c| {
        let mobilised = if a.shape > 1.5 { a.amplitude.min(0.0) } else { a.amplitude };
        c.delta_deg = (c.delta_deg + mobilised).max(0.0);
        Ok(())
    },
    linked: &[Channel::FrictionAngle, Channel::SlipAngle],
    shift: |channel, amplitude, shape, _| {
        if channel == Channel::FrictionAngle && shape > 0.5 { 0.0 } else { amplitude }
    },
    responses: &[Response { channel: Channel::ZDrift, mean: 0.0, sd: 0.001 }],
    response: |_, _, _, _| 1.0,
    ..Effect::new(
        EffectId::InterfaceFrictionOffset,
        Site::Interface,
        Parameter { name: "offset_deg", unit: "deg" },
        Range::either(3.0, 6.0),
    )
};
