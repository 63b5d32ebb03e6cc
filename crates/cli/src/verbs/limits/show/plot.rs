//! Figures of a solution in files and on pages.

use std::path::Path;

use clap::ValueEnum;
use soilctl_figure::{Figure, FigureGrid, HtmlReport, Motion, Size};

use super::frame::Window;
use super::mechanism::mechanism;
use super::{Shown, contact, field, save};
use crate::error::CliError;

/// What to draw of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// Mesh and velocities of the upper bound, and the failure surface
    Velocity,
    /// The mesh moved by the velocities: how the soil fails; in .html it moves
    Mechanism,
    /// Where the soil shears: shear strength times shear rate, and lines along which it slips
    Dissipation,
    /// Principal stresses of the lower bound
    Stress,
    /// Stresses between structure and soil, of the lower bound
    Contact,
    /// All of these, in one .html, .svg or .png
    All,
}

impl Kind {
    /// The figures that it stands for.
    fn each(self) -> Vec<Self> {
        match self {
            Self::All => {
                vec![Self::Mechanism, Self::Velocity, Self::Dissipation, Self::Stress, Self::Contact]
            }
            one => vec![one],
        }
    }

    const fn caption(self) -> &'static str {
        match self {
            Self::Mechanism => {
                "The mesh of the upper bound, moved by its velocities; every other layer of soil has a tone, so that shearing and \
                 slipping show. Velocities are those at the moment of failure, drawn out as far as can be seen. Where soil dilates, \
                 gaps open along lines of slip."
            }
            Self::Velocity | Self::All => {
                "Mesh of the upper bound with its velocities; the boundary of the soil that moves."
            }
            Self::Dissipation => {
                "Greatest shear stress that the soil bears at the mean stress of the lower bound's stress field, times greatest \
                 shear strain rate of the upper bound's flow; lines along which the flow slips."
            }
            Self::Stress => {
                "Principal stresses of the lower bound's stress field, as crosses whose arms are as long as the stresses are great."
            }
            Self::Contact => "Stresses between structure and soil in the lower bound's stress field.",
        }
    }
}

/// A figure that stands still, or one that moves.
enum Drawn {
    Still(Figure),
    Moving(Motion),
}

impl Drawn {
    fn still(self) -> Result<Figure, CliError> {
        match self {
            Self::Still(figure) => Ok(figure),
            Self::Moving(motion) => Ok(motion.at(1.0)?),
        }
    }
}

/// A figure of one kind; none if the solution lacks what it shows.
fn draw(shown: &Shown, kind: Kind) -> Result<Option<(Drawn, Size)>, CliError> {
    let window = Window::new(shown)?;
    let field = match kind {
        Kind::Mechanism => return Ok(mechanism(shown, &window)?.map(|m| (Drawn::Moving(m), window.size))),
        Kind::Contact => return Ok(contact::figure(shown)?.map(|f| (Drawn::Still(f), Size::default()))),
        Kind::Velocity | Kind::All => field::velocity(shown, &window)?,
        Kind::Dissipation => field::dissipation(shown, &window)?,
        Kind::Stress => field::stress(shown, &window)?,
    };
    Ok(field.map(|f| (Drawn::Still(f), window.size)))
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
            "a .csv file holds one figure; give --plot-kind velocity, mechanism, dissipation, stress or contact".into(),
        )),
        Some(_) => Ok(()),
    }
}

/// The page of --plot, if its name asks for one.
pub(super) fn page(path: &Path, kind: Kind, shown: &Shown) -> Result<Option<HtmlReport>, CliError> {
    if form(path) != Some("html") {
        return Ok(None);
    }
    let mut page = HtmlReport::new(if shown.title.is_empty() { "Figures" } else { &shown.title });
    page.kind("Limit analysis");
    for kind in kind.each() {
        add(&mut page, shown, kind)?;
    }
    if page.shown().next().is_none() { Err(nothing(kind)) } else { Ok(Some(page)) }
}

/// Adds a figure to a page, if there is something to show.
pub(super) fn add(page: &mut HtmlReport, shown: &Shown, kind: Kind) -> Result<(), CliError> {
    match draw(shown, kind)? {
        Some((Drawn::Still(figure), size)) => page.figure(&figure, size, kind.caption())?,
        Some((Drawn::Moving(motion), size)) => page.motion(&motion, size, kind.caption())?,
        None => page,
    };
    Ok(())
}

/// Draws a figure into a file, in the form that its name asks for; not a page.
pub(super) fn plot(path: &Path, kind: Kind, shown: &Shown) -> Result<(), CliError> {
    let mut figures: Vec<(Figure, Size)> = Vec::new();
    for kind in kind.each() {
        if let Some((drawn, size)) = draw(shown, kind)? {
            figures.push((drawn.still()?, size));
        }
    }
    let Some((first, size)) = figures.first() else { return Err(nothing(kind)) };
    let bytes = match form(path) {
        Some("csv") => first.to_csv().into_bytes(),
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

fn nothing(kind: Kind) -> CliError {
    let needs = match kind {
        Kind::Contact => "contact stresses need a lower bound and a structure",
        Kind::Stress => "stresses need a lower bound",
        _ => "velocities need an upper bound",
    };
    CliError::Usage(format!("there is nothing to draw: {needs}"))
}
