//! Figures of a solution in files and on pages.

use std::path::Path;

use clap::ValueEnum;
use soilctl_app::files;
use soilctl_app::limits::Fields;
use soilctl_figure::{Figure, FigureGrid, HtmlReport, Motion, Size};

use super::blocks::blocks;
use super::frame::Window;
use super::mechanism::mechanism;
use super::{contact, end, field, members};
use crate::PageError;

/// What to draw of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Mesh and velocities of the upper bound, and the failure surface
    Velocity,
    /// The mesh moved by the velocities: how the soil fails; in .html it moves
    Mechanism,
    /// Blocks in space, of a plate with ends: how the soil fails there; in .html it moves
    Blocks,
    /// Where the soil shears: shear strength times shear rate, and lines along which it slips
    Dissipation,
    /// Principal stresses of the lower bound
    Stress,
    /// Stresses between structure and soil, of the lower bound
    Contact,
    /// Axial forces of bars, sheets and beams, of the lower bound
    Members,
    /// Bending moments of beams, of the lower bound
    Moments,
    /// Pressure on a plate near its end, of a lower bound in space
    End,
    /// All of these, in one .html, .svg or .png
    All,
}

impl Kind {
    /// The figures that it stands for.
    fn each(self) -> Vec<Self> {
        match self {
            Self::All => {
                vec![
                    Self::Blocks,
                    Self::Mechanism,
                    Self::Velocity,
                    Self::Dissipation,
                    Self::Stress,
                    Self::Contact,
                    Self::Members,
                    Self::Moments,
                    Self::End,
                ]
            }
            one => vec![one],
        }
    }

    const fn caption(self) -> &'static str {
        match self {
            Self::Mechanism => {
                "The mesh of the upper bound, moved by its velocities; every other square of a grid has a tone, so that shearing \
                 and slipping show. Velocities are those at the moment of failure, drawn out as far as can be seen. Where soil dilates, \
                 gaps open along lines of slip."
            }
            Self::Blocks => {
                "The rigid blocks that bound the force of a plate with ends from above: the rims of their faces, drawn out as far as \
                 can be seen. Each block slides on soil at rest below and at its two sides, and opens there as much as friction demands."
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
            Self::Members => {
                "Axial forces along bars, sheets and beams in the lower bound's stress field, tension upwards, with the tension that each bears."
            }
            Self::Moments => {
                "Bending moments along beams in the lower bound's stress field, positive where they stretch the right side of the beam as it \
                 goes from its start, with what each bears."
            }
            Self::End => {
                "What presses on the plate near its end in the stress field in space that bounds its force from below. Towards the middle \
                 the field goes on as it is at the left."
            }
        }
    }
}

/// A figure that stands still, or one that moves.
enum Drawn {
    Still(Figure),
    Moving(Motion),
}

impl Drawn {
    fn still(self) -> Result<Figure, PageError> {
        match self {
            Self::Still(figure) => Ok(figure),
            Self::Moving(motion) => Ok(motion.at(1.0)?),
        }
    }
}

/// A figure of one kind; none if the solution lacks what it shows.
fn draw(fields: &Fields, kind: Kind) -> Result<Option<(Drawn, Size)>, PageError> {
    let window = Window::new(fields)?;
    let field = match kind {
        Kind::Mechanism => return Ok(mechanism(fields, &window)?.map(|m| (Drawn::Moving(m), window.size))),
        Kind::Blocks => return Ok(blocks(fields)?.map(|(motion, size)| (Drawn::Moving(motion), size))),
        Kind::Contact => return Ok(contact::figure(fields)?.map(|f| (Drawn::Still(f), Size::default()))),
        Kind::Members => return Ok(members::figure(fields)?.map(|f| (Drawn::Still(f), Size::default()))),
        Kind::Moments => return Ok(members::moments(fields)?.map(|f| (Drawn::Still(f), Size::default()))),
        Kind::End => return Ok(end::figure(fields)?.map(|(figure, size)| (Drawn::Still(figure), size))),
        Kind::Velocity | Kind::All => field::velocity(fields, &window)?,
        Kind::Dissipation => field::dissipation(fields, &window)?,
        Kind::Stress => field::stress(fields, &window)?,
    };
    Ok(field.map(|f| (Drawn::Still(f), window.size)))
}

fn form(path: &Path) -> Option<&str> {
    path.extension().and_then(|ending| ending.to_str()).filter(|e| ["svg", "png", "html", "csv"].contains(e))
}

/// Refuses names of files that say nothing, before anything is solved.
///
/// # Errors
/// [`PageError::Nothing`] that says how the name must end.
pub fn check(path: &Path, kind: Kind) -> Result<(), PageError> {
    match form(path) {
        None => Err(PageError::Nothing(format!(
            "--plot is {}; the name must end in .svg, .png, .html or .csv",
            path.display()
        ))),
        Some("csv") if kind == Kind::All => Err(PageError::Nothing(
            "a .csv file holds one figure; give --plot-kind velocity, mechanism, blocks, dissipation, stress, contact, members, moments or end".into(),
        )),
        Some(_) => Ok(()),
    }
}

/// Draws into a file, in the form that its name asks for. `command` is the command line that the foot of a page shows.
///
/// # Errors
/// [`PageError`] if there is nothing to draw, or the file cannot be written.
pub fn save(path: &Path, kind: Kind, fields: &Fields, command: &str) -> Result<(), PageError> {
    match form(path) {
        Some("html") => {
            crate::write(&mut figures_page(kind, fields)?, Some(path), None, command)?;
        }
        form => files::save(path, &image(form, kind, fields)?)?,
    }
    Ok(())
}

/// A page of nothing but figures.
fn figures_page(kind: Kind, fields: &Fields) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new(if fields.title.is_empty() { "Figures" } else { &fields.title });
    page.kind("Limit analysis");
    for kind in kind.each() {
        add(&mut page, fields, kind)?;
    }
    if page.shown().next().is_none() { Err(nothing(kind)) } else { Ok(page) }
}

/// Adds a figure to a page, if there is something to show.
pub(super) fn add(page: &mut HtmlReport, fields: &Fields, kind: Kind) -> Result<(), PageError> {
    match draw(fields, kind)? {
        Some((Drawn::Still(figure), size)) => page.figure(&figure, size, kind.caption())?,
        Some((Drawn::Moving(motion), size)) => page.motion(&motion, size, kind.caption())?,
        None => page,
    };
    Ok(())
}

/// The bytes of an image or a table of data.
fn image(form: Option<&str>, kind: Kind, fields: &Fields) -> Result<Vec<u8>, PageError> {
    let mut figures: Vec<(Figure, Size)> = Vec::new();
    for kind in kind.each() {
        if let Some((drawn, size)) = draw(fields, kind)? {
            figures.push((drawn.still()?, size));
        }
    }
    let Some((first, size)) = figures.first() else { return Err(nothing(kind)) };
    Ok(match form {
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
    })
}

fn nothing(kind: Kind) -> PageError {
    let needs = match kind {
        Kind::Contact => "contact stresses need a lower bound and a structure",
        Kind::Members => "axial forces need a lower bound and a bar, sheet or beam",
        Kind::Moments => "bending moments need a lower bound and a beam",
        Kind::Stress => "stresses need a lower bound",
        Kind::Blocks => "blocks in space need the upper bound of a plate with ends",
        Kind::End => "the pressure near an end needs a lower bound in space",
        _ => "velocities need an upper bound",
    };
    PageError::Nothing(format!("there is nothing to draw: {needs}"))
}
