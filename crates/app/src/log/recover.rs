//! Saving what can be saved of a log.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::{info_until, recover_until};

pub use super::Answer;
use super::{differ, watched};
use crate::{AppError, Watch};

/// Copies what can be read of a damaged log into a new, whole one
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// The damaged log (.mcap)
    pub log: PathBuf,

    /// File to write (.mcap)
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Copies what can be read of a damaged log.
///
/// # Errors
/// [`AppError::Session`] if nothing can be read or the new file cannot be written, [`AppError::Request`] if it is the log itself.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    let Request { log, out } = request;
    watched(watch, |stop| {
        differ(log, out)?;
        let saved = recover_until(log, out, stop)?;
        Ok(Answer::recover(info_until(out, stop)?, saved, out))
    })
}
