//! What was done for each log: `manifest.jsonl` beside the stroke table, a header and one line a log. While logs are
//! read a line is added for each that is done, so that a run that is broken off goes on from there; in the end it is put in
//! order. Traces wait in files of their own until all are there.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_jobs::{JobsError, Journal, Shard, fnv1a};
use soilctl_process::foreign::{Contact, FreeAir};
use soilctl_process::table::StrokeRecord;

use super::inputs::{Inputs, Log};
use super::scans::Scan;
use crate::AppError;
use crate::files::failed;

const SCHEMA: &str = "soilctl.process-manifest/1";

/// What must be the same for results of an earlier run to count.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Header {
    schema: String,
    program_version: String,
    /// Options that change what is found, in words.
    settings: String,
}

impl Header {
    fn of(inputs: &Inputs) -> Self {
        Self {
            schema: SCHEMA.into(),
            program_version: env!("CARGO_PKG_VERSION").into(),
            settings: format!(
                "{:?}, clouds on {:?}, traces at {} Hz",
                inputs.settings, inputs.scan_topic, inputs.trace_rate_hz
            ),
        }
    }
}

/// A part of a log that gave no failure force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Skipped {
    /// Name of the stroke; null if it is none.
    pub stroke_id: Option<String>,
    /// Begin on the log's clock in s.
    pub from_s: f64,
    /// End in s.
    pub to_s: f64,
    /// `no_stroke`, `refused` if it cannot be weighed, or what is indiscernible about the failure: `no_force`, `no_travel`, `no_break`, `incomplete`,
    /// `uncertain`.
    pub outcome: String,
    /// Why, in words.
    pub reason: String,
}

/// What was found in a log of another program, beside its strokes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Found {
    /// Where the clock of all times begins, in s of the stamps.
    pub clock_origin_s: i64,
    /// What free air told of the sensor; null if there was none.
    pub free_air: Option<FreeAir>,
    /// All contacts of the plate.
    pub contacts: Vec<Contact>,
}

/// What became of a log.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Entry {
    /// The file, as it was named.
    pub(super) log: String,
    /// What its strokes are named after.
    pub(super) name: String,
    /// Size and time of change, by which a change is noticed.
    bytes: u64,
    modified_ns: u64,
    /// Whether soilctl wrote the log.
    pub(super) own: bool,
    /// Why nothing could be made of it.
    pub(super) error: Option<String>,
    /// Strokes with a failure force.
    pub(super) strokes: Vec<StrokeRecord>,
    /// What gave none, and why.
    pub(super) skipped: Vec<Skipped>,
    /// Damaged parts, which were left out.
    pub(super) damage: Vec<String>,
    /// Messages that could not be used, in words.
    pub(super) unusable: Vec<String>,
    /// What else was found in a log of another program.
    #[serde(default)]
    pub(super) found: Option<Found>,
    /// What scans before and after its strokes say; none without clouds.
    #[serde(default)]
    pub(super) scans: Vec<Scan>,
    /// Whether strokes could not be weighed, or have gaps where the force rises.
    #[serde(default)]
    pub(super) is_partial: bool,
    /// Where its traces are in `traces.csv`: first byte and the one after the last.
    pub(super) trace_bytes: Option<[u64; 2]>,
}

impl Entry {
    pub(super) fn of(log: &Log) -> Self {
        let (bytes, modified_ns) = stamp(&log.path);
        let path = log.path.display().to_string();
        Self { log: path, name: log.name.clone(), bytes, modified_ns, ..Self::default() }
    }

    /// Whether the log is still what it was.
    fn holds(&self, log: &Log) -> bool {
        let now = Self::of(log);
        (&now.log, &now.name, now.bytes, now.modified_ns)
            == (&self.log, &self.name, self.bytes, self.modified_ns)
    }
}

fn stamp(path: &Path) -> (u64, u64) {
    let Ok(known) = std::fs::metadata(path) else { return (0, 0) };
    let since = known.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
    (known.len(), since.map_or(0, |since| u64::try_from(since.as_nanos()).unwrap_or(u64::MAX)))
}

/// The manifest of an output folder, open for adding.
pub(super) struct Manifest {
    pub(super) folder: PathBuf,
    journal: Journal,
    /// Logs that are done already, by the place of the log.
    pub(super) known: BTreeMap<usize, Entry>,
}

/// Name of the manifest of a shard, whose logs another run will take over.
fn of_shard(shard: Shard) -> String {
    format!("manifest.shard_{}.jsonl", shard.named())
}

/// Manifests of shards in a folder, by name.
pub(super) fn shards(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with("manifest.shard_") && name.ends_with(".jsonl") {
            found.push(entry.path());
        }
    }
    found.sort();
    Ok(found)
}

pub(super) fn parts(folder: &Path) -> PathBuf {
    folder.join("traces.parts")
}

/// Where the traces of a log wait.
pub(super) fn part(folder: &Path, log: &Log) -> PathBuf {
    // Names of logs may hold any character, and be long.
    parts(folder).join(format!("{}.csv", fnv1a(log.path.display().to_string().as_bytes())))
}

impl Manifest {
    /// Opens or begins the manifest beside `out`.
    pub(super) fn open(inputs: &Inputs, out: &Path) -> Result<Self, AppError> {
        let folder = out.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let waiting = parts(folder);
        std::fs::create_dir_all(&waiting).map_err(failed(&waiting))?;
        let header = Header::of(inputs);
        let whole = folder.join("manifest.jsonl");
        let path = inputs.shard.map_or_else(|| whole.clone(), |shard| folder.join(of_shard(shard)));
        let mut earlier = vec![whole];
        match inputs.shard {
            // Others write theirs at the same time.
            Some(_) => earlier.push(path.clone()),
            None => earlier.extend(shards(folder).map_err(failed(folder))?),
        }
        let mut by_log: BTreeMap<String, Entry> = BTreeMap::new();
        for path in &earlier {
            let found = match Journal::read::<Header, Entry>(path) {
                Ok(Some((found, entries))) if found == header => entries,
                // With other options, or by another version: all logs are read again.
                Ok(_) | Err(JobsError::NoJournal { .. }) => Vec::new(),
                Err(problem) => return Err(problem.into()),
            };
            by_log.extend(found.into_iter().map(|entry| (entry.log.clone(), entry)));
        }
        let traces = folder.join("traces.csv");
        let mut known = BTreeMap::new();
        for place in inputs.own() {
            let log = &inputs.logs[place];
            let entry = by_log.remove(&log.path.display().to_string());
            let usable = |entry: &Entry| {
                let traced = match entry.trace_bytes {
                    Some([_, to]) => std::fs::metadata(&traces).is_ok_and(|file| file.len() >= to),
                    None => part(folder, log).exists(),
                };
                entry.error.is_none() && entry.holds(log) && traced
            };
            if let Some(entry) = entry.filter(usable) {
                known.insert(place, entry);
            }
        }
        let journal = Journal::begin(&path, &header, known.values())?;
        Ok(Self { folder: folder.to_owned(), journal, known })
    }

    /// Adds a log that is done.
    pub(super) fn add(&mut self, entry: &Entry) -> Result<(), AppError> {
        Ok(self.journal.add(entry)?)
    }
}

/// Writes the manifest of a run that is done, its logs in order.
pub(super) fn finish(
    inputs: &Inputs,
    folder: &Path,
    entries: &BTreeMap<usize, Entry>,
) -> Result<(), AppError> {
    Ok(Journal::write(&folder.join("manifest.jsonl"), &Header::of(inputs), entries.values())?)
}

/// What is wrong with a log, with its name once.
pub(super) fn bad_log(log: &str, problem: &str) -> String {
    if problem.starts_with(log) { problem.to_owned() } else { format!("{log}: {problem}") }
}
