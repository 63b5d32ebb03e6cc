//! `soilctl shear`: the friction angle of direct-shear tests against normal stress.

mod cells;
mod stroke;
mod words;

use std::path::PathBuf;

use soilctl_app::{Outcome, shear};
use soilctl_pages::shear::{Kind, save};

use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "FILE is a CSV file with the columns soil (optional), normal_stress_psi or normal_stress_pa, and \
    friction_angle_deg. Each soil gets a power law through its low loads, a slope that ends on a floor, and a \
    constant. Angles outside the stresses of a fit are extrapolated and marked so."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: shear::Request,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE", help_heading = "Figure")]
    plot: Option<PathBuf>,

    /// What --plot draws
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Kind::Fits, requires = "plot",
          requires_if("records", "raw"), help_heading = "Figure")]
    plot_kind: Kind,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let found = shear::run(&args.request, output)?;
    if let Some(path) = &args.plot {
        save(path, args.plot_kind, &found)?;
    }
    output.answer(&found.answer)?;
    Ok(Outcome::Done)
}
