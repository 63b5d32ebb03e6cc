use schemars::JsonSchema;
use serde::Serialize;
use soilctl_campaign::{BatchReport, Options, Plan, Report};

use crate::output::Answer;

/// What a simulated campaign came to.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SimulateAnswer {
    /// The folder with the logs.
    out: String,
    /// Seed of noise and scatter.
    seed: u64,
    /// Whether all batches of the plan are finished.
    pub(crate) complete: bool,
    /// Strokes of the plan.
    strokes: usize,
    /// Strokes that were made to their end.
    strokes_done: usize,
    /// Batches that were finished by an earlier run.
    resumed_batches: usize,
    /// Finished batches in order.
    pub(crate) batches: Vec<BatchReport>,
}

impl SimulateAnswer {
    pub(super) fn new(plan: &Plan, options: &Options<'_>, report: Report) -> Self {
        Self {
            out: options.out.display().to_string(),
            seed: options.seed,
            complete: report.complete,
            strokes: plan.strokes().strokes().len(),
            strokes_done: report.batches.iter().map(|batch| batch.strokes_done).sum(),
            resumed_batches: report.resumed,
            batches: report.batches,
        }
    }

    /// Whether all strokes were made.
    pub(super) fn is_whole(&self) -> bool {
        self.complete && self.strokes_done == self.strokes
    }
}

impl Answer for SimulateAnswer {
    const SCHEMA: &'static str = "soilctl.simulate/1";

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
