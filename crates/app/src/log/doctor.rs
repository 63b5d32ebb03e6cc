//! Whether a log is well.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::{info_until, is_own};

pub use super::Answer;
use super::{foreign, watched};
use crate::{AppError, Watch};

/// Checks a log: whole, checksums, types, quality of service, missing steps, key frames; of another program gaps, clocks, units
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag)
    pub log: PathBuf,
}

/// Checks a log.
///
/// # Errors
/// [`AppError::Session`] or [`AppError::Motion`] if the file cannot be read, or is no log.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    let log = &request.log;
    watched(watch, |stop| {
        if is_own(log, stop) {
            Ok(Answer::doctor(info_until(log, stop)?))
        } else {
            foreign::look(log, "doctor", stop)
        }
    })
}
