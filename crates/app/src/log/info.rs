//! What is in a log.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::info_until;

pub use super::Answer;
use super::watched;
use crate::{AppError, Watch};

/// Says what is in a log
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A log (.mcap)
    pub log: PathBuf,
}

/// Says what is in a log.
///
/// # Errors
/// [`AppError::Session`] if the file cannot be read, or is no log.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    watched(watch, |stop| Ok(Answer::info(info_until(&request.log, stop)?)))
}
