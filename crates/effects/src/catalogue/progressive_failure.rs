use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, Response, Shape, Site, SoilSite};

/// Share of the deficit at a tool angle: none well below the middle, all of it well above.
fn share(alpha_deg: f64, middle_deg: f64) -> f64 {
    0.5 * (1.0 + libm::tanh((alpha_deg - middle_deg) / 4.0))
}

/// Friction is not fully mobilised where failure is gradual, so the force is read low, mostly at 90 deg and above:
/// `F' = F (1 - d s)` with the share `s = (1 + tanh((alpha - alpha_half) / 4 deg)) / 2`. The shape is the tool angle alpha_half
/// at which half of the deficit d is reached.
///
/// Source: Rowe & Peaker 1965 and Hong 2001, section 7.5.1, for the deficit and where it is; the course over the angle and the
/// strengths of the responses are empirical.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[85.0, 95.0] }),
    apply: |a, c| {
        c.ln_factor += libm::log((1.0 - a.amplitude * share(a.stroke.alpha_deg, a.shape)).max(1e-6));
        Ok(())
    },
    responses: &[
        Response { channel: Channel::PostSlope, mean: 0.4, sd: 0.4 },
        Response { channel: Channel::Displacement, mean: 0.1, sd: 0.1 },
        Response { channel: Channel::ResidualRatio, mean: 0.1, sd: 0.1 },
    ],
    response: |channel, shape, stroke, _| {
        let depth_m = if channel == Channel::Displacement { stroke.depth_m } else { 1.0 };
        depth_m * share(stroke.alpha_deg, shape)
    },
    ..Effect::new(
        EffectId::ProgressiveFailure,
        Site::Soil(SoilSite::Mobilisation),
        Parameter { name: "deficit", unit: "1" },
        Range::positive(0.05, 0.18),
    )
};
