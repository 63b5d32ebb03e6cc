//! Runs the controller again on a log's inputs and compares every output bit.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{AppError, Interrupted, Outcome, Watch};

/// Runs the controller again on a log's inputs and compares every output bit.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A log (.mcap)
    pub log: PathBuf,

    /// Begin at the key frame of this number; 0 is the beginning, there is one every 500 steps
    #[arg(long, value_name = "N", default_value_t = Request::default().from_keyframe)]
    pub from_keyframe: u32,
}

/// What a replay found.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Whether every bit of every output and of every key frame is the same.
    pub identical: bool,
    /// Steps that were run again and compared.
    pub steps: u64,
    /// Steps with an output of other bits.
    pub different_steps: u64,
    /// Steps of the log that could not be run again, because steps before them are missing.
    pub skipped_steps: u64,
    /// Key frames that were compared with the state of the replay.
    pub keyframes: u64,
    /// The first output that differs; null if none does.
    pub first_difference: Option<FirstDifference>,
    /// What is wrong with the file; empty if it is whole.
    pub damage: Vec<String>,
}

/// An output that is not what the log says.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FirstDifference {
    /// Number of the step, from 0.
    pub step: u64,
    /// The tick that it answered.
    pub tick: u64,
    /// Field of the message on /controller/step, or `state` for a key frame.
    pub field: String,
    /// What the log says, as text, since it may be NaN.
    pub logged: String,
    /// What the replay gave.
    pub replayed: String,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.replay/1";

    fn outcome(&self) -> Outcome {
        if !self.identical {
            Outcome::Negative
        } else if self.damage.is_empty() && self.skipped_steps == 0 {
            Outcome::Done
        } else {
            Outcome::Partial
        }
    }
}

/// Replays a log.
///
/// # Errors
/// [`AppError::Session`] if the file cannot be read or holds nothing to replay.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    watch.begin(0, "replaying");
    let stop = watch.stop(Interrupted::LeavesNothing);
    let found = soilctl_session::replay_until(&request.log, request.from_keyframe, &stop);
    watch.end();
    let found = found?;
    Ok(Answer {
        identical: found.is_identical(),
        steps: found.steps,
        different_steps: found.different_steps,
        skipped_steps: found.skipped_steps,
        keyframes: found.keyframes,
        first_difference: found.first_difference.map(|first| FirstDifference {
            step: first.step,
            tick: first.tick,
            field: first.field,
            logged: first.logged.to_string(),
            replayed: first.replayed.to_string(),
        }),
        damage: found.ending.damage,
    })
}
