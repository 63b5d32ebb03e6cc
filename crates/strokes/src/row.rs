//! The one table of the columns of `strokes.csv`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use soilctl_columns::{Column, Columns, Kind, Range, Source, columns};

columns! {
    /// One stroke. `None` means not measured.
    #[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
    pub struct StrokeRow {
        /// Line in the file, from 1 (the header is line 1).
        #[serde(skip)]
        pub line: usize,
    } columns {
        #[schemars(with = "String")]
        stroke_id: Option<String>, "text", Range::Text,
            "Name of the stroke; no other stroke of the table has it", [estimate predict diagnose], Logs;
        batch: Option<String>, "text", Range::Text,
            "Name of the preparation the stroke was made in", [estimate predict diagnose], Logs;
        order: Option<u32>, "1", Range::Whole,
            "Order within the preparation, from 1", [diagnose], Logs;
        time_s: Option<f64>, "s", Range::Signed,
            "Time of the stroke on the clock of the campaign", [estimate predict diagnose], Logs;
        alpha_deg: f64, "deg", Range::Between0And(180.0),
            "Tool angle, from the ground ahead to the plate", [estimate predict diagnose], Logs;
        depth_m: f64, "m", Range::Positive,
            "Vertical depth of the plate's lower edge below the surface where the soil failed", [estimate predict diagnose], Logs;
        depth_sd_m: Option<f64>, "m", Range::AtLeastZero,
            "Standard deviation of `depth_m`: how well surface and edge are known", [estimate], Logs;
        width_m: f64, "m", Range::Positive,
            "Width of the plate", [estimate predict diagnose], Logs;
        speed_mps: Option<f64>, "m/s", Range::AtLeastZero,
            "Mean speed of the plate up to failure", [estimate predict diagnose], Logs;
        radius_m: Option<f64>, "m", Range::AtLeastZero,
            "Radius from the base axis at which the stroke was made", [estimate predict diagnose], Logs;
        base_deg: Option<f64>, "deg", Range::Signed,
            "Base angle at which the stroke was made", [estimate predict diagnose], Logs;
        gap_prior_m: Option<f64>, "m", Range::AtLeastZero,
            "Edge distance to the nearest earlier stroke in this preparation", [estimate predict diagnose], Logs;
        wall_m: Option<f64>, "m", Range::AtLeastZero,
            "From the edge of the plate to the nearest wall", [estimate predict diagnose], Logs;
        density_kg_m3: Option<f64>, "kg/m3", Range::Positive,
            "Bulk density weighed for the batch", [estimate predict diagnose], Logs;
        delta_set_deg: Option<f64>, "deg", Range::From0Below(90.0),
            "Interface friction angle that the controller was set to", [estimate predict diagnose], Logs;
        force_n: f64, "N", Range::Positive,
            "Failure force: magnitude of the in-plane resultant, tare removed", [estimate predict diagnose], Logs;
        force_sd_n: Option<f64>, "N", Range::Deviation,
            "Standard deviation of the failure force", [estimate diagnose], Logs;
        tare_before_n: Option<f64>, "N", Range::Signed,
            "Free-air reading before the stroke, along the force", [diagnose], Logs;
        tare_after_n: Option<f64>, "N", Range::Signed,
            "Free-air reading after the stroke, along the force", [diagnose], Logs;
        cmd_minus_force_n: Option<f64>, "N", Range::Signed,
            "Force from the motor torques minus that of the sensor, before failure", [diagnose], Logs;
        friction_angle_deg: Option<f64>, "deg", Range::Signed,
            "Measured friction angle just before failure", [estimate diagnose], Logs;
        friction_angle_sd_deg: Option<f64>, "deg", Range::AtLeastZero,
            "Standard deviation of `friction_angle_deg`", [estimate], Logs;
        turned_deg: Option<f64>, "deg", Range::Signed,
            "How far the tool angle had grown at failure, since the arm turns the plate while it pulls", [estimate demo], Logs;
        z_drift_m: Option<f64>, "m", Range::Signed,
            "Drift of the plate's lower edge up to failure, up positive", [diagnose], Logs;
        displacement_at_failure_m: Option<f64>, "m", Range::Signed,
            "Displacement at failure, compensated for flexion", [diagnose], Logs;
        post_slope_norm: Option<f64>, "1", Range::Signed,
            "Slope after the break, `(dF/du) H/F`", [diagnose], Logs;
        residual_ratio: Option<f64>, "1", Range::Signed,
            "Force half a depth after failure over the failure force", [diagnose], Logs;
        #[schemars(skip)]
        heap_height_m: Option<f64>, "m", Range::Signed,
            "Height of the heap before the stroke, above the datum", [diagnose], Hand;
        motor_ext_gap_m: Option<f64>, "m", Range::Signed,
            "Motor-side minus external position before failure", [diagnose], Logs;
        x_step_m: Option<f64>, "m", Range::AtLeastZero,
            "Usual step of the external encoders at the plate", [diagnose], Logs;
        air_across_n: Option<f64>, "N", Range::Signed,
            "Free-air reading before the stroke across the plate, weight and zero of the sensor in it", [diagnose], Logs;
        air_along_n: Option<f64>, "N", Range::Signed,
            "The same along the plate", [diagnose], Logs;
        touch_z_m: Option<f64>, "m", Range::Signed,
            "Height of the surface where the plate met it, above that which the log states", [diagnose], Logs;
        insertion_force_n: Option<f64>, "N", Range::Signed,
            "Mean force along the plate over the way of its insertion, work over way", [diagnose], Logs;
        motor_angle_deg: Option<f64>, "deg", Range::Signed,
            "Inclination of the force by the motor torques minus that by the sensor, before failure", [diagnose], Logs;
        shoulder_loop_deg: Option<f64>, "deg", Range::Signed,
            "Motor minus external angle of the shoulder before failure, above that in free air before the stroke", [diagnose], Logs;
        elbow_loop_deg: Option<f64>, "deg", Range::Signed,
            "The same of the elbow", [diagnose], Logs;
        #[schemars(skip)]
        place: Option<String>, "text", Range::Text,
            "Name of the place where the stroke was made; strokes of one name are at one place", [places], Hand;
        #[schemars(skip)]
        place_x_m: Option<f64>, "m", Range::Signed,
            "Where that is in the field, along an axis of one's own or to the east", [places], Hand;
        #[schemars(skip)]
        place_y_m: Option<f64>, "m", Range::Signed,
            "The same across it, counter-clockwise from the first, or to the north", [places], Hand;
        break_distance_m: Option<f64>, "m", Range::Positive,
            "From the plate's face at the surface, along the surface ahead, to where the ground broke at failure", [surface], Logs;
        break_distance_sd_m: Option<f64>, "m", Range::Deviation,
            "Standard deviation of `break_distance_m`", [surface], Logs;
    }
}

impl StrokeRow {
    /// Columns that logs tell, in the order of answers and of Parquet: first what every stroke has, then numbers that may be
    /// missing.
    pub fn logged() -> impl Iterator<Item = &'static Column<Self>> {
        let may_be_missing = |column: &Column<Self>| column.about.kind == Kind::OptionalFloat;
        let logged = || Self::COLUMNS.iter().filter(|column| column.about.source == Source::Logs);
        logged().filter(move |c| !may_be_missing(c)).chain(logged().filter(move |c| may_be_missing(c)))
    }
}

/// A stroke as answers have it: the columns of [`StrokeRow::logged`].
impl Serialize for StrokeRow {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(Self::logged().map(|column| (column.about.name, (column.get)(self))))
    }
}
