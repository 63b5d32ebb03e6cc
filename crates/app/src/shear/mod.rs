//! The friction angle of direct-shear tests against normal stress.

mod answer;
mod at;
mod carry;
mod equivalent;
mod fits;
mod input;
mod raw;
mod raw_answer;
mod request;
mod stroke;

pub use answer::{
    AngleAt, Answer, Carried, Constant, Inputs, Point, PowerLaw, SlopeFloor, SoilAnswer, StrokeAnswer,
    StrokePoint,
};
pub use fits::Fitted;
use input::Input;
pub use raw::RawRequest;
pub use raw_answer::{Load, RawAnswer, Run};
pub use request::Request;
use soilctl_direct_shear::raw::RawAnalysis;
use stroke::Given;
pub use stroke::StrokeRequest;

use crate::{AppError, Watch, request as requests};

/// Curves and answer, with everything that figures are drawn from.
#[derive(Debug)]
pub struct Shear {
    /// The curves of each soil.
    pub fitted: Vec<Fitted>,
    /// The evaluated raw records, if the points come from such.
    pub records: Option<RawAnalysis>,
    /// The answer.
    pub answer: Answer,
}

/// Fits the curves of each soil, and reads angles off them.
///
/// # Errors
/// [`AppError`] if the request or the tests make no sense, no curve can be fitted, or a file cannot be read.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Shear, AppError> {
    requests::check(request)?;
    let fit_limit_pa = request.fit_limit_pa();
    let stroke = request.stroke.given()?;
    let Input { name, series, raw } = input::read(request)?;
    let analysis = raw.as_ref().map(|evaluated| &evaluated.analysis);
    let weights = analysis.map(RawAnalysis::weights);
    let mut warnings = analysis.map(|found| found.warnings.clone()).unwrap_or_default();
    let fitted: Vec<Fitted> =
        series.into_iter().map(|one| Fitted::of(one, weights.as_deref(), fit_limit_pa)).collect();
    if let Some(problem) = fits::nothing_fitted(&fitted) {
        return Err(AppError::Request(format!("{name}: no curve can be fitted: {problem}")));
    }
    let soils = fitted
        .iter()
        .map(|one| soil_answer(one, request, stroke.as_ref(), &mut warnings))
        .collect::<Result<Vec<_>, _>>()?;
    if stroke.is_some() && soils.iter().all(|soil| soil.stroke.is_none()) {
        return Err(AppError::Request(format!(
            "{name}: no soil gives a friction angle for this stroke: {}",
            warnings.join("; ")
        )));
    }
    let answer = Answer {
        fit_limit_pa,
        soils,
        raw: raw.as_ref().map(|evaluated| request.raw.answer(evaluated)),
        warnings,
    };
    Ok(Shear { fitted, records: raw.map(|evaluated| evaluated.analysis), answer })
}

fn soil_answer(
    fitted: &Fitted,
    request: &Request,
    stroke: Option<&Given>,
    warnings: &mut Vec<String>,
) -> Result<SoilAnswer, AppError> {
    for problem in &fitted.problems {
        warnings.push(format!("{}: {problem}", fitted.name()));
    }
    let at = at::angles(fitted, &request.stress_pa, warnings)?;
    let stroke = stroke.map(|given| given.friction(fitted, warnings)).transpose()?.flatten();
    Ok(SoilAnswer { at, stroke, ..fitted.answer() })
}
