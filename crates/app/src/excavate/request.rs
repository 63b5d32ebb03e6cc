//! What is asked of an excavation.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_digging::{Aim, Rules, Trench};
use soilctl_earth_pressure::MODEL_IDS;

use crate::request::{finite, model_help};
use crate::{AppError, TableSource};

/// What is to be least.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum Least {
    /// The greatest share of a torque limit
    #[default]
    Torque,
    /// Squared currents, the heat of the motors
    Heat,
    /// Work on the soil for its volume
    Work,
}

impl Least {
    pub(super) const fn aim(self) -> Aim {
        match self {
            Self::Torque => Aim::Torque,
            Self::Heat => Aim::Heat,
            Self::Work => Aim::Work,
        }
    }
}

/// A trench in passes that keep to a share of the torque limits: how the plate fails the soil at least cost to the motors
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Soil of the simulated box that is dug in: a preset of data/plant/soils.toml without cohesion
    #[arg(long, value_name = "NAME", default_value_t = Request::default().soil)]
    pub soil: String,

    /// Friction angles that are thought possible (deg): one, or a least and a greatest [default: that of the soil]
    #[arg(long = "phi", value_name = "LOW,HIGH", value_delimiter = ',', num_args = 1, value_parser = finite, allow_hyphen_values = true,
          conflicts_with = "strokes")]
    pub phi_deg: Option<Vec<f64>>,

    /// Friction on the plate that is thought possible (deg) [default: that of the soil]
    #[arg(long = "delta", value_name = "LOW,HIGH", value_delimiter = ',', num_args = 1, value_parser = finite, allow_hyphen_values = true)]
    pub delta_deg: Option<Vec<f64>>,

    /// Densities that are thought possible (kg/m3) [default: that of the soil]
    #[arg(long = "density", value_name = "LOW,HIGH", value_delimiter = ',', num_args = 1, value_parser = finite, allow_hyphen_values = true)]
    pub density_kg_m3: Option<Vec<f64>>,

    /// Stroke table (CSV) whose estimate says which soils are possible, as `soilctl estimate` finds it with the friction on the plate of the table
    #[arg(long, value_name = "FILE", value_hint = clap::ValueHint::AnyPath)]
    pub strokes: Option<TableSource>,

    /// Force model whose lower bounds count as borne and whose upper bounds as enough to fail
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model, help = model_help())]
    #[schemars(extend("enum" = MODEL_IDS))]
    pub model: String,

    /// Radius of the far end of the trench from the base axis (m)
    #[arg(long = "radius", value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().radius_m)]
    #[schemars(extend("exclusiveMinimum" = 0.0), range(max = 10.0))]
    pub radius_m: f64,

    /// Base angle of the trench (deg)
    #[arg(long = "base", value_name = "DEG", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().base_deg)]
    #[schemars(range(min = -180.0, max = 180.0))]
    pub base_deg: f64,

    /// Length of the trench towards the base (m), which is that of each pass
    #[arg(long = "length", value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().length_m)]
    #[schemars(range(min = 0.01, max = 0.5))]
    pub length_m: f64,

    /// Depth of the trench (m)
    #[arg(long = "depth", value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().depth_m)]
    #[schemars(range(min = 0.015, max = 0.5))]
    pub depth_m: f64,

    /// Greatest depth of a pass (m)
    #[arg(long = "pass-depth", value_name = "M", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().pass_depth_m)]
    #[schemars(range(min = 0.015, max = 0.5))]
    pub pass_depth_m: f64,

    /// Share of the torque limits of joints and motors that a pass may take, in every soil that is possible
    #[arg(long, value_name = "SHARE", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().share)]
    #[schemars(range(max = 1.0), extend("exclusiveMinimum" = 0.0))]
    pub share: f64,

    /// Tool angles that may be used (deg): a least and a greatest, 45 to 135
    #[arg(long = "alpha", value_name = "LOW,HIGH", value_delimiter = ',', num_args = 1, value_parser = finite, allow_hyphen_values = true,
          default_values_t = Request::default().alpha_deg)]
    pub alpha_deg: Vec<f64>,

    /// What is to be least, among tool angles that keep the share
    #[arg(long, value_name = "WHAT", value_enum, default_value_t)]
    pub least: Least,

    /// Digs the trench on the simulated arm: replanned by what each pass taught, without learning, and with the same passes at a fixed tool angle of 90 deg
    #[arg(long)]
    pub dig: bool,

    /// Seed of noise and scatter of the simulation
    #[arg(long, value_name = "N", default_value_t = Request::default().seed)]
    pub seed: u64,

    /// Folder for plan.toml and controller.toml, which `soilctl simulate` runs; made if it is not there
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Writes the passes that were planned, or dug, as a table (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub table: Option<PathBuf>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            soil: "ticino_loose".into(),
            phi_deg: None,
            delta_deg: None,
            density_kg_m3: None,
            strokes: None,
            model: "table".into(),
            radius_m: 0.36,
            base_deg: 0.0,
            length_m: 0.05,
            depth_m: 0.028,
            pass_depth_m: 0.028,
            share: 0.7,
            alpha_deg: vec![70.0, 100.0],
            least: Least::Torque,
            dig: false,
            seed: 1,
            out: None,
            table: None,
        }
    }
}

/// Least depth of a pass in m: of shallower ones sand bears so little that the controller does not find the plate's face taut.
const LEAST_PASS_M: f64 = 0.015;

impl Request {
    pub(super) fn trench(&self) -> Trench {
        Trench {
            radius_m: self.radius_m,
            base_rad: self.base_deg.to_radians(),
            length_m: self.length_m,
            depth_m: self.depth_m,
        }
    }

    /// Least and greatest tool angle in deg.
    pub(super) fn angles_deg(&self) -> Result<[f64; 2], AppError> {
        let angles_deg = match self.alpha_deg[..] {
            [one] => [one, one],
            [low, high] => [low, high],
            _ => {
                return Err(AppError::Request(
                    "--alpha must be one tool angle or a least and a greatest, such as 70,100".into(),
                ));
            }
        };
        let [low, high] = angles_deg;
        if !(low >= 45.0 && low <= high && high <= 135.0) {
            return Err(AppError::OutOfRange {
                key: "alpha_deg".into(),
                value: format!("{low},{high}"),
                allowed: "from 45 to 135 deg, the lesser first: what the controller strokes at".into(),
            });
        }
        Ok(angles_deg)
    }

    pub(super) fn rules(&self, friction_nm: [f64; 5]) -> Result<Rules, AppError> {
        Ok(Rules {
            share: self.share,
            angles_deg: self.angles_deg()?,
            aim: self.least.aim(),
            friction_nm,
            least_m: LEAST_PASS_M,
            most_m: self.pass_depth_m,
        })
    }
}

/// One number or two, as an interval.
pub(super) fn interval(key: &str, given: &[f64]) -> Result<[f64; 2], AppError> {
    match given[..] {
        [one] => Ok([one, one]),
        [low, high] => Ok([low, high]),
        _ => Err(AppError::Request(format!(
            "--{key} must be one number, or a least and a greatest with a comma"
        ))),
    }
}
