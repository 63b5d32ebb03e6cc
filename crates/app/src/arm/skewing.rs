//! By how much joint springs turn the plate's force away from where the plate is to go (Hong 2001, section 5.3.1).

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_controller::laws::Skew;
use soilctl_controller::{Params, StrokePlan};
use soilctl_kinematics::TaskPose;

use super::read;
use crate::request::{check, finite};
use crate::{AppError, Watch};

/// Directions of the error in the table, in degrees: outwards, up, and between.
const TABLE_DEG: [f64; 4] = [0.0, 45.0, 90.0, 135.0];

/// Directions of the tip's force against the errors that it answers.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Arm file (.toml)
    #[arg(long, value_name = "FILE")]
    pub arm: Option<PathBuf>,

    /// Settings of the controller (.toml)
    #[arg(long, value_name = "FILE")]
    pub controller: Option<PathBuf>,

    /// Radii of the tip (m; a list with commas); 8, 12 and 17 in if not given
    #[arg(long = "radius", value_name = "M", value_parser = finite, allow_negative_numbers = true, value_delimiter = ',',
          default_values_t = Request::default().radius_m)]
    pub radius_m: Vec<f64>,

    /// Height of the tip over the base (m)
    #[arg(long = "height", value_name = "M", value_parser = finite, allow_negative_numbers = true,
          default_value_t = Request::default().height_m)]
    pub height_m: f64,

    /// Tool angle (deg)
    #[arg(long = "alpha", value_name = "DEG", value_parser = finite, allow_negative_numbers = true,
          default_value_t = Request::default().alpha_deg)]
    pub alpha_deg: f64,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            arm: None,
            controller: None,
            radius_m: vec![0.2032, 0.3048, 0.4318],
            height_m: -0.3175,
            alpha_deg: 90.0,
        }
    }
}

/// Directions of the tip's force against the errors that it answers.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Height of the tip over the base in m.
    pub height_m: f64,
    /// Tool angle in degrees.
    pub alpha_deg: f64,
    /// One row a radius and direction.
    pub rows: Vec<Row>,
    /// Largest angle between force and error under the joint PID in degrees.
    pub worst_pid_deg: f64,
    /// The same under Cartesian stiffness.
    pub worst_stiffness_deg: f64,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.arm-skewing/1";
}

/// One error of the tip.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Row {
    /// Radius of the tip in m.
    pub radius_m: f64,
    /// Direction of the error in degrees: 0 outwards, 90 up.
    pub error_deg: f64,
    /// From the error to the force under the joint PID, positive from outwards to upwards, in degrees.
    pub pid_deg: f64,
    /// The same under Cartesian stiffness.
    pub stiffness_deg: f64,
}

/// The answer, and the rows of errors all around for each radius, two degrees apart.
#[derive(Debug)]
pub struct Skewing {
    /// The answer.
    pub answer: Answer,
    /// All around, by radius.
    pub around: Vec<Vec<Row>>,
}

/// Compares both laws.
///
/// # Errors
/// [`AppError`] if the arm cannot reach a radius, or a file makes no sense.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Skewing, AppError> {
    check(request)?;
    let arm = read(request.arm.as_deref())?;
    let none = StrokePlan::default();
    let params = match &request.controller {
        None => Params::new(arm, Params::thesis().config().clone(), none)?,
        Some(path) => Params::read(arm, path, none)?,
    };
    let at = |radius_m: f64, error_deg: f64| -> Result<Row, AppError> {
        let pose = TaskPose::digging(radius_m, 0.0, request.height_m, request.alpha_deg.to_radians())?;
        let skew = Skew::new(&params, &pose, error_deg.to_radians())?;
        let [pid_deg, stiffness_deg] = [skew.pid_rad, skew.stiffness_rad].map(f64::to_degrees);
        Ok(Row { radius_m, error_deg, pid_deg, stiffness_deg })
    };
    let (mut rows, mut around) = (Vec::new(), Vec::new());
    for &radius_m in &request.radius_m {
        for error_deg in TABLE_DEG {
            rows.push(at(radius_m, error_deg)?);
        }
        let circle = (0..=180).map(|deg| at(radius_m, f64::from(2 * deg)));
        around.push(circle.collect::<Result<Vec<_>, _>>()?);
    }
    let worst =
        |pick: fn(&Row) -> f64| around.iter().flatten().map(|row| pick(row).abs()).fold(0.0, f64::max);
    let answer = Answer {
        height_m: request.height_m,
        alpha_deg: request.alpha_deg,
        rows,
        worst_pid_deg: worst(|row| row.pid_deg),
        worst_stiffness_deg: worst(|row| row.stiffness_deg),
    };
    Ok(Skewing { answer, around })
}
