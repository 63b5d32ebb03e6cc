//! Whether the ground changes with depth: one soil, a gradient or a step, by strokes at several depths.

mod aliases;
mod answer;
mod hypotheses;
mod next;
mod request;
mod strokes;
mod words;

pub use answer::{Alias, Answer, Hypothesis, Kind, Level, NextDepth, Predicted, Ranges, StepSlice, Stroke};
pub use request::Request;
use strokes::Strokes;

use crate::estimate::{Inputs, Known};
use crate::{AppError, Watch, request as requests};

/// Steps that are told of: one soil, a gradient, the slices of a step, and two aliases.
const STEPS: u64 = 2 + hypotheses::SLICES as u64 + 2;

/// Finds what strokes leave of each way in which ground may go with depth.
///
/// # Errors
/// [`AppError`] if the request or the table makes no sense, strokes are at one depth, or a file cannot be read. That no ground explains the
/// strokes is an answer.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    requests::check(request)?;
    request.check()?;
    let (table, left_out) = strokes::table(request)?;
    let of_one_soil = request.of_one_soil();
    let known = Known::of(&of_one_soil, table, request.file.campaign()?)?;
    let strokes = Strokes::of(known.setup(&of_one_soil)?, &request.file.name())?;
    let candidates = next::candidates(request, &known.inputs, &strokes)?;
    let each_band = known.inputs.bands.as_ref().map(|bands| bands.pool.each);
    let of: Vec<_> = candidates.iter().map(|(_, stroke)| stroke.clone()).collect();
    watch.begin(STEPS, "hypotheses");
    let mut hypotheses = Vec::new();
    let mut forces = Vec::new();
    for kind in Kind::ALL {
        let (hypothesis, of_kind) = hypotheses::hypothesis(kind, &strokes, &of, each_band, watch)?;
        hypotheses.push(hypothesis);
        forces.push(of_kind);
    }
    // One soil without either is one with none of it: then they need not be asked.
    let plain = hypotheses.iter().any(|one| one.kind == Kind::OneSoil && one.consistent);
    let friction_law = aliases::friction_law(&known, &of_one_soil, plain)?;
    watch.advance(1);
    let cohesion = aliases::cohesion(&known, &of_one_soil, &strokes, plain)?;
    watch.advance(1);
    watch.end();
    let next_depths = next::depths(&candidates, &hypotheses, &forces, &strokes);
    let mut answer = Answer {
        model: known.model.id().into(),
        ends: known.ends,
        confidence: request.estimate.is_statistical().then_some(request.estimate.confidence),
        delta_deg: known.inputs.delta_deg.into(),
        depths_m: strokes.depths_m,
        step_searched_m: strokes.step_m,
        phi_searched_deg: strokes.start.phi_deg[0],
        density_searched_kg_m3: strokes.density_kg_m3,
        strokes: measured(&known.inputs, &strokes),
        hypotheses,
        friction_law,
        cohesion,
        next: next::best(&next_depths),
        next_depths,
        verdict: String::new(),
        warnings: Vec::new(),
    };
    answer.verdict = words::verdict(&answer);
    answer.warnings = words::warnings(&answer, &known.inputs, left_out);
    Ok(answer)
}

fn measured(inputs: &Inputs, strokes: &Strokes<'_>) -> Vec<Stroke> {
    let all = strokes.setup.observations.iter().zip(&strokes.strokes).zip(&inputs.measurements);
    all.map(|((observation, stroke), measurement)| {
        let normalised = |force_n: f64| 2.0 * force_n / stroke.unit_n;
        let band_n = [observation.low_n(), observation.high_n()];
        Stroke {
            label: observation.label().to_owned(),
            alpha_deg: observation.plate().tool_angle().degrees(),
            depth_m: observation.plate().depth_m(),
            count: measurement.count,
            force_n: observation.force_n(),
            band_n,
            normalised_kg_m3: normalised(observation.force_n()),
            normalised_band_kg_m3: band_n.map(normalised),
        }
    })
    .collect()
}
