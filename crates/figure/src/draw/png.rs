//! PNG files of SVG documents.

use png::{BitDepth, ColorType, Compression, Encoder, Filter, PixelDimensions, Unit};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use crate::error::FigureError;
use crate::model::Size;

/// Pixels of the file per px of the page.
const SCALE: u8 = 2;

/// Draws a document whose words are outlines: no font is looked for.
pub(crate) fn render(svg: &str, page: Size) -> Result<Vec<u8>, FigureError> {
    let tree = Tree::from_str(svg, &Options::default()).map_err(failed)?;
    let side = |px: u32| px * u32::from(SCALE);
    let (width, height) = (side(page.width()), side(page.height()));
    let mut pixels =
        Pixmap::new(width, height).ok_or_else(|| failed("a page of this size has too many pixels"))?;
    let scale = f32::from(SCALE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    encode(&pixels).map_err(failed)
}

fn encode(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(Filter::Up);
    // Print programs then place the picture at its size in px of 1/96 inch.
    let per_meter = (f64::from(SCALE) * 96.0 / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(PixelDimensions { xppu: per_meter, yppu: per_meter, unit: Unit::Meter }));
    // The paper is opaque, so nothing is lost without the fourth channel.
    let colors: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colors)?;
    writer.finish()?;
    Ok(file)
}

fn failed(error: impl std::fmt::Display) -> FigureError {
    FigureError::Backend(error.to_string())
}
