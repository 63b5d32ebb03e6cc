//! `soilctl estimate`: every soil that could have produced the measured forces.

mod words;

use std::path::PathBuf;

use soilctl_app::{Answer, Outcome, estimate};
use soilctl_pages::estimate::{Kind, figure};

use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(flatten)]
    request: estimate::Request,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,

    /// What --plot draws; default region, or contours with --exact
    #[arg(long, value_name = "KIND", value_enum, requires = "plot")]
    plot_kind: Option<Kind>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let found = estimate::run(&args.request, output)?;
    if let Some(path) = &args.plot {
        soilctl_pages::save_figure(&figure(&found, args.plot_kind)?, path, soilctl_figure::Size::default())?;
    }
    output.answer(&found.answer)?;
    Ok(found.answer.outcome())
}
