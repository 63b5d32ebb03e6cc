//! All logs, several at a time. What is found does not depend on how many.

use std::collections::BTreeMap;

use soilctl_jobs::each;
use soilctl_process::table::{StrokeRecord, put_on_one_clock};

use super::inputs::Inputs;
use super::manifest::{self, Entry, Manifest, bad_log};
use super::one_log;
use crate::{AppError, Interrupted, Watch};

/// What became of the logs.
#[derive(Debug)]
pub(super) struct Done {
    /// By the place of the log.
    pub(super) entries: BTreeMap<usize, Entry>,
    /// Logs taken over from an earlier run.
    pub(super) reused: usize,
    /// Whether the user stopped the work.
    pub(super) stopped: bool,
}

impl Done {
    pub(super) fn strokes(&self) -> Vec<StrokeRecord> {
        let mut strokes: Vec<_> =
            self.entries.values().flat_map(|entry| entry.strokes.iter().cloned()).collect();
        put_on_one_clock(&mut strokes);
        strokes
    }
}

pub(super) fn process(inputs: &Inputs, watch: &dyn Watch) -> Result<Done, AppError> {
    let mut manifest = match &inputs.out {
        Some((path, _)) => Some(Manifest::open(inputs, path)?),
        None => None,
    };
    let mut entries = manifest.as_mut().map(|m| std::mem::take(&mut m.known)).unwrap_or_default();
    let reused = entries.len();
    let own: Vec<usize> = inputs.own().collect();
    let left: Vec<usize> = own.iter().copied().filter(|place| !entries.contains_key(place)).collect();
    if reused > 0 {
        watch.note(&format!("{reused} logs are as they were and are not read again"));
    }
    let stop = watch.stop(match manifest {
        Some(_) => Interrupted::KeepsResults,
        None => Interrupted::LeavesNothing,
    });
    watch.begin(own.len() as u64, "logs");
    watch.advance(reused as u64);
    let folder = manifest.as_ref().map(|manifest| manifest.folder.clone());
    let read = |place: &usize| {
        let log = &inputs.logs[*place];
        let traces = folder.as_ref().map(|folder| manifest::part(folder, log));
        one_log::process(inputs, log, traces.as_deref(), &stop)
    };
    let result = each(&left, inputs.threads, &stop, read, |place, entry| {
        if let Some(manifest) = &mut manifest {
            manifest.add(&entry)?;
        }
        watch.advance(1);
        // Of a single log it is the error in the end.
        if let Some(problem) = entry.error.as_ref().filter(|_| own.len() > 1) {
            watch.note(&format!("{}; left out", bad_log(&entry.log, problem)));
        }
        entries.insert(*place, entry);
        Ok(())
    });
    watch.end();
    result?;
    Ok(Done { stopped: entries.len() < own.len(), entries, reused })
}
