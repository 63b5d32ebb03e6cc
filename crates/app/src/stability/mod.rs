//! Stability from the estimate, or on a soil as published: whether a slope, a footing or a wall stands for every such soil.

mod answer;
mod by_law;
pub mod climb;
mod factor;
mod layers;
mod region;
mod request;
mod search;
mod site;
mod words;

use std::time::Instant;

pub use answer::{Answer, FrictionBasis, SlopeAnswer, Trial, Verdict};
use region::Soils;
pub use request::Request;
use search::Search;
use site::Site;

use crate::{AppError, Watch};

/// Answers whether a problem stands.
///
/// # Errors
/// [`AppError`] if a file makes no sense, the friction of the strokes says nothing at the stresses of the problem, or nothing is proven.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let begun = Instant::now();
    let soils = Soils::read(&request.region)?;
    let site = Site::read(request, &soils)?;
    if soils.has_law() && site.is_wet() {
        return Err(AppError::Request(format!(
            "{}: it has water, and a law of stress is covered for dry soil only; estimate without --friction-law, in strokes or tests at the stresses of \
             this problem",
            request.problem.display()
        )));
    }
    if soils.has_law() && site.has_far_sides() {
        return Err(AppError::Request(format!(
            "{}: it has far sides, beyond which stresses are not looked at, and a law of stress has no end there; make them fixed or smooth, and the \
             section as wide and deep as what may slide",
            request.problem.display()
        )));
    }
    let search = Search::new(request, &site, &soils, watch)?;
    watch.begin(0, "stresses");
    let found = search.run();
    watch.end();
    let found = found?;
    let answer = match (found.lower, found.upper) {
        (Some(lower), _) if lower >= site.required() => Verdict::Stands,
        (_, Some(upper)) if upper < site.required() => Verdict::Fails,
        _ => Verdict::Depends,
    };
    let mut answer = Answer {
        title: site.title(),
        answer,
        quantity: site.asked(),
        required: site.required(),
        lower: found.lower,
        upper: found.upper,
        certified: found.lower.is_some() && found.upper.is_some(),
        soil: site.soil_name().to_owned(),
        phi_deg: found.phi_deg,
        friction_basis: found.basis,
        cohesion_pa: soils.cohesion_pa,
        density_kg_m3: soils.density_kg_m3,
        gravity_m_s2: site.gravity_m_s2(),
        slip_stress_pa: found.stress_pa,
        decisive_stress_pa: found.decisive_pa,
        tried_stress_pa: soils.tried_pa,
        stands_from_phi_deg: found.stands_from_deg,
        fails_to_phi_deg: found.fails_to_deg,
        trials: found.trials,
        by_slope: found.by_slope,
        verdict: String::new(),
        warnings: site.kept().into_iter().collect(),
        seconds: begun.elapsed().as_secs_f64(),
    };
    answer.verdict = words::verdict(&answer, soils.origin);
    answer.warnings.extend(words::warnings(&answer, request, &soils));
    Ok(answer)
}
