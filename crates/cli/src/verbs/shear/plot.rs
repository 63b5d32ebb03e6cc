//! The figures of `shear --plot`.

use std::path::Path;

use clap::ValueEnum;
use soilctl_direct_shear::raw::RawAnalysis;
use soilctl_figure::Size;

use super::answer::SoilAnswer;
use super::fits::Fitted;
use super::{plot_fits, plot_records};
use crate::error::CliError;
use crate::verbs::save_figure;

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// Friction angle against normal stress, with the curves
    Fits,
    /// Friction angle against displacement of every run; needs --raw
    Records,
}

/// Draws a figure into a file.
pub(super) fn draw(
    path: &Path,
    kind: Kind,
    fitted: &[Fitted],
    soils: &[SoilAnswer],
    analysis: Option<&RawAnalysis>,
) -> Result<(), CliError> {
    let figure = match (kind, analysis) {
        (Kind::Fits, _) => plot_fits::figure(fitted, soils)?,
        (Kind::Records, Some(analysis)) => plot_records::figure(analysis)?,
        (Kind::Records, None) => {
            return Err(CliError::Usage("--plot-kind records needs --raw RUNS.csv".into()));
        }
    };
    save_figure(&figure, path, Size::new(760, 520)?)
}
