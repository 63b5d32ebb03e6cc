use soilctl_campaign::{Notice, Plan};

use crate::output::Output;
use crate::progress::Bar;

/// Strokes made so far on stderr: a bar on a terminal, else a line a batch.
pub(super) struct Progress<'a> {
    bar: Bar,
    output: &'a Output,
    batches: usize,
}

impl<'a> Progress<'a> {
    pub(super) fn new(output: &'a Output, plan: &Plan) -> Self {
        let strokes = u64::try_from(plan.strokes().strokes().len()).unwrap_or(u64::MAX);
        Self { bar: output.bar(strokes, "strokes"), output, batches: plan.batches() }
    }

    pub(super) fn show(&self, notice: &Notice<'_>) {
        match notice {
            Notice::Stroke { .. } => self.bar.inc(1),
            Notice::Finished { batch, report } => {
                let line = format!(
                    "batch {} of {}: {} of {} strokes, {}",
                    batch + 1,
                    self.batches,
                    report.strokes_done,
                    report.strokes,
                    report.log
                );
                self.bar.suspend(|| self.output.note(&line));
            }
            _ => {}
        }
    }

    pub(super) fn end(&self) {
        self.bar.finish();
    }
}
