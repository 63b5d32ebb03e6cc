//! What can be asked of a campaign.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where model and measurement disagree, which effect is missing, and the gap after it is added.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Folder with strokes.csv and, beside it, campaign.json and traces.csv
    #[arg(value_name = "DIR")]
    pub dir: PathBuf,

    /// Force model without effects: table (the bracket of bounds), chen, log-spiral, caquot, coulomb, ...
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model)]
    pub model: String,

    /// A model file instead, such as the patch of an earlier diagnosis: its force model, and its effects as known ones
    #[arg(long, value_name = "PATCH", conflicts_with = "model")]
    pub model_file: Option<PathBuf>,

    /// Traces of the strokes [default: DIR/traces.csv, if it is there]
    #[arg(long, value_name = "FILE")]
    pub traces: Option<PathBuf>,

    /// Folder of the campaign's logs, if they are soilctl's: the same commands are run on the simulated arm, without and with what is found,
    /// and signals are compared [default: DIR, if logs of its strokes are there]
    #[arg(long, value_name = "FOLDER", conflicts_with = "no_resimulate")]
    pub logs: Option<PathBuf>,

    /// Diagnose the table alone: nothing is simulated, also where logs are there
    #[arg(long)]
    pub no_resimulate: bool,

    /// Folder to write to [default: DIR/diagnosis]
    #[arg(long, value_name = "DIR2")]
    pub out: Option<PathBuf>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            dir: PathBuf::new(),
            model: "table".into(),
            model_file: None,
            traces: None,
            logs: None,
            no_resimulate: false,
            out: None,
        }
    }
}
