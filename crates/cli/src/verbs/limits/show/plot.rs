use std::path::Path;

use clap::ValueEnum;
use soilctl_figure::{Figure, FigureGrid, HtmlReport, Size};

use super::frame::Window;
use super::{Shown, contact, field, save};
use crate::error::CliError;

/// What to draw of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// Mesh and velocities of the upper bound, and the failure surface
    Velocity,
    /// Where the soil shears: shear strength times shear rate, and lines along which it slips
    Dissipation,
    /// Principal stresses of the lower bound
    Stress,
    /// Stresses between structure and soil, of the lower bound
    Contact,
    /// All of these, in one .html, .svg or .png
    All,
}

fn form(path: &Path) -> Option<&str> {
    path.extension().and_then(|ending| ending.to_str()).filter(|e| ["svg", "png", "html", "csv"].contains(e))
}

/// Refuses names of files that say nothing.
pub(super) fn check(path: &Path, kind: Kind) -> Result<(), CliError> {
    match form(path) {
        None => Err(CliError::Usage(format!(
            "--plot is {}; the name must end in .svg, .png, .html or .csv",
            path.display()
        ))),
        Some("csv") if kind == Kind::All => Err(CliError::Usage(
            "a .csv file holds one figure; give --plot-kind velocity, dissipation, stress or contact".into(),
        )),
        Some(_) => Ok(()),
    }
}

/// Draws a figure into a file, in the form that its name asks for.
pub(super) fn plot(path: &Path, kind: Kind, shown: &Shown) -> Result<(), CliError> {
    check(path, kind)?;
    let mut figures: Vec<(Figure, Size, &str)> = Vec::new();
    let window = Window::new(shown)?;
    let wanted = |k| kind == k || kind == Kind::All;
    if wanted(Kind::Velocity) {
        figures.extend(field::velocity(shown, &window)?.map(|f| (f, window.size, VELOCITY)));
    }
    if wanted(Kind::Dissipation) {
        figures.extend(field::dissipation(shown, &window)?.map(|f| (f, window.size, DISSIPATION)));
    }
    if wanted(Kind::Stress) {
        figures.extend(field::stress(shown, &window)?.map(|f| (f, window.size, STRESS)));
    }
    if wanted(Kind::Contact) {
        figures.extend(contact::figure(shown)?.map(|f| (f, Size::default(), CONTACT)));
    }
    let Some((first, size, _)) = figures.first() else {
        let needs = match kind {
            Kind::Contact => "contact stresses need a lower bound and a structure",
            Kind::Stress => "stresses need a lower bound",
            _ => "velocities need an upper bound",
        };
        return Err(CliError::Usage(format!("there is nothing to draw: {needs}")));
    };
    let bytes = match form(path) {
        Some("csv") => first.to_csv().into_bytes(),
        Some("html") => page(shown, &figures)?.into_bytes(),
        form if figures.len() == 1 => match form {
            Some("png") => first.to_png(*size)?,
            _ => first.to_svg(*size)?.into_bytes(),
        },
        form => {
            let rows = figures.len().div_ceil(2) as u32;
            // As wide each as one alone.
            let page = Size::new(2 * size.width(), (size.height() * rows).min(2000))?;
            let grid = FigureGrid::new(figures.into_iter().map(|f| f.0).collect::<Vec<_>>(), 2)?;
            if form == Some("png") { grid.to_png(page)? } else { grid.to_svg(page)?.into_bytes() }
        }
    };
    save(path, &bytes)
}

const VELOCITY: &str = "Mesh of the upper bound with its velocities; the boundary of the soil that moves.";
const DISSIPATION: &str = "Greatest shear stress that the soil bears at the mean stress of the lower bound's stress field, \
    times greatest shear strain rate of the upper bound's flow; lines along which the flow slips.";
const STRESS: &str = "Principal stresses of the lower bound's stress field, as crosses whose arms are as long as the \
    stresses are great.";
const CONTACT: &str = "Stresses between structure and soil in the lower bound's stress field.";

fn page(shown: &Shown, figures: &[(Figure, Size, &str)]) -> Result<String, CliError> {
    let mut report = HtmlReport::new("Limit analysis");
    report.subtitle(&shown.title);
    for (figure, size, caption) in figures {
        report.figure(figure, *size, *caption)?;
    }
    report.footer(format!("soilctl {}", env!("CARGO_PKG_VERSION")));
    Ok(report.to_html())
}
