//! `soilctl shear`: the friction angle of direct-shear tests against normal stress.

mod answer;
mod at;
mod carry;
mod equivalent;
mod fits;
mod input;
mod plot;
mod plot_fits;
mod plot_records;
mod raw;
mod raw_answer;
mod stroke;
mod words;
mod words_stroke;

use std::path::PathBuf;

pub(crate) use answer::ShearAnswer;
use answer::SoilAnswer;
use fits::Fitted;
use input::Input;
use soilctl_direct_shear::LogLogFit;
use soilctl_direct_shear::raw::RawAnalysis;
use soilctl_soil::units;
use stroke::Given;

use super::Outcome;
use crate::args::finite;
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "FILE is a CSV file with the columns soil (optional), normal_stress_psi or normal_stress_pa, and \
    friction_angle_deg. Each soil gets a power law through its low loads, a slope that ends on a floor, and a \
    constant. Angles outside the stresses of a fit are extrapolated and marked so."
)]
pub(crate) struct Args {
    /// Table of friction angles against normal stress
    #[arg(value_name = "FILE", required_unless_present = "raw", conflicts_with = "raw")]
    file: Option<PathBuf>,

    /// Only this soil of FILE (may be repeated)
    #[arg(long, value_name = "NAME", conflicts_with = "raw")]
    soil: Vec<String>,

    /// The power law is fitted to the loads below this normal stress (Pa); 2.5 psi = 17237 Pa if not given
    #[arg(long, value_name = "PA", value_parser = finite, allow_negative_numbers = true)]
    fit_limit: Option<f64>,

    /// Gives the friction angle at this normal stress (Pa; may be repeated, or a list with commas)
    #[arg(long, value_name = "PA", value_parser = finite, allow_negative_numbers = true, value_delimiter = ',')]
    stress: Vec<f64>,

    #[command(flatten, next_help_heading = "Raw records, with --raw instead of FILE")]
    raw: raw::RawArgs,

    #[command(flatten, next_help_heading = "Stroke of a plate")]
    stroke: stroke::StrokeArgs,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE", help_heading = "Figure")]
    plot: Option<PathBuf>,

    /// What --plot draws
    #[arg(long, value_name = "KIND", value_enum, default_value_t = plot::Kind::Fits, requires = "plot",
          requires_if("records", "raw"), help_heading = "Figure")]
    plot_kind: plot::Kind,
}

impl Args {
    fn checked_fit_limit(&self) -> Result<f64, CliError> {
        match self.fit_limit {
            None => Ok(units::psi_to_pa(LogLogFit::DEFAULT_LIMIT_PSI)),
            Some(limit) if limit > 0.0 => Ok(limit),
            Some(limit) => Err(CliError::Usage(format!("--fit-limit is {limit} Pa; it must be above 0 Pa"))),
        }
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let fit_limit_pa = args.checked_fit_limit()?;
    let stroke = args.stroke.given()?;
    let Input { name, series, raw } = input::read(args)?;
    let analysis = raw.as_ref().map(|evaluated| &evaluated.analysis);
    let weights = analysis.map(RawAnalysis::weights);
    let mut warnings = analysis.map(|found| found.warnings.clone()).unwrap_or_default();
    let fitted: Vec<Fitted> =
        series.into_iter().map(|one| Fitted::of(one, weights.as_deref(), fit_limit_pa)).collect();
    if let Some(problem) = fits::nothing_fitted(&fitted) {
        return Err(CliError::Usage(format!("{name}: no curve can be fitted: {problem}")));
    }
    let soils = fitted
        .iter()
        .map(|one| soil_answer(one, args, stroke.as_ref(), &mut warnings))
        .collect::<Result<Vec<_>, _>>()?;
    if stroke.is_some() && soils.iter().all(|soil| soil.stroke.is_none()) {
        return Err(CliError::Usage(format!(
            "{name}: no soil gives a friction angle for this stroke: {}",
            warnings.join("; ")
        )));
    }
    if let Some(path) = &args.plot {
        plot::draw(path, args.plot_kind, &fitted, &soils, analysis)?;
    }
    let raw = raw.as_ref().map(|evaluated| args.raw.answer(evaluated));
    output.answer(&ShearAnswer { fit_limit_pa, soils, raw, warnings })?;
    Ok(Outcome::Done)
}

fn soil_answer(
    fitted: &Fitted,
    args: &Args,
    stroke: Option<&Given>,
    warnings: &mut Vec<String>,
) -> Result<SoilAnswer, CliError> {
    for problem in &fitted.problems {
        warnings.push(format!("{}: {problem}", fitted.name()));
    }
    let at = at::angles(fitted, &args.stress, warnings)?;
    let stroke = stroke.map(|given| given.friction(fitted, warnings)).transpose()?.flatten();
    Ok(SoilAnswer { at, stroke, ..fitted.answer() })
}
