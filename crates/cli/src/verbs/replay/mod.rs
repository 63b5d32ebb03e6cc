//! `soilctl replay LOG`: runs the controller again on the logged inputs and compares every bit.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use super::Outcome;
use crate::error::CliError;
use crate::output::{Answer, Output};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The controller's inputs and settings come from the log. Exit code 1: an output or a key frame has other \
    bits. Exit code 3: all that could be run again is identical, but the log is damaged or steps are missing."
)]
pub(crate) struct Args {
    /// A log (.mcap)
    log: PathBuf,

    /// Begin at the key frame of this number; 0 is the beginning, there is one every 500 steps
    #[arg(long, value_name = "N", default_value_t = 0)]
    from_keyframe: u32,
}

/// What a replay found.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ReplayAnswer {
    /// Whether every bit of every output and of every key frame is the same.
    identical: bool,
    /// Steps that were run again and compared.
    steps: u64,
    /// Steps with an output of other bits.
    different_steps: u64,
    /// Steps of the log that could not be run again, because steps before them are missing.
    skipped_steps: u64,
    /// Key frames that were compared with the state of the replay.
    keyframes: u64,
    /// The first output that differs; null if none does.
    first_difference: Option<FirstDifference>,
    /// What is wrong with the file; empty if it is whole.
    damage: Vec<String>,
}

/// An output that is not what the log says.
#[derive(Debug, Serialize, JsonSchema)]
struct FirstDifference {
    /// Number of the step, from 0.
    step: u64,
    /// The tick that it answered.
    tick: u64,
    /// Field of the message on /controller/step, or `state` for a key frame.
    field: String,
    /// What the log says, as text, since it may be NaN.
    logged: String,
    /// What the replay gave.
    replayed: String,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let spinner = output.spinner("replaying");
    let stop = output.interrupt_keeping(false);
    let found = soilctl_session::replay_until(&args.log, args.from_keyframe, &stop)?;
    spinner.finish_and_clear();
    let answer = ReplayAnswer {
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
    };
    output.answer(&answer)?;
    Ok(if !answer.identical {
        Outcome::Negative
    } else if answer.damage.is_empty() && answer.skipped_steps == 0 {
        Outcome::Done
    } else {
        Outcome::Partial
    })
}

impl Answer for ReplayAnswer {
    const SCHEMA: &'static str = "soilctl.replay/1";

    fn text(&self) -> String {
        let mut text = match &self.first_difference {
            None => {
                format!("identical: {} steps and {} key frames, bit for bit\n", self.steps, self.keyframes)
            }
            Some(first) => format!(
                "different: {} of {} steps, first step {} (tick {}): {} is {} in the log and {} now\n",
                self.different_steps,
                self.steps,
                first.step,
                first.tick,
                first.field,
                first.logged,
                first.replayed
            ),
        };
        if self.skipped_steps > 0 {
            text +=
                &format!("skipped: {} steps, because steps before them are missing\n", self.skipped_steps);
        }
        for damage in &self.damage {
            text += &format!("damaged: {damage}\n");
        }
        text
    }
}
