//! What of a campaign is done: `simulation.json` in its folder.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_jobs::{Inputs, JobsError, fnv1a, write_atomically};

use crate::CampaignError;

/// Id of the format.
const SCHEMA: &str = "soilctl.simulation/1";
/// Name of the file.
pub(crate) const NAME: &str = "simulation.json";

/// What a batch came to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BatchReport {
    /// Number of the batch, from 0.
    pub batch: usize,
    /// Name of its log in the folder.
    pub log: String,
    /// Strokes of the plan.
    pub strokes: usize,
    /// Strokes that were made to their end.
    pub strokes_done: usize,
    /// Steps in the log.
    pub steps: u64,
    /// Why strokes failed, in words.
    pub failures: Vec<String>,
}

/// Which campaign a folder holds, and which of its batches are done. No time, path or thread count is in it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Journal {
    schema: String,
    program_version: String,
    seed: u64,
    /// FNV-1a hash of what the plan and the files that it names say.
    plan_hash: String,
    /// The same of the model file; empty without one.
    model_file_hash: String,
    /// Batches that are done, in order.
    pub(crate) finished: Vec<BatchReport>,
}

impl Journal {
    /// An empty journal of a campaign.
    pub(crate) fn new(seed: u64, plan: &str, model_file: &str) -> Self {
        Self {
            schema: SCHEMA.to_owned(),
            program_version: env!("CARGO_PKG_VERSION").to_owned(),
            seed,
            plan_hash: fnv1a(plan.as_bytes()),
            model_file_hash: if model_file.is_empty() { String::new() } else { fnv1a(model_file.as_bytes()) },
            finished: Vec::new(),
        }
    }

    /// Takes over from a folder what is done there of the same campaign.
    pub(crate) fn resume(&mut self, out: &Path) -> Result<(), CampaignError> {
        let path = out.join(NAME);
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(()),
            Err(error) => return Err(CampaignError::file(&path, &error)),
        };
        let found: Self = serde_json::from_str(&text)
            .map_err(|problem| JobsError::NoJournal { path: path.clone(), problem })?;
        found.same_as(self, &path)?;
        self.finished = found.finished.into_iter().filter(|report| out.join(&report.log).is_file()).collect();
        Ok(())
    }

    /// Notes a batch and stores the journal.
    pub(crate) fn add(&mut self, report: BatchReport, out: &Path) -> Result<(), CampaignError> {
        self.finished.push(report);
        self.finished.sort_by_key(|report| report.batch);
        self.store(out)
    }

    /// Stores the journal; it is replaced in one go.
    pub(crate) fn store(&self, out: &Path) -> Result<(), CampaignError> {
        let path = out.join(NAME);
        let text =
            serde_json::to_string_pretty(self).map_err(|error| CampaignError::file(&path, &error))? + "\n";
        write_atomically(&path, text.as_bytes()).map_err(|error| CampaignError::file(&path, &error))
    }
}

impl Inputs for Journal {
    fn inputs(&self) -> Vec<(&'static str, String)> {
        let model_file = if self.model_file_hash.is_empty() { "none" } else { &self.model_file_hash };
        vec![
            ("format", self.schema.clone()),
            ("program version", self.program_version.clone()),
            ("seed", self.seed.to_string()),
            ("plan", self.plan_hash.clone()),
            ("model file", model_file.to_owned()),
        ]
    }
}
