/// One stroke. `None` means not measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StrokeRow {
    /// Line in the file, from 1 (the header is line 1).
    pub line: usize,
    /// Name of the stroke.
    pub stroke_id: Option<String>,
    /// Name of the preparation the stroke was made in.
    pub batch: Option<String>,
    /// Order within the batch.
    pub order: Option<u32>,
    /// Time of the stroke on the campaign clock, in s.
    pub time_s: Option<f64>,
    /// Tool angle, above 0 and below 180 deg.
    pub alpha_deg: f64,
    /// Vertical depth of the plate's lower edge below the surface, above 0 m.
    pub depth_m: f64,
    /// Width of the plate, above 0 m.
    pub width_m: f64,
    /// Speed of the plate in m/s.
    pub speed_mps: Option<f64>,
    /// Radius from the base axis at which the stroke was made, in m.
    pub radius_m: Option<f64>,
    /// Base angle at which the stroke was made, in deg.
    pub base_deg: Option<f64>,
    /// Edge distance to the nearest earlier stroke in this preparation, in m.
    pub gap_prior_m: Option<f64>,
    /// From the edge of the plate to the nearest wall, in m.
    pub wall_m: Option<f64>,
    /// Bulk density measured for the batch, in kg/m3.
    pub density_kg_m3: Option<f64>,
    /// Interface friction angle that the controller was set to, in deg.
    pub delta_set_deg: Option<f64>,
    /// Failure force: magnitude of the in-plane resultant, tare removed, above 0 N.
    pub force_n: f64,
    /// Standard deviation of the failure force in N.
    pub force_sd_n: Option<f64>,
    /// Free-air reading before the stroke, of the same sign as the force, in N.
    pub tare_before_n: Option<f64>,
    /// Free-air reading after the stroke, in N.
    pub tare_after_n: Option<f64>,
    /// Force from the motor torques minus that of the sensor, in N.
    pub cmd_minus_force_n: Option<f64>,
    /// Measured friction angle just before failure, in deg.
    pub friction_angle_deg: Option<f64>,
    /// Vertical drift of the tip, up positive, in m.
    pub z_drift_m: Option<f64>,
    /// Displacement at failure, compensated for flexion, in m.
    pub displacement_at_failure_m: Option<f64>,
    /// Slope after the break, `(dF/du) H/F`.
    pub post_slope_norm: Option<f64>,
    /// Force half a depth after failure over the failure force.
    pub residual_ratio: Option<f64>,
    /// Height of the heap before the stroke, above the datum, in m.
    pub heap_height_m: Option<f64>,
    /// Motor-side minus external position, in m.
    pub motor_ext_gap_m: Option<f64>,
    /// Smallest repeated encoder step, in m.
    pub x_step_m: Option<f64>,
}

impl StrokeRow {
    /// A text cell by the name of its column.
    pub(crate) fn text(&self, column: &str) -> Option<&str> {
        match column {
            "stroke_id" => self.stroke_id.as_deref(),
            "batch" => self.batch.as_deref(),
            _ => None,
        }
    }

    /// Sets a text cell; nothing happens if the column is unknown.
    pub(crate) fn set_text(&mut self, column: &str, text: Option<&str>) {
        match column {
            "stroke_id" => self.stroke_id = text.map(str::to_owned),
            "batch" => self.batch = text.map(str::to_owned),
            _ => {}
        }
    }
}
