use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_strokes::StrokeRow;

use crate::log::LogStroke;
use crate::{Indiscernible, Outcome};

macro_rules! record {
    ($($(#[$doc:meta])* $field:ident),* $(,)?) => {
        /// A stroke as it stands in a table: the columns of [`StrokeRow`], and what its failure was like.
        #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
        pub struct StrokeRecord {
            /// Name of the stroke.
            pub stroke_id: String,
            /// Name of the preparation the stroke was made in.
            pub batch: Option<String>,
            /// Order within the preparation, from 1.
            pub order: Option<u32>,
            /// Tool angle in deg.
            pub alpha_deg: f64,
            /// Vertical depth of the plate's lower edge below the surface where the soil failed, in m.
            pub depth_m: f64,
            /// Width of the plate in m.
            pub width_m: f64,
            /// Failure force in N: magnitude of the in-plane resultant, tare removed.
            pub force_n: f64,
            $($(#[$doc])* pub $field: Option<f64>,)*
            /// How the failure was found: `drop`, `run_away` or `saturation`.
            pub method: String,
            /// `drastic` or `gradual`.
            pub failure: String,
            /// What to keep in mind, words parted by blanks; empty if nothing.
            pub flags: String,
            /// The log.
            pub log: String,
        }

        impl StrokeRecord {
            /// Numbers that may be missing, by name, in the order of the columns.
            pub(super) fn numbers(&self) -> Vec<(&'static str, Option<f64>)> {
                vec![
                    ("order", self.order.map(f64::from)),
                    ("alpha_deg", Some(self.alpha_deg)),
                    ("depth_m", Some(self.depth_m)),
                    ("width_m", Some(self.width_m)),
                    ("force_n", Some(self.force_n)),
                    $((stringify!($field), self.$field),)*
                ]
            }
        }
    };
}

record! {
    /// Time of the stroke in s: on the log's clock, or on the campaign's after [`super::put_on_one_clock`].
    time_s,
    /// Mean speed of the plate up to failure in m/s.
    speed_mps,
    /// Radius from the base axis in m.
    radius_m,
    /// Base angle in deg.
    base_deg,
    /// Edge distance to the nearest earlier stroke in this preparation in m.
    gap_prior_m,
    /// From the edge of the plate to the nearest wall that the log knows in m.
    wall_m,
    /// Density weighed for the batch, from the log's notes, in kg/m^3.
    density_kg_m3,
    /// Interface friction angle that the controller was set to in deg.
    delta_set_deg,
    /// Standard deviation of the failure force in N.
    force_sd_n,
    /// Free-air reading before the stroke, along the force, in N.
    tare_before_n,
    /// Free-air reading after the stroke in N.
    tare_after_n,
    /// Force from the motor torques minus that of the sensor, before failure, in N.
    cmd_minus_force_n,
    /// Measured friction angle just before failure in deg.
    friction_angle_deg,
    /// Drift of the plate's lower edge up to failure, up positive, in m.
    z_drift_m,
    /// Displacement at failure, compensated for flexion, in m.
    displacement_at_failure_m,
    /// Slope after the break, `(dF/du) H/F`.
    post_slope_norm,
    /// Force half a depth after failure over the failure force.
    residual_ratio,
    /// Motor-side minus external position before failure in m.
    motor_ext_gap_m,
    /// Usual step of the external encoders at the plate in m.
    x_step_m,
    /// Time of the failure on the log's clock in s.
    failure_time_s,
    /// How far the tool angle had grown at failure, since the arm turns the plate while it pulls, in deg.
    turned_deg,
    /// Inclination of the force while failed soil slips along the plate, above the set-point, or without one above that
    /// before the failure, in deg.
    lift_deg,
    /// Its standard deviation in deg.
    lift_sd_deg,
    /// Force where two lines fitted to the curve meet in N, the usual rule for gradual failures.
    two_lines_force_n,
    /// Share of the limit force that was mobilised at the end of a gradual failure.
    mobilised,
}

impl StrokeRecord {
    /// A stroke of a log under a name, or why it has no failure force.
    ///
    /// # Errors
    /// The [`Indiscernible`] of the stroke.
    pub fn new(stroke: &LogStroke, stroke_id: String, log: String) -> Result<Self, Indiscernible> {
        let (row, analysis) = (&stroke.evaluated.row, &stroke.evaluated.analysis);
        let point = match &analysis.outcome {
            Outcome::Found(point) => point,
            Outcome::Indiscernible(reason) => return Err(*reason),
        };
        let kind = match point.method.kind() {
            crate::Kind::Drastic => "drastic",
            crate::Kind::Gradual => "gradual",
        };
        let slip = stroke.evaluated.slip;
        let asked_deg = row.delta_set_deg.or(row.friction_angle_deg);
        let mut flags: Vec<&str> = stroke.flags.clone();
        if let Some(finish) = stroke.finish.as_deref().filter(|finish| *finish != "completed") {
            flags.push(finish);
        }
        Ok(Self {
            stroke_id,
            batch: row.batch.clone(),
            order: row.order,
            alpha_deg: row.alpha_deg,
            depth_m: row.depth_m,
            width_m: row.width_m,
            force_n: row.force_n,
            time_s: row.time_s,
            speed_mps: row.speed_mps,
            radius_m: row.radius_m,
            base_deg: row.base_deg,
            gap_prior_m: row.gap_prior_m,
            density_kg_m3: row.density_kg_m3,
            wall_m: row.wall_m,
            delta_set_deg: row.delta_set_deg,
            force_sd_n: row.force_sd_n,
            tare_before_n: row.tare_before_n,
            tare_after_n: row.tare_after_n,
            cmd_minus_force_n: row.cmd_minus_force_n,
            friction_angle_deg: row.friction_angle_deg,
            z_drift_m: row.z_drift_m,
            displacement_at_failure_m: row.displacement_at_failure_m,
            post_slope_norm: row.post_slope_norm,
            residual_ratio: row.residual_ratio,
            motor_ext_gap_m: row.motor_ext_gap_m,
            x_step_m: row.x_step_m,
            failure_time_s: Some(point.time_s),
            turned_deg: stroke.evaluated.turned_deg,
            lift_deg: slip.zip(asked_deg).map(|(slip, asked)| slip.angle_deg - asked),
            lift_sd_deg: slip.zip(asked_deg).map(|(slip, _)| slip.sd_deg),
            two_lines_force_n: analysis
                .two_lines
                .map(|lines| lines.force_n)
                .filter(|force| force.is_finite()),
            mobilised: analysis.saturation.filter(|_| kind == "gradual").map(|curve| curve.mobilised),
            method: point.method.name().to_owned(),
            failure: kind.to_owned(),
            flags: flags.join(" "),
            log,
        })
    }

    /// The columns that the stroke table knows.
    #[must_use]
    pub fn row(&self) -> StrokeRow {
        StrokeRow {
            stroke_id: Some(self.stroke_id.clone()),
            batch: self.batch.clone(),
            order: self.order,
            time_s: self.time_s,
            alpha_deg: self.alpha_deg,
            depth_m: self.depth_m,
            width_m: self.width_m,
            speed_mps: self.speed_mps,
            radius_m: self.radius_m,
            base_deg: self.base_deg,
            gap_prior_m: self.gap_prior_m,
            density_kg_m3: self.density_kg_m3,
            wall_m: self.wall_m,
            delta_set_deg: self.delta_set_deg,
            force_n: self.force_n,
            force_sd_n: self.force_sd_n,
            tare_before_n: self.tare_before_n,
            tare_after_n: self.tare_after_n,
            cmd_minus_force_n: self.cmd_minus_force_n,
            friction_angle_deg: self.friction_angle_deg,
            z_drift_m: self.z_drift_m,
            displacement_at_failure_m: self.displacement_at_failure_m,
            post_slope_norm: self.post_slope_norm,
            residual_ratio: self.residual_ratio,
            motor_ext_gap_m: self.motor_ext_gap_m,
            x_step_m: self.x_step_m,
            ..StrokeRow::default()
        }
    }

    /// Texts, by name, in the order of the columns.
    pub(super) fn texts(&self) -> [(&'static str, &str); 6] {
        [
            ("stroke_id", &self.stroke_id),
            ("batch", self.batch.as_deref().unwrap_or_default()),
            ("method", &self.method),
            ("failure", &self.failure),
            ("flags", &self.flags),
            ("log", &self.log),
        ]
    }
}
