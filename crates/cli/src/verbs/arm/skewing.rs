//! `soilctl arm skewing`: the table and the figure of section 5.3.1.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_controller::laws::Skew;
use soilctl_controller::{Params, StrokePlan};
use soilctl_figure::Size;
use soilctl_kinematics::TaskPose;

use super::{figure, read};
use crate::args::finite;
use crate::error::CliError;
use crate::output::{Answer, Output};
use crate::text::columns;
use crate::verbs::save_figure;

/// Directions of the error in the table, in degrees: outwards, up, and between.
const TABLE_DEG: [f64; 4] = [0.0, 45.0, 90.0, 135.0];

#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Arm file (.toml)
    #[arg(long, value_name = "FILE")]
    arm: Option<PathBuf>,

    /// Settings of the controller (.toml)
    #[arg(long, value_name = "FILE")]
    controller: Option<PathBuf>,

    /// Radii of the tip (m; a list with commas); 8, 12 and 17 in if not given
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true, value_delimiter = ',',
          default_values_t = [0.2032, 0.3048, 0.4318])]
    radius: Vec<f64>,

    /// Height of the tip over the base (m)
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = -0.3175)]
    height: f64,

    /// Tool angle (deg)
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true, default_value_t = 90.0)]
    alpha: f64,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// Directions of the tip's force against the errors that it answers.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SkewingAnswer {
    /// Height of the tip over the base in m.
    height_m: f64,
    /// Tool angle in degrees.
    alpha_deg: f64,
    /// One row a radius and direction.
    rows: Vec<Row>,
    /// Largest angle between force and error under the joint PID in degrees.
    worst_pid_deg: f64,
    /// The same under Cartesian stiffness.
    worst_stiffness_deg: f64,
}

/// One error of the tip.
#[derive(Debug, Serialize, JsonSchema)]
struct Row {
    /// Radius of the tip in m.
    radius_m: f64,
    /// Direction of the error in degrees: 0 outwards, 90 up.
    error_deg: f64,
    /// From the error to the force under the joint PID, positive from outwards to upwards, in degrees.
    pid_deg: f64,
    /// The same under Cartesian stiffness.
    stiffness_deg: f64,
}

pub(super) fn run(args: &Args, output: &mut Output) -> Result<(), CliError> {
    let arm = read(args.arm.as_deref())?;
    let none = StrokePlan::default();
    let params = match &args.controller {
        None => Params::new(arm, Params::thesis().config().clone(), none)?,
        Some(path) => Params::read(arm, path, none)?,
    };
    let at = |radius_m: f64, error_deg: f64| -> Result<Row, CliError> {
        let pose = TaskPose::digging(radius_m, 0.0, args.height, args.alpha.to_radians())?;
        let skew = Skew::new(&params, &pose, error_deg.to_radians())?;
        let [pid_deg, stiffness_deg] = [skew.pid_rad, skew.stiffness_rad].map(f64::to_degrees);
        Ok(Row { radius_m, error_deg, pid_deg, stiffness_deg })
    };
    let mut rows = Vec::new();
    let mut curves = Vec::new();
    for &radius_m in &args.radius {
        for error_deg in TABLE_DEG {
            rows.push(at(radius_m, error_deg)?);
        }
        let around = (0..=180).map(|deg| at(radius_m, f64::from(2 * deg))).collect::<Result<Vec<_>, _>>()?;
        let pick = |value: fn(&Row) -> f64| around.iter().map(|row| (row.error_deg, value(row))).collect();
        let [pid, stiffness] = [pick(|row| row.pid_deg), pick(|row| row.stiffness_deg)];
        curves.push(figure::Curves { radius_m, pid, stiffness });
    }
    if let Some(path) = &args.plot {
        save_figure(&figure::skewing(&curves)?, path, Size::default())?;
    }
    let worst = |pick: fn(&figure::Curves) -> &Vec<(f64, f64)>| {
        curves.iter().flat_map(pick).map(|(_, deg)| deg.abs()).fold(0.0, f64::max)
    };
    output.answer(&SkewingAnswer {
        height_m: args.height,
        alpha_deg: args.alpha,
        rows,
        worst_pid_deg: worst(|curves| &curves.pid),
        worst_stiffness_deg: worst(|curves| &curves.stiffness),
    })
}

impl Answer for SkewingAnswer {
    const SCHEMA: &'static str = "soilctl.arm-skewing/1";

    fn text(&self) -> String {
        let head = ["radius m", "error deg", "PID deg", "stiffness deg"].map(String::from).to_vec();
        let rows = self.rows.iter().map(|row| {
            vec![
                format!("{:.4}", row.radius_m),
                format!("{:.0}", row.error_deg),
                format!("{:.1}", row.pid_deg),
                format!("{:.0e}", row.stiffness_deg.abs()),
            ]
        });
        let table = columns(&std::iter::once(head).chain(rows).collect::<Vec<_>>());
        format!(
            "From the tip's error to the force that answers it; errors point outwards (0 deg) to upwards (90 deg).\n\n{table}\n\
             all around: up to {:.1} deg under the joint PID, {:.0e} deg under Cartesian stiffness\n",
            self.worst_pid_deg, self.worst_stiffness_deg
        )
    }
}
