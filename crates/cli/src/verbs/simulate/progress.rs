use indicatif::ProgressBar;
use soilctl_campaign::{Notice, Plan};

use crate::output::Output;

/// Strokes made so far on stderr: a bar on a terminal, else a line a batch.
pub(super) struct Progress<'a> {
    bar: ProgressBar,
    output: &'a Output,
    batches: usize,
}

impl<'a> Progress<'a> {
    pub(super) fn new(output: &'a Output, plan: &Plan) -> Self {
        let strokes = u64::try_from(plan.strokes().strokes().len()).unwrap_or(u64::MAX);
        Self { bar: output.progress_of(strokes, "strokes"), output, batches: plan.batches() }
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
                if self.bar.is_hidden() {
                    self.output.note(&line);
                } else {
                    self.bar.println(line);
                }
            }
            _ => {}
        }
    }

    pub(super) fn end(&self) {
        self.bar.finish_and_clear();
    }
}
