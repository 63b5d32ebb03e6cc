//! The page of bounds on a tool's force.

use std::path::Path;

use soilctl_app::text::{number, rounded_down, rounded_up};
use soilctl_app::tool::{Answer, Bounded, ForcesAnswer};
use soilctl_figure::{Align, Axis, Figure, HtmlReport, Legend, Line, Points, Polygon, Polygons, Size, Table};

use crate::PageError;
use crate::limits::{self, PageContent, bounds_table, level_table, proven, round};
use crate::problem::Scene;
use crate::write::save_figure;

/// The page of bounds on a tool's force.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(found: &Bounded) -> Result<HtmlReport, PageError> {
    let scene = Scene::of_file(&found.solved.description, &found.solved.described);
    let mut page =
        limits::page(&found.solved.fields, &scene, content(&found.answer)?, &found.answer.results)?;
    if let Some(forces) = &found.answer.forces {
        page.heading("Forces in all directions").figure(
            &forces_figure(forces)?,
            Size::new(640, 640)?,
            "Forces of the tool on the soil if it does not turn. All in the filled polygon are borne, all beyond the line fail; both are proven.",
        )?;
    }
    Ok(page)
}

/// Forces that are borne, and the polygon beyond which none is.
///
/// # Errors
/// [`PageError`] if there is nothing to draw.
pub fn forces_figure(forces: &ForcesAnswer) -> Result<Figure, PageError> {
    let borne: Vec<(f64, f64)> =
        forces.directions.iter().filter_map(|one| one.force_n_per_m).map(|[x, y]| (x, y)).collect();
    if borne.is_empty() {
        return Err(PageError::Nothing("there is nothing to draw: no force is proven to be borne".into()));
    }
    let ring = |corners: &[[f64; 2]]| -> Vec<(f64, f64)> {
        corners.iter().chain(corners.first()).map(|[x, y]| (*x, *y)).collect()
    };
    let mut figure = Figure::new(
        "Forces of the tool on the soil, per metre of width",
        Axis::linear("ahead (N/m)"),
        Axis::linear("upwards (N/m)"),
    )
    .with_legend(Legend::Below)
    .with_equal_aspect()?;
    if forces.safe_n_per_m.len() > 2 {
        let polygon = Polygon::new(ring(&forces.safe_n_per_m));
        figure.push(Polygons::new("borne", vec![polygon]).color(0))?;
    }
    if let Some(limit) = &forces.limit_n_per_m {
        figure.push(Line::new("fails beyond", ring(limit)).color(1))?;
    }
    figure.push(Points::new("of stresses that are proven", borne).color(0))?;
    Ok(figure)
}

/// Writes that figure.
///
/// # Errors
/// [`PageError`] if it cannot be drawn or written.
pub fn save_forces(forces: &ForcesAnswer, path: &Path) -> Result<(), PageError> {
    save_figure(&forces_figure(forces)?, path, Size::new(640, 640)?)
}

fn content(answer: &Answer) -> Result<PageContent, PageError> {
    let mut bounds = bounds_table();
    bounds.row([
        "Force along the motion, per metre of width (N/m)".into(),
        number(answer.lower_n_per_m),
        number(answer.upper_n_per_m),
    ])?;
    bounds.row([
        "Its coefficient 2F/(γL²), with the length of the chord as L".into(),
        number(answer.coefficient_lower),
        number(answer.coefficient_upper),
    ])?;
    if let (Some(lower), Some(upper)) = (answer.slant_lower, answer.slant_upper) {
        bounds.row([
            "Net coefficient per slant length K = 2F/(γL²w), as of a plate".into(),
            number(lower),
            number(upper),
        ])?;
    }
    if let Some(ends) = &answer.ends {
        let sides = if ends.side_plates { "side plates" } else { "open ends" };
        bounds.row([
            format!("Force of the whole tool, {} m wide, with {sides} (N)", number(ends.width_m)),
            number(ends.lower_n),
            number(ends.upper_n),
        ])?;
        bounds.row([
            "In plane strain, without ends (N/m); its upper bound is none with ends".into(),
            number(ends.plane_lower_n_per_m),
            number(ends.plane_upper_n_per_m),
        ])?;
    }
    let (kind, text) = proven(answer.gap, answer.max_gap, answer.ended);
    let title = format!(
        "The force lies between {} and {} N per metre of width",
        rounded_down(answer.lower_n_per_m),
        rounded_up(answer.upper_n_per_m)
    );
    Ok(PageContent {
        kind: "Bounds on a tool's force",
        subtitle: "A rigid tool is pushed through soil; what it bears just before the soil fails".into(),
        verdict: (kind, title, text),
        bounds,
        inputs: vec![pieces(answer)?],
        given: given(answer),
        steps: level_table(&answer.levels)?,
    })
}

fn pieces(answer: &Answer) -> Result<Table, PageError> {
    let columns = ["piece", "from (m)", "to (m)", "tool angle (°)", "friction (°)", "adhesion (Pa)"];
    let mut table = Table::new("The tool in the ground, from its tip", columns.map(|c| (c, Align::Right)));
    for (index, piece) in answer.tool.pieces.iter().enumerate() {
        let point = |[x, y]: [f64; 2]| format!("{}, {}", number(round(x)), number(round(y)));
        table.row([
            (index + 1).to_string(),
            point(piece.from_m),
            point(piece.to_m),
            number(round(piece.alpha_deg)),
            number(piece.delta_deg),
            number(piece.adhesion_pa),
        ])?;
    }
    Ok(table)
}

fn given(answer: &Answer) -> Vec<(&'static str, String)> {
    let tool = &answer.tool;
    vec![
        ("Direction of motion", format!("{}° above the horizontal", number(answer.direction_deg))),
        ("Depth", format!("{} m", number(round(tool.depth_m)))),
        ("Soil above the tool", format!("{} m", number(round(tool.cover_m)))),
        ("Chord", format!("{} m at {}°", number(round(tool.chord_m)), number(round(tool.chord_alpha_deg)))),
    ]
}
