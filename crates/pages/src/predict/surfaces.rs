//! Failure surfaces of several models over each other, in slant lengths of the plate.

use soilctl_app::Watch;
use soilctl_earth_pressure::{Case, model};
use soilctl_figure::{Axis, Dash, Figure, Line};

use super::angles_in_words;
use crate::PageError;

const MODELS: [(&str, &str); 3] =
    [("coulomb", "Coulomb"), ("log-spiral", "log-spiral"), ("chen", "Chen & Liu")];
/// Black, for the plate and the ground.
const GROUND_COLOR: usize = 6;
/// Length of the plate that is drawn, in wetted lengths.
const OUT_OF_GROUND: f64 = 1.25;
/// Ground drawn behind the plate.
const BEHIND: f64 = 0.8;

pub(super) fn figure(case: &Case, watch: &dyn Watch) -> Result<Figure, PageError> {
    let mut surfaces = Vec::new();
    for (id, name) in MODELS {
        match model(id)?.failure_surface(case) {
            Ok(Some(surface)) => surfaces.push((name, surface)),
            Ok(None) => {}
            Err(problem) => watch.note(&format!("note: {name} is not drawn: {problem}")),
        }
    }
    let Some((_, any)) = surfaces.first() else {
        return Err(PageError::Nothing(
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
    let out = (OUT_OF_GROUND * top.0, OUT_OF_GROUND * top.1);
    figure.push(Line::new("plate", [(0.0, 0.0), out]).color(GROUND_COLOR).dash(Dash::Solid).width(4.0))?;
    Ok(figure)
}
