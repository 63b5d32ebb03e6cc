//! The messages of a topic of a log as a table.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_jobs::Beside;
use soilctl_motion::write_table;
use soilctl_session::{Form, export_until, is_own, topics};

pub use super::Answer;
use super::answer::Written;
use super::{differ, watched};
use crate::files::failed;
use crate::{AppError, Watch};

/// Writes the messages of a topic as a table, one row a message
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag)
    pub log: PathBuf,

    /// File to write (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,

    /// The topic: /controller/step, /joint_states, /motor_states, /wrench, /truth/joint_states or /truth/soil; of another program's
    /// recording any topic
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
/// [`AppError::Session`] or [`AppError::Motion`] if the log cannot be read, has no such topic, or the table cannot be written, [`AppError::Request`] if
/// the name of the table makes no sense.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    let Request { log, out, topic } = request;
    watched(watch, |stop| {
        differ(log, out)?;
        let form = form(out)?;
        let written = |rows, columns, clock_origin_s| Written {
            file: out.display().to_string(),
            topic: Some(topic.clone()),
            rows,
            columns: Some(columns),
            clock_origin_s,
        };
        if is_own(log, stop) {
            let table = export_until(log, topic, out, form, stop)?;
            return Ok(Answer::exported(table.ending.damage, written(table.rows, table.columns, None)));
        }
        let beside = Beside::new(out);
        let table = write_table(log, topic, beside.path(), form, stop)?;
        beside.keep().map_err(failed(out))?;
        let written = written(table.rows, table.columns, Some(table.clock.origin_s));
        Ok(Answer::exported(table.ending.damage, written))
    })
}

fn form(out: &Path) -> Result<Form, AppError> {
    let refused = || format!("--out is {}; the name must end in .csv or .parquet", out.display());
    Form::of(out).ok_or_else(|| AppError::Request(refused()))
}
