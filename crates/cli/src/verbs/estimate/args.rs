//! Options of an estimate, shared by `estimate` and `report`.

use std::path::PathBuf;

use clap::ValueEnum;

use crate::args::{LoadArgs, NumberOrColumn, finite};
use crate::error::CliError;

/// What a force's uncertainty means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Uncertainty {
    /// Bands of `--sigma` standard deviations
    Sigma,
    /// Hard bounds: `force_sd_n` is the half width, a group spans its least to its greatest force
    Bounds,
}

#[derive(Debug, clap::Args)]
pub(crate) struct EstimateArgs {
    /// Stroke table (CSV)
    pub(crate) file: PathBuf,

    /// Model: table (the bracket of bounds), thesis-ub, thesis-lb, chen, caquot, log-spiral, log-spiral-thesis, coulomb
    #[arg(long, value_name = "NAME", default_value = "table")]
    pub(crate) model: String,

    /// A model file, such as the patch of `diagnose`: its effects are taken out of the measured forces first, at the
    /// soil of the file
    #[arg(long, value_name = "PATCH")]
    pub(crate) model_file: Option<PathBuf>,

    /// Friction angle between soil and plate (deg), or `column` for delta_set_deg of the table
    #[arg(long, value_name = "DEG|column", allow_negative_numbers = true)]
    pub(crate) delta: NumberOrColumn,

    /// Half width of what is known of delta (deg)
    #[arg(long, value_name = "DEG", default_value_t = 1.0, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) delta_tol: f64,

    /// Bulk density (kg/m3), or `column` for density_kg_m3 of the table; left out: unknown
    #[arg(long, value_name = "KG/M3|column", allow_negative_numbers = true)]
    pub(crate) density: Option<NumberOrColumn>,

    /// Relative half width of what is known of the density
    #[arg(long, value_name = "FRACTION", default_value_t = 0.04, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) density_tol: f64,

    /// Standard deviations that a band reaches on either side of the force [default: 1]
    #[arg(long, value_name = "K", value_parser = finite, allow_negative_numbers = true)]
    pub(crate) sigma: Option<f64>,

    /// What the uncertainty of a force means
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Uncertainty::Sigma)]
    pub(crate) uncertainty: Uncertainty,

    /// Allow that forces at tool angles of 90 deg and more were read low by up to this fraction, because friction was
    /// not fully mobilised when failure was read (0.1 in Hong 2001, section 7.5.1)
    #[arg(long, value_name = "FRACTION", default_value_t = 0.0, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) adjust_high_angles: f64,

    /// Friction angles to search (deg), LOW:HIGH
    #[arg(long, value_name = "LOW:HIGH", value_parser = range)]
    pub(crate) phi_range: Option<(f64, f64)>,

    #[command(flatten)]
    pub(crate) loads: LoadArgs,

    /// Values of delta at which sections are shown (deg); default: the ends and the middle
    #[arg(long, value_name = "DEG,...", value_delimiter = ',', value_parser = finite)]
    pub(crate) sections: Vec<f64>,

    /// Rank the next strokes by how much they would shrink the region
    #[arg(long)]
    pub(crate) next_strokes: bool,

    /// Tool angles to consider for the next stroke (deg)
    #[arg(long, value_name = "DEG,...", value_delimiter = ',', value_parser = finite,
          default_value = "40,50,60,70,80,90,100,110", requires = "next_strokes")]
    pub(crate) next_alpha: Vec<f64>,

    /// Depths to consider for the next stroke (m); default: the depths of the table
    #[arg(long, value_name = "M,...", value_delimiter = ',', value_parser = finite, requires = "next_strokes")]
    pub(crate) next_depth: Vec<f64>,

    /// Greatest force the arm can exert (N); dearer strokes are left out
    #[arg(long, value_name = "N", value_parser = finite, requires = "next_strokes")]
    pub(crate) force_limit: Option<f64>,

    /// Also run what one would otherwise use, downhill simplex and Levenberg-Marquardt from many starts
    #[arg(long)]
    pub(crate) compare: bool,
}

impl EstimateArgs {
    /// Standard deviations on either side; bounds know none.
    pub(crate) fn sigma(&self) -> Result<f64, CliError> {
        match (self.sigma, self.uncertainty) {
            (Some(_), Uncertainty::Bounds) => {
                Err(CliError::Usage("--sigma has no meaning with --uncertainty bounds; leave one out".into()))
            }
            (Some(sigma), _) if sigma <= 0.0 => {
                Err(CliError::Usage(format!("--sigma is {sigma}; it must be above 0")))
            }
            (sigma, _) => Ok(sigma.unwrap_or(1.0)),
        }
    }

    /// What a band is, in words.
    pub(crate) fn band_in_words(&self) -> String {
        match self.uncertainty {
            Uncertainty::Sigma => format!("bands of {} σ", crate::text::number(self.sigma.unwrap_or(1.0))),
            Uncertainty::Bounds => "bands between hard bounds".into(),
        }
    }
}

fn range(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once(':').ok_or("it must be LOW:HIGH, such as 30:45")?;
    let (low, high) = (finite(low)?, finite(high)?);
    if low < high { Ok((low, high)) } else { Err("LOW must be below HIGH".into()) }
}
