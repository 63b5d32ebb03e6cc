//! What is asked of two height maps.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::request::finite;

/// What height maps before and after a stroke say: where the ground broke ahead of the plate, heap and furrow.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// The ground before the stroke: a GeoTIFF, an ESRI ASCII grid, a CSV table with x_m, y_m, z_m, or a recording with clouds of points
    /// (sensor_msgs/PointCloud2), in m, with z upwards
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub before: PathBuf,

    /// The ground after the stroke, in the same frame; a recording may be the same one
    #[arg(value_hint = clap::ValueHint::AnyPath)]
    pub after: PathBuf,

    /// Middle of the plate's face at the surface where the stroke ended (m), in the frame of the maps; without it, what the arm in the recording
    /// tells
    #[arg(long = "plate-x", value_name = "M", value_parser = finite, allow_negative_numbers = true, requires_all = ["plate_y_m", "heading_deg"])]
    #[schemars(extend("minimum" = -1e8, "maximum" = 1e8))]
    pub plate_x_m: Option<f64>,

    /// The same along y (m)
    #[arg(long = "plate-y", value_name = "M", value_parser = finite, allow_negative_numbers = true, requires = "plate_x_m")]
    #[schemars(extend("minimum" = -1e8, "maximum" = 1e8))]
    pub plate_y_m: Option<f64>,

    /// Where the plate pushed to (deg), counter-clockwise from the x axis; without it, where the arm moved the plate between the clouds
    #[arg(long = "heading", value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = -360.0, "maximum" = 360.0))]
    pub heading_deg: Option<f64>,

    /// Standard deviation of the plate's place along its heading (m); without it half a cell is taken
    #[arg(long = "plate-sd", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = 0.0, "maximum" = 10.0))]
    pub plate_sd_m: Option<f64>,

    /// Width of the plate (m); of the stroke in --strokes, if it is not given
    #[arg(long = "width", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = 1e-4, "maximum" = 100.0))]
    pub width_m: Option<f64>,

    /// Depth of the plate (m), which tells how far the furrow says that it pushed; of the stroke in --strokes or of the arm, if it is not given
    #[arg(long = "depth", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 100.0))]
    pub depth_m: Option<f64>,

    /// Standard deviation of heights (m), if it is known; noise is taken to be no less
    #[arg(long = "height-sd", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = 0.0, "maximum" = 10.0))]
    pub height_sd_m: Option<f64>,

    /// Standard deviations of the noise that a change must have to count
    #[arg(long, value_name = "N", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().deviations)]
    #[schemars(extend("minimum" = 1.0, "maximum" = 10.0))]
    pub deviations: f64,

    /// Ground farther than this from the plate is left out (m); without it ten widths of the plate
    #[arg(long = "reach", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 10000.0))]
    pub reach_m: Option<f64>,

    /// Side of the cells (m) that clouds of points and scattered tables are put into; without it, of cells that have some five points
    #[arg(long = "cell", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = 1e-6, "maximum" = 1000.0))]
    pub cell_m: Option<f64>,

    /// Topic of the clouds in recordings; without it the only one there is
    #[arg(long, value_name = "TOPIC")]
    pub topic: Option<String>,

    /// Of a recording before the stroke, the last cloud up to this time (s) after the first; without it the first
    #[arg(long = "before-at", value_name = "S", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = 0.0))]
    pub before_at_s: Option<f64>,

    /// Of a recording after the stroke, the last cloud up to this time (s) after the first; without it the last
    #[arg(long = "after-at", value_name = "S", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("minimum" = 0.0))]
    pub after_at_s: Option<f64>,

    /// Link at the plate's lower edge, its z axis down along the plate, of the arm in the recording [default: plate_tip]
    #[arg(long, value_name = "LINK", conflicts_with = "plate_x_m")]
    pub plate_frame: Option<String>,

    /// URDF of that arm [default: the one in the recording]
    #[arg(long, value_name = "FILE", conflicts_with = "plate_x_m", value_hint = clap::ValueHint::AnyPath)]
    pub urdf: Option<PathBuf>,

    /// Topic of its joint states [default: /joint_states, or the only one]
    #[arg(long, value_name = "TOPIC", conflicts_with = "plate_x_m")]
    pub joint_topic: Option<String>,

    /// Stroke table (CSV) that the stroke is in
    #[arg(long, value_name = "FILE", requires = "stroke", value_hint = clap::ValueHint::AnyPath)]
    pub strokes: Option<PathBuf>,

    /// Its `stroke_id` there
    #[arg(long, value_name = "ID", requires = "strokes")]
    pub stroke: Option<String>,

    /// Writes the stroke table with `break_distance_m` and `break_distance_sd_m` of the stroke, for `surface`
    #[arg(long, value_name = "FILE", requires = "strokes")]
    pub out: Option<PathBuf>,

    /// Writes over a file that is there
    #[arg(long, requires = "out")]
    pub replace: bool,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            before: PathBuf::new(),
            after: PathBuf::new(),
            plate_x_m: None,
            plate_y_m: None,
            heading_deg: None,
            plate_sd_m: None,
            width_m: None,
            depth_m: None,
            height_sd_m: None,
            deviations: 3.0,
            reach_m: None,
            cell_m: None,
            topic: None,
            before_at_s: None,
            after_at_s: None,
            plate_frame: None,
            urdf: None,
            joint_topic: None,
            strokes: None,
            stroke: None,
            out: None,
            replace: false,
        }
    }
}
