//! What is in a log, whether it is well, saving what can be saved, and tables.

mod answer;

use std::path::{Path, PathBuf};

pub use answer::{Answer, Content, Topic, Written};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::{Form, export_until, info_until, recover_until, topics};

use crate::{AppError, Interrupted, Watch};

/// What is to be done with a log.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Subcommand)]
#[serde(tag = "action", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Request {
    /// Says what is in a log
    Info {
        /// A log (.mcap)
        log: PathBuf,
    },
    /// Checks a log: whole, checksums, types, quality of service, missing steps, key frames
    Doctor {
        /// A log (.mcap)
        log: PathBuf,
    },
    /// Copies what can be read of a damaged log into a new, whole one
    Recover {
        /// The damaged log (.mcap)
        log: PathBuf,
        /// File to write (.mcap)
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
    /// Writes the messages of a topic as a table, one row a message
    Export {
        /// A log (.mcap)
        log: PathBuf,
        /// File to write (.csv or .parquet)
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        /// The topic: /controller/step, /joint_states, /motor_states, /wrench, /truth/joint_states or /truth/soil
        #[arg(long, value_name = "TOPIC", default_value_t = topic())]
        #[serde(default = "topic")]
        topic: String,
    },
}

/// The topic that is exported if none is named.
fn topic() -> String {
    topics::STEP.to_owned()
}

/// Looks into, checks, repairs or exports a log.
///
/// # Errors
/// [`AppError`] if a file cannot be read or written, or is no log.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    watch.begin(0, "reading the log");
    let answer = work(request, watch);
    watch.end();
    answer
}

fn work(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    let stop = watch.stop(Interrupted::LeavesNothing);
    let info = |log: &Path| info_until(log, &stop);
    Ok(match request {
        Request::Info { log } => Answer::info(info(log)?),
        Request::Doctor { log } => Answer::doctor(info(log)?),
        Request::Recover { log, out } => {
            differ(log, out)?;
            let saved = recover_until(log, out, &stop)?;
            Answer::recover(info(out)?, saved, out)
        }
        Request::Export { log, out, topic } => {
            differ(log, out)?;
            Answer::export(export_until(log, topic, out, form(out)?, &stop)?, topic, out)
        }
    })
}

fn form(out: &Path) -> Result<Form, AppError> {
    let refused = || format!("--out is {}; the name must end in .csv or .parquet", out.display());
    Form::of(out).ok_or_else(|| AppError::Request(refused()))
}

/// A log must not be overwritten by what is made of it.
fn differ(log: &Path, out: &Path) -> Result<(), AppError> {
    let same = match (log.canonicalize(), out.canonicalize()) {
        (Ok(log), Ok(out)) => log == out,
        _ => false,
    };
    if same {
        return Err(AppError::Request(format!(
            "--out is {}, the log itself; give another name",
            out.display()
        )));
    }
    Ok(())
}
