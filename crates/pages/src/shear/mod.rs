//! Figures of direct-shear tests.

mod fits;
mod records;

use std::path::Path;

use clap::ValueEnum;
use soilctl_app::shear::Shear;
use soilctl_figure::Size;

use crate::{PageError, save_figure};

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Friction angle against normal stress, with the curves
    Fits,
    /// Friction angle against displacement of every run; needs --raw
    Records,
}

/// Draws a figure into a file.
///
/// # Errors
/// [`PageError`] if records are asked for and there are none, or the file cannot be written.
pub fn save(path: &Path, kind: Kind, found: &Shear) -> Result<(), PageError> {
    let figure = match (kind, &found.records) {
        (Kind::Fits, _) => fits::figure(&found.fitted, &found.answer.soils)?,
        (Kind::Records, Some(records)) => records::figure(records)?,
        (Kind::Records, None) => {
            return Err(PageError::Nothing("--plot-kind records needs --raw RUNS.csv".into()));
        }
    };
    save_figure(&figure, path, Size::new(760, 520)?)
}
