//! One batch: a fresh preparation, its strokes, its log.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_controller::{Commands, EventKind};
use soilctl_jobs::Beside;
use soilctl_plant::Simulation;
use soilctl_session::messages::SoilTruth;
use soilctl_session::{Logger, Pace, Recorder, SessionSetup, Truth};

use super::script::Script;
use super::{Job, Notice};
use crate::CampaignError;
use crate::journal::BatchReport;

/// Runs a batch and logs it; `None` if it was stopped before its end, and nothing is left of it then.
pub(super) fn run(
    job: &Job<'_>,
    batch: usize,
    stop: &AtomicBool,
    notice: &(dyn Fn(Notice<'_>) + Sync),
) -> Result<Option<BatchReport>, CampaignError> {
    let log = log_name(batch);
    let path = job.out.join(&log);
    let part = Beside::new(&path);
    notice(Notice::Began { batch });
    let (mut simulation, setup, stroke_number) = job.prepare(batch)?;
    let (logger, mut recorder) = Logger::create(part.path(), &setup, Pace::Simulated)?;
    let strokes = job.plan.strokes_of(batch);
    let mut script = Script::new(strokes.start, strokes.end, job.plan.file().homing);
    let mut goes_on = true;
    while goes_on && !script.is_done() {
        if stop.load(Ordering::Relaxed) {
            drop(recorder);
            // What it says of the log does not matter any more.
            let _ = logger.finish();
            return Ok(None);
        }
        stroke_number.store(script.stroke(), Ordering::Relaxed);
        goes_on = tick(&mut simulation, &mut script, &mut recorder, &mut |stroke| {
            notice(Notice::Stroke { batch, stroke });
        })?;
    }
    drop(recorder);
    let steps = logger.finish()?.steps;
    part.keep().map_err(|error| CampaignError::file(&path, &error))?;
    let report = BatchReport {
        batch,
        log,
        strokes: strokes.len(),
        strokes_done: script.done,
        steps,
        failures: script.failures,
    };
    notice(Notice::Finished { batch, report: &report });
    Ok(Some(report))
}

/// Name of a batch's log.
fn log_name(batch: usize) -> String {
    format!("batch_{batch:03}.mcap")
}

/// One tick, logged; says whether the log goes on.
fn tick(
    simulation: &mut Simulation,
    script: &mut Script,
    recorder: &mut Recorder,
    ended: &mut dyn FnMut(usize),
) -> Result<bool, CampaignError> {
    let heartbeat = simulation.state().tick.wrapping_add(1);
    #[allow(clippy::cast_possible_truncation, reason = "a heartbeat wraps")]
    let commands = Commands { heartbeat: heartbeat as u32, emergency_stop: false, request: script.request() };
    let mut goes_on = recorder.before(simulation.state());
    simulation.tick_with(&commands, |_| {}, &mut |tick| {
        let truth = logged_truth(tick.truth);
        goes_on &= recorder.after(tick.sensed, tick.commands, tick.outputs, tick.state, Some(truth));
        for event in tick.outputs.events.as_slice() {
            if event.kind == EventKind::StrokeEnded {
                ended(usize::from(event.index));
            }
        }
    })?;
    script.note(simulation.outputs(), simulation.state());
    Ok(goes_on)
}

/// What the topics of truth of a simulation's log hold.
#[must_use]
pub fn logged_truth(truth: &soilctl_plant::Truth) -> Truth {
    Truth {
        joints: truth.joints,
        joint_rates: truth.joint_rates,
        soil: SoilTruth {
            depth_m: truth.soil.depth_m,
            limit_force_n: truth.soil.limit_force_n,
            force_rtz_n: truth.force_rtz_n(),
            limit_force_now_n: truth.soil.limit_force_now_n,
            mobilisation: truth.soil.mobilisation,
            failing: truth.soil.failing,
        },
    }
}

/// The log's record of where it stands in the campaign.
pub(super) fn notes(setup: &mut SessionSetup, batch: usize, density_kg_m3: f64) {
    setup.notes.insert("batch".to_owned(), batch.to_string());
    setup.notes.insert("density_kg_m3".to_owned(), density_kg_m3.to_string());
}

/// Removes the logs that a kill left half-done.
pub(super) fn remove_parts(out: &Path, batches: usize) {
    for batch in 0..batches {
        // What is not kept goes away.
        drop(Beside::new(&out.join(log_name(batch))));
    }
}
