//! `soilctl predict`: force and coefficients of a plate from a named model.

mod answer;
mod chosen;
mod curves;
mod patched;
mod plot;
mod single;
mod strokes;
mod surfaces;

use std::path::PathBuf;

pub(crate) use answer::Prediction;
use soilctl_earth_pressure::Loads;
use soilctl_soil::SoilError;

use super::Outcome;
use crate::args::{LoadArgs, NumberOrColumn, finite};
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Coefficients are per slant length, K = 2 F / (gamma L^2 w) with L = depth / sin(alpha); the net \
    one is passive minus active. Without --depth, --width and --density the force is null."
)]
pub(crate) struct Args {
    /// Model: coulomb, log-spiral, log-spiral-thesis, caquot, chen, thesis-ub, thesis-lb, table
    #[arg(long, value_name = "NAME", default_value = "chen")]
    model: String,

    /// A table file (.csv or .parquet) as the model
    #[arg(long, value_name = "FILE", conflicts_with = "model")]
    model_table: Option<PathBuf>,

    /// Tool angle from the horizontal (deg)
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true,
          required_unless_present = "strokes", conflicts_with = "strokes")]
    alpha: Option<f64>,

    /// A model file, such as the patch of `diagnose`: force model, soil and effects; --phi, --delta and --density
    /// replace its values
    #[arg(long, value_name = "PATCH", conflicts_with_all = ["model", "model_table", "plot", "cohesion", "adhesion",
          "surcharge", "beta"])]
    model_file: Option<PathBuf>,

    /// Internal friction angle of the soil (deg)
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true,
          required_unless_present = "model_file")]
    phi: Option<f64>,

    /// Friction angle between soil and plate (deg), or `column` for delta_set_deg of --strokes
    #[arg(
        long,
        value_name = "DEG|column",
        allow_negative_numbers = true,
        required_unless_present = "model_file"
    )]
    delta: Option<NumberOrColumn>,

    /// Bulk density (kg/m3), or `column` for density_kg_m3 of --strokes
    #[arg(long, value_name = "KG/M3|column", allow_negative_numbers = true)]
    density: Option<NumberOrColumn>,

    /// Vertical depth of the plate's lower edge below the surface (m)
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true,
          conflicts_with = "strokes")]
    depth: Option<f64>,

    /// Width of the plate (m)
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true,
          conflicts_with = "strokes")]
    width: Option<f64>,

    #[command(flatten)]
    loads: LoadArgs,

    /// A stroke table: one prediction a row, with alpha, depth and width from the file
    #[arg(long, value_name = "FILE")]
    strokes: Option<PathBuf>,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE", conflicts_with = "strokes")]
    plot: Option<PathBuf>,

    /// What --plot draws
    #[arg(long, value_name = "KIND", value_enum, default_value_t = plot::Kind::Surface, requires = "plot")]
    plot_kind: plot::Kind,
}

impl Args {
    /// The friction angle; required wherever it is asked for.
    fn phi(&self) -> Result<f64, CliError> {
        self.phi.ok_or_else(|| CliError::Usage("give --phi DEG".into()))
    }

    /// Where the interface friction comes from; required wherever it is asked for.
    fn delta(&self) -> Result<NumberOrColumn, CliError> {
        self.delta.ok_or_else(|| CliError::Usage("give --delta DEG".into()))
    }

    /// The loads, checked.
    fn checked_loads(&self) -> Result<Loads, SoilError> {
        let surcharge = self.loads.surcharge;
        if surcharge < 0.0 {
            return Err(SoilError::OutOfRange {
                quantity: "surcharge",
                value: surcharge,
                unit: "Pa",
                allowed: "at least 0 Pa",
            });
        }
        Ok(Loads {
            cohesion_pa: self.loads.cohesion,
            adhesion_pa: self.loads.adhesion,
            surcharge_pa: surcharge,
        })
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    if let Some(path) = &args.model_file {
        output.answer(&patched::predict(args, path)?)?;
        return Ok(Outcome::Done);
    }
    let answer = match (&args.strokes, args.alpha) {
        (Some(path), _) => strokes::predict(args, path)?,
        (None, Some(alpha)) => single::predict(args, alpha)?,
        (None, None) => return Err(CliError::Usage("give --alpha DEG or --strokes FILE".into())),
    };
    if let (Some(path), Some(alpha)) = (&args.plot, args.alpha) {
        plot::plot_predict(path, args.plot_kind, single::case(args, alpha)?, output)?;
    }
    output.answer(&answer)?;
    Ok(Outcome::Done)
}
