//! Playing a scene into a PNG file.

use plotters::backend::{BitMapBackend, DrawingBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBAColor, RGBColor};

use super::fonts::{self, LINE_HEIGHT};
use super::raster;
use super::scene::{Anchor, Item, Label, Px, Scene};
use crate::error::FigureError;
use crate::palette::Rgb;

/// Pixels of the file per px of the scene.
const SCALE: u32 = 2;
/// Samples per pixel along each side; the backend draws shapes without smoothing their edges.
const SAMPLES: u32 = 2;
/// Samples per px of the scene.
const ZOOM: f64 = (SCALE * SAMPLES) as f64;

/// Renders a scene.
pub(crate) fn render(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    let (width, height) = (scene.size.width() * SCALE, scene.size.height() * SCALE);
    let fine = (width * SAMPLES, height * SAMPLES);
    let mut buffer = vec![0xff_u8; fine.0 as usize * fine.1 as usize * 3];
    {
        let mut backend = BitMapBackend::with_buffer(&mut buffer, fine);
        scene.items.iter().try_for_each(|item| play(item, fine, &mut backend))?;
        backend.present().map_err(failed)?;
    }
    encode(&averaged(&buffer, width as usize, height as usize), width, height)
}

fn play(item: &Item, page: (u32, u32), backend: &mut BitMapBackend<'_>) -> Result<(), FigureError> {
    match item {
        Item::Stroke { points, width, color } => {
            paint(&raster::thick(&zoomed(points), width * ZOOM), rgba(*color, 1.0), page, backend)
        }
        Item::Fill { rings, color, alpha } => {
            let rings: Vec<_> = rings.iter().map(|ring| zoomed(ring)).collect();
            paint(&rings, rgba(*color, *alpha), page, backend)
        }
        Item::Disc { center, radius, color } => {
            let ring = raster::disc((center.0 * ZOOM, center.1 * ZOOM), radius * ZOOM);
            paint(&[ring], rgba(*color, 1.0), page, backend)
        }
        Item::Label(label) => play_label(label, backend),
    }
}

fn paint(
    rings: &[Vec<Px>],
    color: RGBAColor,
    page: (u32, u32),
    backend: &mut BitMapBackend<'_>,
) -> Result<(), FigureError> {
    let mut outcome = Ok(());
    raster::fill(rings, page, |y, from, to| {
        let drawn = backend.draw_rect((from, y), (to, y + 1), &color, true);
        if let Err(error) = drawn {
            outcome = Err(failed(error));
        }
    });
    outcome
}

fn play_label(label: &Label, backend: &mut BitMapBackend<'_>) -> Result<(), FigureError> {
    let height = label.em * ZOOM * LINE_HEIGHT;
    let style = fonts::style(height, label.bold, label.upwards, label.color);
    let side = match label.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    // The backend puts the baseline half the font height below a text anchored at the top.
    let rise = height / 2.0;
    let (x, y) = (label.at.0 * ZOOM, label.at.1 * ZOOM);
    let (x, y) = if label.upwards { (x - rise, y) } else { (x, y - rise) };
    let at = (x.round() as i32, y.round() as i32);
    let style = style.pos(Pos::new(side, VPos::Top));
    backend.draw_text(&label.text, &style, at).map_err(failed)
}

/// The mean of each block of samples.
fn averaged(fine: &[u8], width: usize, height: usize) -> Vec<u8> {
    let samples = SAMPLES as usize;
    let stride = width * samples * 3;
    let mut out = Vec::with_capacity(width * height * 3);
    for y in 0..height {
        for x in 0..width {
            for channel in 0..3 {
                let corner = y * samples * stride + x * samples * 3 + channel;
                let block =
                    (0..samples).flat_map(|dy| (0..samples).map(move |dx| corner + dy * stride + dx * 3));
                let sum: usize = block.map(|i| usize::from(fine[i])).sum();
                out.push(((sum + samples * samples / 2) / (samples * samples)) as u8);
            }
        }
    }
    out
}

fn encode(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, FigureError> {
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, width, height);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_compression(::png::Compression::Best);
    encoder.set_filter(::png::FilterType::Up);
    // Print programs then place the picture at its size in px of 1/96 inch.
    let per_meter = (f64::from(SCALE) * 96.0 / 0.0254).round() as u32;
    let unit = ::png::Unit::Meter;
    encoder.set_pixel_dims(Some(::png::PixelDimensions { xppu: per_meter, yppu: per_meter, unit }));
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(pixels).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(file)
}

fn zoomed(points: &[Px]) -> Vec<Px> {
    points.iter().map(|p| (p.0 * ZOOM, p.1 * ZOOM)).collect()
}

fn rgba(color: Rgb, alpha: f64) -> RGBAColor {
    RGBColor(color.0, color.1, color.2).mix(alpha)
}

fn failed(error: impl std::fmt::Display) -> FigureError {
    FigureError::Backend(error.to_string())
}
