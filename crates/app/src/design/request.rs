//! What a search for a design is asked with.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits::Budget;
use crate::request::finite;

/// The least of something that is enough, by proven bounds: an anchor's strength, a length, a slope, a water level.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// The problem file, .toml or .json
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// A second problem file with the same entries, to go towards: all numbers go from the first to this one at once, as of a steeper slope or a longer
    /// wall, and values are parts of that way
    #[arg(value_name = "OTHER")]
    pub other: Option<PathBuf>,

    /// What changes, instead of a second file: a parameter as in `[[sweep]]`, such as `member.nail.tensile_kn_per_m` or `head.reservoir.head_m`
    #[arg(long, value_name = "NAME")]
    pub parameter: Option<String>,

    /// One end of the values of the parameter
    #[arg(long = "from", value_name = "VALUE", value_parser = finite, allow_negative_numbers = true)]
    pub from_value: Option<f64>,

    /// The other end
    #[arg(long = "to", value_name = "VALUE", value_parser = finite, allow_negative_numbers = true)]
    pub to_value: Option<f64>,

    /// What the bounded quantity must reach in all cases of the file: a factor, a force in kN/m, or an acceleration over gravity
    #[arg(long, value_name = "VALUE", value_parser = finite, allow_negative_numbers = true, default_value_t = Request::default().wanted)]
    pub wanted: f64,

    /// How near to each other a value that is enough and one that is not shall be [default: a hundredth of the way from end to end]
    #[arg(long, value_name = "VALUE", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub within: Option<f64>,

    /// Most values to try
    #[arg(long, value_name = "N", default_value_t = Request::default().most)]
    #[schemars(range(min = 2, max = 100))]
    pub most: u32,

    /// Writes the problem file with the value that is enough (.toml)
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,

    /// Write over a file that is there
    #[arg(long)]
    pub replace: bool,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub budget: Budget,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            file: PathBuf::new(),
            other: None,
            parameter: None,
            from_value: None,
            to_value: None,
            wanted: 1.0,
            within: None,
            most: 12,
            out: None,
            replace: false,
            budget: Budget::default(),
        }
    }
}
