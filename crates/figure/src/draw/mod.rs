//! Static rendering: a figure becomes a scene of strokes, fills and texts, and each backend plays
//! the scene.

mod areas;
mod axes;
mod clip;
mod dash;
mod fonts;
mod frame;
mod grid;
mod hatch;
mod layers;
mod legend;
mod paths;
pub(crate) mod png;
mod raster;
mod scene;
mod shades;
pub(crate) mod svg;
mod ticks;

pub use grid::FigureGrid;

use crate::error::FigureError;
use crate::model::{Figure, Size};
pub(crate) use frame::Frame;
use scene::Scene;

/// The axes of a figure without its layers, and where things go between them.
pub(crate) fn axes_of(figure: &Figure, size: Size) -> Result<(Scene, Frame), FigureError> {
    fonts::register()?;
    let mut scene = Scene::new(size, &figure.title);
    let frame = Frame::new(figure, f64::from(size.width()), f64::from(size.height()));
    axes::draw(figure, &frame, &mut scene);
    axes::draw_border(&frame, &mut scene);
    Ok((scene, frame))
}

/// Lays a figure out on a page of its own.
pub(crate) fn scene_of(figure: &Figure, size: Size) -> Result<Scene, FigureError> {
    fonts::register()?;
    if figure.layers.is_empty() {
        return Err(FigureError::EmptyFigure { title: figure.title.clone() });
    }
    let mut scene = Scene::new(size, &figure.title);
    let frame = Frame::new(figure, f64::from(size.width()), f64::from(size.height()));
    axes::draw(figure, &frame, &mut scene);
    layers::draw(figure, &frame, &mut scene);
    axes::draw_border(&frame, &mut scene);
    shades::draw_bars(figure, &frame, &mut scene);
    legend::draw(figure, &frame, &mut scene);
    Ok(scene)
}
