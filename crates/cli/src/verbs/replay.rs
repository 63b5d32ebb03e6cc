//! `soilctl replay LOG`: runs the controller again on the logged inputs and compares every bit.

use soilctl_app::replay::{self, Answer, Request};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The controller's inputs and settings come from the log. Exit code 1: an output or a key frame has other \
    bits. Exit code 3: all that could be run again is identical, but the log is damaged or steps are missing."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = replay::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
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
