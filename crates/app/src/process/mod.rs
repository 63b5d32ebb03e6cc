//! Logs in, failure forces out.

mod analysis;
mod answer;
mod findings;
mod inputs;
mod manifest;
mod one_log;
mod outputs;
mod request;
mod scans;
mod windows;
mod work;

pub use answer::{Answer, LogOutcome};
pub use findings::{Analysis, Comparison, Effect, Friction, Group, Law, Lift, Rubbing};
pub(crate) use inputs::{Inputs, Log};
pub use manifest::{Found, Skipped};
pub use request::{AnalysisRequest, Bag, Request, WrenchSense};
pub use scans::Scan;
pub use soilctl_process::foreign::{Contact, ContactKind, FreeAir};

use crate::{AppError, Watch};

/// Finds the failure forces of the strokes in logs, writes the stroke table and what belongs to it, and says what the strokes say
/// together.
///
/// # Errors
/// [`AppError`] if the request makes no sense, no log can be used, or a file cannot be written.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let inputs = inputs::Inputs::of(request)?;
    let done = work::process(&inputs, watch)?;
    let campaign = outputs::campaign(&inputs)?;
    let rubbing = analysis::rubbing(&request.analysis.rubbing, &inputs)?;
    let mut strokes = done.strokes();
    // Logs of other programs do not tell how well depths are known.
    for stroke in &mut strokes {
        stroke.row.depth_sd_m.get_or_insert(campaign.depth_sd_m);
    }
    let analysis = analysis::analyse(&request.analysis, &strokes, &campaign, rubbing)?;
    let written = if inputs.shard.is_none() && !done.stopped {
        outputs::write(&inputs, &done, &strokes, &campaign)?
    } else {
        Vec::new()
    };
    let answer = Answer::new(done, strokes, analysis, written, inputs.shard.is_some());
    if let Some(refusal) = answer.refusal() {
        return Err(refusal);
    }
    if answer.stopped {
        let (done, all) = (answer.logs.len(), inputs.own().count());
        watch.note(&format!("stopped after {done} of {all} logs; the same command goes on from here"));
    }
    Ok(answer)
}
