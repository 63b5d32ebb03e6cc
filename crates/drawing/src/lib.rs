#![doc = include_str!("../README.md")]

mod ags;
mod chain;
mod dxf;
mod error;
mod geo;
mod table;
mod unit;

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;

pub use error::DrawingError;
pub use unit::Unit;

/// A point in metres: x to the right, y upwards.
pub type Point = [f64; 2];

/// Longest file, in bytes.
pub const MOST_BYTES: usize = 64 << 20;
/// Most corners of all shapes together.
pub const MOST_CORNERS: usize = 100_000;
/// No coordinate is further away, in metres.
const FARTHEST_M: f64 = 1e6;

/// What a drawing is written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Drawing Exchange Format, as text.
    Dxf,
    /// GeoJSON (RFC 7946), with plane coordinates in metres instead of degrees.
    GeoJson,
    /// A table of corners: `layer`, `x_m`, `y_m`, and optionally `part`.
    Csv,
    /// Boreholes in the format AGS 4, of which a section is made; they are only read.
    Ags,
}

impl Format {
    /// The format that an ending stands for: `.dxf`, `.geojson`, `.csv`, `.ags`.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "dxf" => Some(Self::Dxf),
            "geojson" => Some(Self::GeoJson),
            "csv" => Some(Self::Csv),
            "ags" => Some(Self::Ags),
            _ => None,
        }
    }
}

/// The area of a polygon, positive if its corners go round counter-clockwise.
#[must_use]
pub fn signed_area_m2(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>()
}

/// Whether a shape is an area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outline {
    /// The last corner is joined to the first.
    Closed,
    /// A line.
    Open,
    /// The file does not say.
    Unsaid,
}

/// A polygon or a line on a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Name of its layer.
    pub layer: String,
    /// Corners; the first is not repeated at the end.
    pub corners: Vec<Point>,
    /// Whether it is an area.
    pub outline: Outline,
}

/// What of a file is not in the drawing.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct LeftOut {
    /// Name of its layer.
    pub layer: String,
    /// What it is, as the file calls it.
    pub what: String,
    /// Why.
    pub why: String,
    /// Whether it could have been ground: an area, a line, or something that may hold them. Texts, hatches and what was hidden could not.
    pub is_shape: bool,
}

/// Why something is not read.
#[derive(Debug, Clone, Copy)]
struct Why {
    words: &'static str,
    is_shape: bool,
}

impl Why {
    /// Of something that could have been ground.
    const fn shape(words: &'static str) -> Self {
        Self { words, is_shape: true }
    }

    /// Of something that could not.
    const fn other(words: &'static str) -> Self {
        Self { words, is_shape: false }
    }
}

/// A cross-section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// Polygons and lines, in the order of the file; those that were joined follow.
    pub shapes: Vec<Shape>,
    /// What of the file is not in it, and how often.
    pub left_out: BTreeMap<LeftOut, usize>,
    /// The unit of the file's coordinates; `None` if it did not say.
    pub unit: Option<Unit>,
    /// Whether arcs became chords.
    pub has_chords: bool,
    /// What is to be kept in mind of how it was read, and what the file says beside shapes.
    pub notes: Vec<String>,
}

/// How a drawing is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The unit of its coordinates, whatever it says itself.
    pub unit: Option<Unit>,
    /// Ends of lines that are as near as this are one (m).
    pub join_m: f64,
    /// Chords are as near as this to their arcs (m).
    pub chord_m: f64,
    /// Names of the holes that a section of boreholes goes through, in order; all if none is named.
    pub holes: Vec<String>,
}

impl Default for Reading {
    fn default() -> Self {
        Self { unit: None, join_m: 1e-3, chord_m: 0.01, holes: Vec::new() }
    }
}

impl Drawing {
    /// Reads a file's bytes.
    ///
    /// # Errors
    /// [`DrawingError`] if they are no such drawing, or are beyond the limits.
    pub fn from_bytes(bytes: &[u8], format: Format, reading: &Reading) -> Result<Self, DrawingError> {
        if bytes.len() > MOST_BYTES {
            return Err(DrawingError::TooLarge { what: "bytes", count: bytes.len(), limit: MOST_BYTES });
        }
        let drawing = match format {
            Format::Dxf => dxf::read(bytes, reading)?,
            Format::GeoJson => geo::read(bytes, reading)?,
            Format::Csv => table::read(bytes, reading)?,
            Format::Ags => ags::read(bytes, reading)?,
        };
        drawing.check()?;
        Ok(drawing)
    }

    /// The text of a file.
    ///
    /// # Errors
    /// [`DrawingError`] if a coordinate is not finite, JSON cannot be made of it, or the format is only read.
    pub fn to_text(&self, format: Format) -> Result<String, DrawingError> {
        self.check()?;
        match format {
            Format::Dxf => Ok(dxf::write(&self.shapes)),
            Format::GeoJson => geo::write(&self.shapes),
            Format::Csv => table::write(&self.shapes),
            Format::Ags => Err(DrawingError::Kind(
                "AGS files hold boreholes and are only read; write .dxf, .geojson or .csv".into(),
            )),
        }
    }

    fn check(&self) -> Result<(), DrawingError> {
        let count = self.shapes.iter().map(|shape| shape.corners.len()).sum();
        if count > MOST_CORNERS {
            return Err(DrawingError::TooLarge { what: "corners", count, limit: MOST_CORNERS });
        }
        for shape in &self.shapes {
            let odd = shape.corners.iter().flatten().find(|x| !x.is_finite() || x.abs() > FARTHEST_M);
            if let Some(&value) = odd {
                return Err(DrawingError::Coordinate { layer: shape.layer.clone(), value });
            }
        }
        Ok(())
    }

    /// Counts something that is not read.
    fn leave_out(&mut self, layer: &str, what: &str, Why { words, is_shape }: Why) {
        let it = LeftOut { layer: layer.to_owned(), what: what.to_owned(), why: words.to_owned(), is_shape };
        *self.left_out.entry(it).or_default() += 1;
    }
}
