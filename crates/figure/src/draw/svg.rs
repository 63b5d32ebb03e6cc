//! Playing a scene into an SVG document.

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBAColor, ShapeStyle};

use super::fonts;
use super::scene::{Anchor, Item, Label, Px, Scene};
use crate::error::FigureError;
use crate::escape;
use crate::palette::{PAPER, Rgb};

/// Units of the document per px. The backend draws at whole units, and whole px would make
/// shallow curves look stepped.
const UNITS: f64 = 10.0;
/// Em of the backend's font size, as it writes the `font-size` attribute.
const SIZE_PER_EM: f64 = 1.24;
/// Distance of the baseline below the anchor that the backend writes for texts anchored at the top.
const TOP_TO_BASELINE: f64 = 0.76;

/// Renders a scene.
pub(crate) fn render(scene: &Scene) -> Result<String, FigureError> {
    let mut out = String::new();
    let (width, height) = (scene.size.width(), scene.size.height());
    let mut backend = SVGBackend::with_string(&mut out, (width * UNITS as u32, height * UNITS as u32));
    let corner = (unit(f64::from(width)), unit(f64::from(height)));
    backend.draw_rect((0, 0), corner, &rgba(PAPER, 1.0), true).map_err(failed)?;
    scene.items.iter().try_for_each(|item| play(item, &mut backend))?;
    backend.present().map_err(failed)?;
    drop(backend);
    Ok(with_root(&out, scene))
}

/// Replaces the root element by one in px that also has an accessible title and round joins.
fn with_root(svg: &str, scene: &Scene) -> String {
    let body = svg.split_once('>').map_or("", |(_, body)| body);
    let (w, h) = (scene.size.width(), scene.size.height());
    let (uw, uh) = (w * UNITS as u32, h * UNITS as u32);
    let title = escape::html(&scene.title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {uw} {uh}\" \
         role=\"img\" stroke-linejoin=\"round\">\n<title>{title}</title>{body}"
    )
}

fn play(item: &Item, backend: &mut SVGBackend<'_>) -> Result<(), FigureError> {
    match item {
        Item::Stroke { points, width, color } => {
            let style = ShapeStyle {
                color: rgba(*color, 1.0),
                filled: false,
                stroke_width: unit(*width).unsigned_abs().max(1),
            };
            let mut path: Vec<_> = points.iter().map(|&p| units(p)).collect();
            path.dedup();
            backend.draw_path(path, &style).map_err(failed)
        }
        Item::Fill { rings, color, alpha } => {
            let outline = bridged(rings).into_iter().map(units);
            backend.fill_polygon(outline, &rgba(*color, *alpha)).map_err(failed)
        }
        Item::Disc { center, radius, color } => {
            let radius = unit(*radius).unsigned_abs();
            backend.draw_circle(units(*center), radius, &rgba(*color, 1.0), true).map_err(failed)
        }
        Item::Label(label) => play_label(label, backend),
    }
}

fn play_label(label: &Label, backend: &mut SVGBackend<'_>) -> Result<(), FigureError> {
    let em = label.em * UNITS;
    let style = fonts::style(em * SIZE_PER_EM, label.bold, label.upwards, label.color);
    let side = match label.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let (x, y) = units(label.at);
    let rise = (em * TOP_TO_BASELINE).round() as i32;
    let at = if label.upwards { (x - rise, y) } else { (x, y - rise) };
    let style = style.pos(Pos::new(side, VPos::Top));
    backend.draw_text(&label.text, &style, at).map_err(failed)
}

/// One ring out of several. The bridges between them are walked both ways, so they enclose
/// nothing under the non-zero rule.
fn bridged(rings: &[Vec<Px>]) -> Vec<Px> {
    let Some((outer, holes)) = rings.split_first() else { return Vec::new() };
    let mut ring = outer.clone();
    for hole in holes {
        ring.extend(outer.first());
        ring.extend(hole);
        ring.extend(hole.first());
    }
    if !holes.is_empty() {
        ring.extend(outer.first());
    }
    ring
}

fn units(p: Px) -> (i32, i32) {
    (unit(p.0), unit(p.1))
}

fn unit(px: f64) -> i32 {
    (px * UNITS).round() as i32
}

fn rgba(color: Rgb, alpha: f64) -> RGBAColor {
    plotters::style::RGBColor(color.0, color.1, color.2).mix(alpha)
}

fn failed(error: impl std::fmt::Display) -> FigureError {
    FigureError::Backend(error.to_string())
}
