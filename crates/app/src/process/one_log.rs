//! One log: its strokes, and their traces into a file of its own.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_process::ProcessError;
use soilctl_process::log::{Candidate, NoStroke, read_log};
use soilctl_process::table::{StrokeRecord, write_trace};

use super::inputs::{Inputs, Log};
use super::manifest::{Entry, Found, Skipped};
use super::scans::{self, Pushed};
use crate::AppError;
use crate::files::failed;

/// Processes a log; `None` if it was stopped. `traces` is where its traces go.
pub(super) fn process(
    inputs: &Inputs,
    log: &Log,
    traces: Option<&Path>,
    stop: &AtomicBool,
) -> Result<Option<Entry>, AppError> {
    let mut entry = Entry::of(log);
    let mut trace_file = match traces {
        Some(path) => Some(BufWriter::new(File::create(path).map_err(failed(path))?)),
        None => None,
    };
    let mut broken = Ok(());
    let (mut number, mut windows_s) = (0, Vec::new());
    let summary = read_log(&log.path, &inputs.settings, stop, &mut |found| match found {
        Candidate::Rejected(nothing) => entry.skipped.push(skipped(nothing)),
        Candidate::Stroke(stroke) => {
            number += 1;
            let stroke_id = format!("{}-{number}", log.name);
            match StrokeRecord::new(&stroke, stroke_id.clone(), log.path.display().to_string()) {
                Ok(record) => {
                    entry.strokes.push(record);
                    windows_s.push([stroke.start_s, stroke.end_s]);
                }
                Err(reason) => entry.skipped.push(Skipped {
                    stroke_id: Some(stroke_id.clone()),
                    from_s: stroke.start_s,
                    to_s: stroke.end_s,
                    outcome: reason.name().to_owned(),
                    reason: reason.to_string(),
                }),
            }
            if let Some(file) = &mut trace_file
                && broken.is_ok()
            {
                broken = write_trace(&stroke, &stroke_id, inputs.trace_rate_hz, file);
            }
        }
    });
    if let Some(mut file) = trace_file {
        broken = broken.and_then(|()| file.flush());
        broken.map_err(failed(traces.unwrap_or(Path::new(""))))?;
    }
    match summary {
        Ok(summary) => {
            entry.own = summary.own;
            if !summary.own {
                // Nobody raked the soil anew while it ran.
                entry.strokes.iter_mut().for_each(|stroke| stroke.row.batch = Some(log.name.clone()));
            }
            entry.damage = summary.damage;
            entry.unusable = summary.unusable;
            if let Some(foreign) = summary.foreign {
                entry.is_partial = foreign.is_partial;
                entry.found = Some(Found {
                    clock_origin_s: foreign.origin_s,
                    free_air: foreign.air,
                    contacts: foreign.contacts,
                });
                // Without them nothing is read once more, unless a topic is asked for.
                if foreign.has_clouds || inputs.scan_topic.is_some() {
                    look_at_scans(&mut entry, &windows_s, log, inputs, stop);
                }
            }
        }
        Err(ProcessError::Stopped) => return Ok(None),
        Err(problem) => {
            entry.strokes.clear();
            entry.skipped.clear();
            entry.error = Some(problem.to_string());
        }
    }
    Ok(Some(entry))
}

/// Clouds in the recording of another program; what cannot be used of them takes nothing from the forces.
fn look_at_scans(entry: &mut Entry, windows_s: &[[f64; 2]], log: &Log, inputs: &Inputs, stop: &AtomicBool) {
    let strokes = entry.strokes.iter_mut().zip(windows_s);
    let mut strokes: Vec<Pushed<'_>> =
        strokes.map(|(record, &window_s)| Pushed { record, window_s }).collect();
    let contacts = entry.found.as_ref().map_or(&[][..], |found| &found.contacts);
    match scans::read(&mut strokes, contacts, log, inputs, stop) {
        Ok(scans) => entry.scans = scans,
        Err(problem) => {
            // Whoever names a topic misses it; clouds that nobody asked for are a word.
            entry.is_partial |= inputs.scan_topic.is_some();
            entry.unusable.push(problem);
        }
    }
}

fn skipped(nothing: NoStroke) -> Skipped {
    let NoStroke { from_s, to_s, reason, refused } = nothing;
    let outcome = if refused { "refused" } else { "no_stroke" };
    Skipped { stroke_id: None, from_s, to_s, outcome: outcome.into(), reason }
}
