//! Height maps out of files of other programs.

mod ascii;
mod geotiff;
mod recording;
mod table;

use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use recording::{Cloud, Clouds, Moment, Taken, cloud, clouds, is_recording, read_clouds};

use crate::points::{grid_over, medians, on_nodes};
use crate::{Grid, HeightMap, HeightsError};

/// The longest text file that is read, in bytes.
const MOST_BYTES: u64 = 1 << 29;

/// What a map was read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// A raster with its place on the ground in tags.
    GeoTiff,
    /// ESRI's grid in text.
    AsciiGrid,
    /// A table with a point a row, that stand on a grid.
    Table,
    /// A table with points anywhere, put into cells.
    ScatteredTable,
    /// A cloud of points of a recording, put into cells.
    Cloud,
}

/// How a map is to be read.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The place (m) around which there should be ground.
    pub around_m: [f64; 2],
    /// How far from it, in m; what is farther is left out.
    pub reach_m: f64,
    /// Side of the cells (m) that points anywhere are put into; if not said, of cells that have some five points each.
    pub cell_m: Option<f64>,
    /// Topic of a recording with clouds; if not said, the only one there is.
    pub topic: Option<String>,
    /// Which cloud of a recording.
    pub moment: Moment,
}

/// What a map was made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Source {
    /// What it was read from.
    pub format: Format,
    /// The frame that a cloud names; empty if there is none.
    pub frame: String,
    /// Of a cloud, when it was taken: its stamp, or else its log time, in ns.
    pub time_ns: Option<i64>,
    /// Of points put into cells, how many there are.
    pub points: Option<usize>,
    /// Of them, the median of how many are in a cell that has some.
    pub points_a_cell: Option<usize>,
    /// Points without finite coordinates, left out.
    pub missing: usize,
    /// What is odd, in sentences.
    pub notes: Vec<String>,
}

impl Source {
    fn of(format: Format) -> Self {
        Self {
            format,
            frame: String::new(),
            time_ns: None,
            points: None,
            points_a_cell: None,
            missing: 0,
            notes: Vec::new(),
        }
    }
}

/// Reads the map of a file: a GeoTIFF, an ESRI ASCII grid, a CSV table with the columns `x_m`, `y_m`, `z_m`, or a cloud of points of a
/// recording. What it is shows by its first bytes.
///
/// # Errors
/// [`HeightsError`] for a file that cannot be read, is none of these, contradicts itself, is too large, or has no ground within reach.
pub fn read(path: &Path, reading: &Reading) -> Result<(HeightMap, Source), HeightsError> {
    read_onto(path, reading, None)
}

/// The same for ground that was mapped before: points anywhere are put into the cells of `grid`.
///
/// # Errors
/// Those of [`read`].
pub fn read_after(path: &Path, reading: &Reading, grid: &Grid) -> Result<(HeightMap, Source), HeightsError> {
    read_onto(path, reading, Some(grid))
}

fn read_onto(
    path: &Path,
    reading: &Reading,
    grid: Option<&Grid>,
) -> Result<(HeightMap, Source), HeightsError> {
    let file = path.display().to_string();
    if is_recording(path) {
        let cloud = cloud(path, reading.topic.as_deref(), reading.moment)?;
        return of_cloud(&file, cloud, reading, grid);
    }
    let mut input = File::open(path).map_err(|error| HeightsError::file(&file, &error))?;
    let size = input.metadata().map_err(|error| HeightsError::file(&file, &error))?.len();
    let mut magic = [0; 4];
    let known = input.read_exact(&mut magic).is_ok();
    // The first line of an ASCII grid names its columns of cells.
    let is_tiff = known && matches!(&magic, b"II*\0" | b"MM\0*" | b"II+\0" | b"MM\0+");
    if is_tiff {
        return cropped(&file, geotiff::read(path, &file)?, reading, Source::of(Format::GeoTiff));
    }
    if size > MOST_BYTES {
        return Err(HeightsError::TooLarge { file, what: "bytes of text", count: size, most: MOST_BYTES });
    }
    let bytes = std::fs::read(path).map_err(|error| HeightsError::file(&file, &error))?;
    let text = std::str::from_utf8(&bytes).map_err(|_| {
        HeightsError::format(
            &file,
            "it is neither text nor TIFF nor a recording; give a GeoTIFF, an ESRI ASCII grid, a CSV table with x_m, y_m, z_m, or a recording with clouds of points",
        )
    })?;
    if ascii::is_grid(text) {
        return cropped(&file, ascii::read(text, &file)?, reading, Source::of(Format::AsciiGrid));
    }
    let (points, missing) = table::points(text, &file)?;
    if reading.cell_m.is_none()
        && let Some(map) = on_nodes(&points)?
    {
        return cropped(&file, map, reading, Source { missing, ..Source::of(Format::Table) });
    }
    gridded(&file, points, reading, grid, Source { missing, ..Source::of(Format::ScatteredTable) })
}

/// The map of a cloud: medians of its points in the cells of `grid`, or of a grid of its own. `file` stands for where it is from.
///
/// # Errors
/// [`HeightsError`] if no points are within reach, or the cells would be too many.
pub fn of_cloud(
    file: &str,
    cloud: Cloud,
    reading: &Reading,
    grid: Option<&Grid>,
) -> Result<(HeightMap, Source), HeightsError> {
    let source = Source {
        frame: cloud.frame,
        time_ns: Some(cloud.time_ns),
        missing: cloud.missing,
        notes: cloud.notes,
        ..Source::of(Format::Cloud)
    };
    gridded(file, cloud.points, reading, grid, source)
}

fn cropped(
    file: &str,
    map: HeightMap,
    reading: &Reading,
    source: Source,
) -> Result<(HeightMap, Source), HeightsError> {
    let nothing = || {
        let [[left, right], [below, above]] = map.grid().extent_m();
        let reason = format!(
            "no ground within {} m of the plate is on it; it reaches from x = {left} to {right} m and y = {below} to {above} m",
            reading.reach_m
        );
        HeightsError::format(file, reason)
    };
    let part = map.part(reading.around_m, reading.reach_m).filter(|part| part.seen() > 0);
    Ok((part.ok_or_else(nothing)?, source))
}

fn gridded(
    file: &str,
    mut points: Vec<[f64; 3]>,
    reading: &Reading,
    onto: Option<&Grid>,
    mut source: Source,
) -> Result<(HeightMap, Source), HeightsError> {
    let all = points.len();
    let [x, y] = reading.around_m;
    points.retain(|p| (p[0] - x).abs() <= reading.reach_m && (p[1] - y).abs() <= reading.reach_m);
    if points.is_empty() {
        let reason = format!("none of its {all} points is within {} m of the plate", reading.reach_m);
        return Err(HeightsError::format(file, reason));
    }
    let grid = onto.map_or_else(|| grid_over(file, &points, reading.cell_m), |grid| Ok(*grid))?;
    let chosen = onto.is_none() && reading.cell_m.is_none();
    let (map, count) = medians(grid, &points)?;
    source.points = Some(points.len());
    source.points_a_cell = Some(count);
    if chosen {
        source.notes.push(format!(
            "points are put into cells of {:.4} m, some five each; other cells can be asked for",
            map.grid().cell_m()
        ));
    }
    if count < 3 {
        source.notes.push(format!(
            "half of the cells of {file} have {count} points or fewer, whose median a stray point moves; larger cells are steadier"
        ));
    }
    Ok((map, source))
}
