//! What two height maps say, as plain data.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Outcome;

/// What a map was read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Format {
    /// A GeoTIFF.
    Geotiff,
    /// An ESRI ASCII grid.
    AsciiGrid,
    /// A table with points on a grid.
    Table,
    /// A table with points anywhere, put into cells.
    ScatteredTable,
    /// A cloud of points of a recording, put into cells.
    Cloud,
}

/// A map.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MapAnswer {
    /// Its file.
    pub file: String,
    /// What it was read from.
    pub format: Format,
    /// The frame that a cloud names; empty if there is none.
    pub frame: String,
    /// When a cloud was taken (s since 1970 by its stamp, or whatever its clock counts from); null for others.
    pub time_s: Option<f64>,
    /// Cells in a row, and rows, of what is within reach.
    pub size: [usize; 2],
    /// Side of a square as large as a cell (m).
    pub cell_m: f64,
    /// Cells that were seen.
    pub seen: usize,
    /// Points that were put into cells; null if heights came in cells.
    pub points: Option<usize>,
    /// Median of how many points are in a cell that has some; null likewise.
    pub points_per_cell: Option<usize>,
    /// Points without finite coordinates, left out.
    pub missing_points: usize,
}

/// The plate as its stroke ended.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct PlateAnswer {
    /// Middle of its face at the surface (m), in the frame of the maps: as given, or that of the arm's root.
    pub x_m: f64,
    /// The same along y (m).
    pub y_m: f64,
    /// Standard deviation of that along the heading (m).
    pub sd_m: f64,
    /// Where it pushed to (deg), counter-clockwise from the x axis.
    pub heading_deg: f64,
    /// Its width (m).
    pub width_m: f64,
    /// Its depth (m); null if it is not known.
    pub depth_m: Option<f64>,
}

/// How the second map was moved to lie on unchanged ground of the first.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct ShiftAnswer {
    /// Upwards at the plate (m).
    pub up_m: f64,
    /// Its standard deviation (m).
    pub up_sd_m: f64,
    /// Tilt along x and y (deg).
    pub tilt_deg: [f64; 2],
    /// Sideways along x and y (m); 0 where no slopes of the ground show it.
    pub sideways_m: [f64; 2],
}

/// Where the ground broke.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct BreakAnswer {
    /// Distance along the surface from the plate's face (m).
    pub distance_m: f64,
    /// Its standard deviation (m): noise, raggedness over the plate's width, and the plate's place.
    pub sd_m: f64,
    /// Half of the distance between neighbouring heights (m), within which the edge may be anywhere.
    pub resolution_m: f64,
    /// Two standard deviations and the resolution to either side (m).
    pub within_m: [f64; 2],
    /// The distance by each fifth of the plate's middle half, from right to left (m); null where it does not show.
    pub parts_m: Vec<Option<f64>>,
    /// Where the ground rises once more farther ahead (m); null if it does not.
    pub again_m: Option<f64>,
    /// What stands in a stroke table as `break_distance_sd_m` (m): standard deviation and resolution together, so that a band of any
    /// number of deviations holds both.
    pub table_sd_m: f64,
}

/// Soil that rose or sank.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct VolumeAnswer {
    /// Volume (m3).
    pub volume_m3: f64,
    /// Its standard deviation (m3).
    pub sd_m3: f64,
    /// The largest change of height (m).
    pub most_m: f64,
    /// Cells.
    pub cells: usize,
    /// Whether it reaches the edge of the map, so that there may be more.
    pub off_map: bool,
    /// Cells in or beside it that were not seen.
    pub hidden_cells: usize,
}

/// Change of height ahead of the plate's middle half.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ProfileAnswer {
    /// Distance ahead of the plate's face on the map (m).
    pub ahead_m: Vec<f64>,
    /// Mean change of height (m); null where it was not seen.
    pub rise_m: Vec<Option<f64>>,
    /// Standard deviation of such a mean where nothing happened (m).
    pub noise_m: f64,
    /// Lines over the plate's width.
    pub lines: usize,
}

/// Change of height around the plate, in the plate's directions and in cells that are coarser than those of the maps if these are many.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PictureAnswer {
    /// Side of the cells (m).
    pub cell_m: f64,
    /// Centres ahead of the plate's face (m).
    pub ahead_m: Vec<f64>,
    /// Centres to the left of its middle (m).
    pub left_m: Vec<f64>,
    /// Mean change (m), a list for each place to the left; null where it was not seen.
    pub change_m: Vec<Vec<Option<f64>>>,
}

/// The answer.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Answer {
    /// The maps before and after.
    pub maps: Vec<MapAnswer>,
    /// The plate as its stroke ended.
    pub plate: PlateAnswer,
    /// Standard deviation of the change of a cell where nothing happened (m).
    pub noise_m: f64,
    /// Variance of sums over many cells of noise, over that of as many independent cells.
    pub clumping: f64,
    /// Cells of unchanged ground.
    pub unchanged_cells: usize,
    /// Standard deviations of the noise that a change must have to count.
    pub deviations: f64,
    /// How the second map was moved.
    pub shift: ShiftAnswer,
    /// Slope of the ground ahead of the plate before the stroke (deg), positive where it rises.
    pub slope_deg: f64,
    /// Where the ground broke; null if that cannot be said.
    pub ground_break: Option<BreakAnswer>,
    /// Why it cannot be said; null if it can.
    pub no_break_because: Option<String>,
    /// What rose.
    pub heap: VolumeAnswer,
    /// What sank.
    pub furrow: VolumeAnswer,
    /// Heap over furrow: how much soil swells as it is moved; null without a furrow that stands out of the noise.
    pub swelling: Option<f64>,
    /// Its standard deviation.
    pub swelling_sd: Option<f64>,
    /// Length of a furrow of the plate's width and depth with as much volume (m); null if the depth is not given.
    pub pushed_m: Option<f64>,
    /// Cells that changed elsewhere, and are not counted.
    pub elsewhere_cells: usize,
    /// Change of height ahead of the plate.
    pub profile: ProfileAnswer,
    /// Change of height around the plate.
    pub picture: PictureAnswer,
    /// The stroke table that was written; null if none was asked for.
    pub written: Option<String>,
    /// The result in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.heights/1";

    /// Negative if it cannot be said where the ground broke.
    fn outcome(&self) -> Outcome {
        if self.ground_break.is_some() { Outcome::Done } else { Outcome::Negative }
    }
}
