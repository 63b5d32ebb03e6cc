//! The messages of a topic of a log as a table.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::{Form, export_until, topics};

pub use super::Answer;
use super::{differ, watched};
use crate::{AppError, Watch};

/// Writes the messages of a topic as a table, one row a message
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A log (.mcap)
    pub log: PathBuf,

    /// File to write (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,

    /// The topic: /controller/step, /joint_states, /motor_states, /wrench, /truth/joint_states or /truth/soil
    #[arg(long, value_name = "TOPIC", default_value_t = Request::default().topic)]
    pub topic: String,
}

impl Default for Request {
    fn default() -> Self {
        Self { log: PathBuf::new(), out: PathBuf::new(), topic: topics::STEP.to_owned() }
    }
}

/// Writes the messages of a topic as a table.
///
/// # Errors
/// [`AppError::Session`] if the log cannot be read, has no such topic, or the table cannot be written, [`AppError::Request`] if
/// the name of the table makes no sense.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    let Request { log, out, topic } = request;
    watched(watch, |stop| {
        differ(log, out)?;
        Ok(Answer::export(export_until(log, topic, out, form(out)?, stop)?, topic, out))
    })
}

fn form(out: &Path) -> Result<Form, AppError> {
    let refused = || format!("--out is {}; the name must end in .csv or .parquet", out.display());
    Form::of(out).ok_or_else(|| AppError::Request(refused()))
}
