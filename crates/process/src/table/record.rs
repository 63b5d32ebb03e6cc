use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_columns::{Range, columns};
use soilctl_strokes::StrokeRow;

use crate::log::LogStroke;
use crate::{Indiscernible, Kind, Outcome};

columns! {
    /// What a failure was like: the columns that stand beside those of [`StrokeRow`].
    #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
    pub struct FailureRow {} columns {
        failure_time_s: Option<f64>, "s", Range::Signed,
            "Time of the failure on the clock of the log", [diagnose], Logs;
        lift_deg: Option<f64>, "deg", Range::Signed,
            "Inclination of the force while failed soil slips along the plate, above the set-point, or without one above that \
             before the failure", [process], Logs;
        lift_sd_deg: Option<f64>, "deg", Range::AtLeastZero,
            "Standard deviation of `lift_deg`", [process], Logs;
        two_lines_force_n: Option<f64>, "N", Range::Signed,
            "Force where two lines fitted to the curve meet, the usual rule for gradual failures", [], Logs;
        mobilised: Option<f64>, "1", Range::AtLeastZero,
            "Share of the limit force that was mobilised at the end of a gradual failure", [], Logs;
        method: String, "text", Range::Text,
            "How the failure was found: `drop`, `run_away` or `saturation`", [], Logs;
        failure: String, "text", Range::Text,
            "`drastic` or `gradual`", [], Logs;
        flags: String, "text", Range::Text,
            "What to keep in mind, words parted by blanks; empty if nothing", [], Logs;
        log: String, "text", Range::Text,
            "The log", [process], Logs;
    }
}

/// A stroke of a log: its row of the stroke table, and what its failure was like.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct StrokeRecord {
    /// The columns of the stroke table. The stroke has a name.
    #[serde(flatten)]
    pub row: StrokeRow,
    /// What the failure was like.
    #[serde(flatten)]
    pub failure: FailureRow,
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
        let (gradual, failure) = match point.method.kind() {
            Kind::Drastic => (false, "drastic"),
            Kind::Gradual => (true, "gradual"),
        };
        let asked_deg = row.delta_set_deg.or(row.friction_angle_deg);
        let lift = stroke.evaluated.slip.zip(asked_deg);
        let mut flags: Vec<&str> = stroke.flags.clone();
        if let Some(finish) = stroke.finish.as_deref().filter(|finish| *finish != "completed") {
            flags.push(finish);
        }
        let two_lines_force_n = analysis.two_lines.map(|lines| lines.force_n);
        Ok(Self {
            row: StrokeRow { stroke_id: Some(stroke_id), ..row.clone() },
            failure: FailureRow {
                failure_time_s: Some(point.time_s),
                lift_deg: lift.map(|(slip, asked_deg)| slip.angle_deg - asked_deg),
                lift_sd_deg: lift.map(|(slip, _)| slip.sd_deg),
                two_lines_force_n: two_lines_force_n.filter(|force| force.is_finite()),
                mobilised: analysis.saturation.filter(|_| gradual).map(|curve| curve.mobilised),
                method: point.method.name().to_owned(),
                failure: failure.to_owned(),
                flags: flags.join(" "),
                log,
            },
        })
    }

    /// Name of the stroke.
    #[must_use]
    pub fn name(&self) -> &str {
        self.row.stroke_id.as_deref().unwrap_or_default()
    }
}
