//! What is asked about a tool near a buried body.

use std::path::PathBuf;

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits::Budget;
use crate::request::finite;
use crate::tool::Setting;

/// What a buried body does.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum BodyKind {
    /// It does not move, and soil sticks to it: rock, a foundation
    #[default]
    Fixed,
    /// A stone, which moves with the soil: strong, as rough as the soil beside it and as heavy
    Stone,
}

/// From what distance on the force of a tool says that something is buried ahead: proven bounds near a rigid body, over its distance.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub setting: Setting,

    /// Distances from the tool's tip ahead to the body, along the surface (m); by default 0.25, 0.5, 1, 1.5, 2, 3 and 4 times what of the tool is in the ground
    #[arg(long = "ahead", value_name = "M,...", value_delimiter = ',', value_parser = finite, allow_negative_numbers = true)]
    #[schemars(inner(range(min = 1e-6)))]
    pub ahead_m: Vec<f64>,

    /// Depth of the body's top below the surface (m)
    #[arg(long = "body-top", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub body_top_m: f64,

    /// Its height (m)
    #[arg(long = "body-height", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub body_height_m: f64,

    /// Its length along the motion (m); as long as high if not given
    #[arg(long = "body-length", value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub body_length_m: Option<f64>,

    /// What the body does
    #[arg(long, value_name = "KIND", value_enum, default_value_t)]
    pub body: BodyKind,

    /// Relative scatter of measured forces: the body shows where it adds more than that
    #[arg(long, value_name = "FRACTION", default_value_t = Request::default().scatter, value_parser = finite, allow_negative_numbers = true)]
    #[schemars(range(min = 0.0, max = 10.0))]
    pub scatter: f64,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,

    /// Saves the fields that prove the bounds, for `soilctl certify`: without the body as NAME.without.json, by distance as NAME.1.json and so on
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,

    /// Writes the problems as problem files likewise (.toml)
    #[arg(long, value_name = "FILE")]
    pub problem: Option<PathBuf>,

    /// Writes the table over the distance (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub table: Option<PathBuf>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            setting: Setting::default(),
            ahead_m: Vec::new(),
            body_top_m: 0.0,
            body_height_m: 0.0,
            body_length_m: None,
            body: BodyKind::Fixed,
            scatter: 0.1,
            budget: Budget { max_gap: 0.03, ..Budget::default() },
            save: None,
            problem: None,
            table: None,
        }
    }
}
