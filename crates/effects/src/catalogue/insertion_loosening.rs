use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, Reference, Response, Shape, Site, SoilSite, Stroke};

/// How much of the loss at the mean depth there is at the depth of a stroke.
fn share(length_m: f64, stroke: &Stroke, reference: &Reference) -> f64 {
    libm::exp((reference.depth_m - stroke.depth_m) / length_m)
}

/// Pushing the plate in loosens dense soil around it: `phi' = phi - a exp((H0 - H) / l)`, with the loss a at the mean depth H0
/// and, as shape, the length l in m over which it fades. Loose soil has no peak to fall from, which the slope after the break
/// and the residual show.
///
/// Source: Hong 2001, section 6.7, for the loss; an exponential decay is assumed. Strengths of the responses: empirical, from
/// a post-break slope and a residual ratio of dense sand of about -0.6 and 0.8 to none and 1.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[0.012, 0.03, 0.1] }),
    apply: |a, c| {
        c.phi_deg -= a.amplitude * share(a.shape, a.stroke, a.reference);
        Ok(())
    },
    responses: &[
        Response { channel: Channel::PostSlope, mean: 0.6, sd: 0.5 },
        Response { channel: Channel::ResidualRatio, mean: 0.2, sd: 0.15 },
    ],
    response: |_, shape, stroke, reference| share(shape, stroke, reference),
    ..Effect::new(
        EffectId::InsertionLoosening,
        Site::Soil(SoilSite::Loosening),
        Parameter { name: "loss_deg", unit: "deg" },
        Range::positive(2.0, 15.0),
    )
};
