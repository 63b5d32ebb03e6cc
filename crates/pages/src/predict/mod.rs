//! Figures of a prediction.

mod curves;
mod surfaces;

use std::path::Path;

use clap::ValueEnum;
use soilctl_app::Watch;
use soilctl_app::text::number;
use soilctl_earth_pressure::Case;
use soilctl_figure::Size;

use curves::Angle;

use crate::{PageError, save_figure};

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Failure surfaces of the models that have one, over each other
    Surface,
    /// k_net of all models against the friction angle of the soil
    Phi,
    /// k_net of all models against the interface friction angle
    Delta,
    /// k_net of all models against the tool angle
    Alpha,
}

/// Draws a figure of a case into a file.
///
/// # Errors
/// [`PageError`] if no model has an answer there, or the file cannot be written.
pub fn save(path: &Path, kind: Kind, case: &Case, watch: &dyn Watch) -> Result<(), PageError> {
    let figure = match kind {
        Kind::Surface => surfaces::figure(case, watch)?,
        Kind::Phi => curves::figure(case, Angle::Phi)?,
        Kind::Delta => curves::figure(case, Angle::Delta)?,
        Kind::Alpha => curves::figure(case, Angle::Alpha)?,
    };
    // A failure surface is several times as long as it is deep.
    let size = if kind == Kind::Surface { Size::new(760, 400)? } else { Size::default() };
    save_figure(&figure, path, size)
}

/// The angles of a case in words, without the one left out.
fn angles_in_words(case: &Case, without: &str) -> String {
    let angles = [
        ("alpha", case.tool_angle),
        ("beta", case.surface_slope),
        ("phi", case.friction),
        ("delta", case.interface),
    ];
    let words = angles
        .iter()
        .filter(|(name, angle)| *name != without && (*name != "beta" || angle.radians() != 0.0))
        .map(|(name, angle)| format!("{name} {}°", number(angle.degrees())));
    words.collect::<Vec<_>>().join(", ")
}
