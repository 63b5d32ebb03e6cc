//! `soilctl estimate`: every soil that could have produced the measured forces.

pub(crate) mod answer;
pub(crate) mod args;
pub(crate) mod exact;
pub(crate) mod figures;
pub(crate) mod inputs;
pub(crate) mod words;
pub(crate) mod work;

use std::path::PathBuf;

use clap::ValueEnum;

pub(crate) use answer::EstimateAnswer;
use args::EstimateArgs;

use super::Outcome;
use crate::error::CliError;
use crate::output::Output;

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Consistent friction angle and density, with the sections
    Region,
    /// The band of each measurement at the middle delta
    Bands,
    /// Consistent friction angle and interface friction
    PhiDelta,
    /// Consistent interface friction and density
    DeltaDensity,
    /// Measured coefficients over the tool angle, with the model
    Fit,
    /// Contours and their crossings for exact data
    Contours,
}

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(flatten)]
    estimate: EstimateArgs,

    /// Take the forces as exact: contour lines instead of bands
    #[arg(long)]
    exact: bool,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,

    /// What --plot draws; default region, or contours with --exact
    #[arg(long, value_name = "KIND", value_enum, requires = "plot")]
    plot_kind: Option<Kind>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let work = work::run(&args.estimate, args.exact)?;
    if let Some(path) = &args.plot {
        let default = if args.exact { Kind::Contours } else { Kind::Region };
        let figure = match args.plot_kind.unwrap_or(default) {
            Kind::Region => figures::region(&work)?,
            Kind::Bands => figures::bands(&work, &args.estimate)?,
            Kind::PhiDelta => figures::phi_delta(&work)?,
            Kind::DeltaDensity => figures::delta_density(&work)?,
            Kind::Fit => figures::fit(&work, &args.estimate)?,
            Kind::Contours => figures::contours(&work)?,
        };
        super::save_figure(&figure, path, soilctl_figure::Size::default())?;
    }
    output.answer(&work.answer)?;
    let found = match &work.answer.exact {
        Some(exact) => exact.best.is_some(),
        None => work.answer.consistent,
    };
    Ok(if found { Outcome::Done } else { Outcome::Negative })
}
