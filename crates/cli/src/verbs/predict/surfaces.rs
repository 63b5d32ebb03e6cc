//! Failure surfaces of several models over each other, in slant lengths of the plate.

use soilctl_earth_pressure::{Case, model};
use soilctl_figure::{Axis, Dash, Figure, Line, Polygon, Polygons};

use super::plot::angles_in_words;
use crate::error::CliError;
use crate::output::Output;

const MODELS: [(&str, &str); 3] =
    [("coulomb", "Coulomb"), ("log-spiral", "log-spiral"), ("chen", "Chen & Liu")];
/// Colour of the plate and of the ground: the last of the palette, away from the first ones of the models.
const GROUND_COLOR: usize = 7;
/// Ground drawn behind the plate.
const BEHIND: f64 = 0.8;

pub(super) fn figure(case: &Case, output: &Output) -> Result<Figure, CliError> {
    let mut surfaces = Vec::new();
    for (id, name) in MODELS {
        match model(id)?.failure_surface(case) {
            Ok(Some(surface)) => surfaces.push((name, surface)),
            Ok(None) => {}
            Err(problem) => output.note(&format!("note: {name} is not drawn: {problem}")),
        }
    }
    let Some((_, any)) = surfaces.first() else {
        return Err(CliError::Usage(
            "no model has a failure surface at these angles, so there is nothing to draw".into(),
        ));
    };
    let top = any.plate_top;
    let reach = surfaces.iter().map(|(_, surface)| surface.extent()).fold(1.0, f64::max);
    let title = format!("Failure surfaces at {}", angles_in_words(case, ""));
    let mut figure = Figure::new(
        title,
        Axis::linear("Distance ahead of the tip (plate lengths)"),
        Axis::linear("Height (plate lengths)"),
    )
    .with_equal_aspect()?;

    let along = |distance: f64| {
        (top.0 + distance * case.surface_slope.cos(), top.1 + distance * case.surface_slope.sin())
    };
    figure.push(
        Line::new("ground", [along(-BEHIND), along(reach + 0.3)])
            .color(GROUND_COLOR)
            .dash(Dash::Solid)
            .width(1.5),
    )?;
    for (color, (name, surface)) in surfaces.iter().enumerate() {
        figure.push(Line::new(*name, surface.points.clone()).color(color).width(2.0))?;
    }
    figure.push(Polygons::new("plate", [plate(case, top)]).color(GROUND_COLOR))?;
    Ok(figure)
}

/// The plate as a thin bar that stands a little out of the ground.
fn plate(case: &Case, top: (f64, f64)) -> Polygon {
    const THICKNESS: f64 = 0.04;
    const OUT: f64 = 1.25;
    // Its thickness lies behind the face that pushes.
    let (back_x, back_y) = (-THICKNESS * case.tool_angle.sin(), -THICKNESS * case.tool_angle.cos());
    let end = (OUT * top.0, OUT * top.1);
    Polygon::new([(0.0, 0.0), end, (end.0 + back_x, end.1 + back_y), (back_x, back_y)])
}
