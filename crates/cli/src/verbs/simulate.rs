//! `soilctl simulate FILE`: a whole campaign on the simulated arm, a log a batch.

use soilctl_app::simulate::{self, Answer, Request};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes into DIR: batch_000.mcap and so on, one log for each preparation of the soil; campaign.json; and \
    simulation.json, which says what is done. The same plan and seed give the same bytes for any number of threads. \
    Ctrl-C keeps the batches that are finished; the same command goes on with the others. Exit code 3: not all strokes were \
    made. Plans for tables 6.2 and 6.3 of the thesis are in data/plans; docs/campaigns.md describes the format."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = simulate::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!(
            "{} of {} strokes in {} logs in {}, seed {}\n",
            self.strokes_done,
            self.strokes,
            self.batches.len(),
            self.out,
            self.seed
        );
        if self.resumed_batches > 0 {
            text += &format!("{} batches were there already\n", self.resumed_batches);
        }
        for batch in &self.batches {
            for failure in &batch.failures {
                text += &format!("batch {}: {failure}\n", batch.batch + 1);
            }
        }
        if !self.complete {
            text += "stopped before the end; the same command goes on\n";
        }
        text
    }
}
