//! When to stop, and what may be spent.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_limit_analysis::{Factorisation, Options};

use crate::request::finite;
use crate::{AppError, Interrupted, Watch};

/// When to stop, and what may be spent.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Budget {
    /// Gap (U - L) / ((U + L) / 2) at which to stop
    #[arg(long, value_name = "FRACTION", default_value_t = Budget::default().max_gap, value_parser = finite,
          allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub max_gap: f64,

    /// Most elements of a mesh
    #[arg(long, value_name = "N", default_value_t = Budget::default().max_elements)]
    #[schemars(range(min = 1000, max = 1_000_000))]
    pub max_elements: u32,

    /// Work that may be spent: elements of each mesh times steps of the solver on it, the same on every machine
    #[arg(long, value_name = "N", default_value_t = Budget::default().max_work)]
    #[schemars(range(min = 1))]
    pub max_work: u64,

    /// Time that may be spent (s); where the run ends then depends on the machine, and the answer says so [default: any]
    #[arg(long, value_name = "S", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub max_seconds: Option<f64>,

    /// Memory that may be used (MB): a mesh whose programs may need more is not made
    #[arg(long = "max-memory", value_name = "MB")]
    #[schemars(range(min = 100))]
    pub max_memory_mb: Option<u32>,

    /// Threads; the bounds are the same for any number
    #[arg(long, value_name = "N", default_value_t = Budget::default().threads)]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: u32,

    /// What factorises the systems of the solver's steps: bounds differ in their last digits; `auto` goes by the size of the
    /// programs
    #[arg(long, value_name = "WHICH", value_enum, default_value_t)]
    pub factorisation: FactorisationChoice,

    /// Solves with strength linearised to so many sides, from inside, instead of cones: for comparison, slower and wider
    #[arg(long, value_name = "N")]
    #[schemars(range(min = 3, max = 1000))]
    pub segments: Option<u32>,

    /// Existing folder for programs on which the solver failed, to reproduce that from
    #[arg(long, value_name = "DIR")]
    pub dump: Option<PathBuf>,
}

/// What factorises the systems of the solver's steps.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum FactorisationChoice {
    /// By the size of each program
    #[default]
    Auto,
    /// Column by column: the same bits on every machine
    Qdldl,
    /// In blocks, for large meshes: the same bits on machines with the same processor
    Faer,
}

impl Default for Budget {
    fn default() -> Self {
        Self {
            max_gap: 0.01,
            max_elements: 20_000,
            max_work: Options::MAX_WORK,
            max_seconds: None,
            max_memory_mb: None,
            threads: 1,
            factorisation: FactorisationChoice::Auto,
            segments: None,
            dump: None,
        }
    }
}

impl Budget {
    /// The same for the solver; whoever watches ends the run with the best bounds so far.
    pub(crate) fn options(&self, watch: &dyn Watch) -> Result<Options, AppError> {
        if let Some(dir) = self.dump.as_ref().filter(|dir| !dir.is_dir()) {
            return Err(AppError::Request(format!(
                "--dump is {}, which is no folder; make it first, or leave the option out",
                dir.display()
            )));
        }
        Ok(Options {
            max_gap: self.max_gap,
            max_elements: self.max_elements as usize,
            max_work: self.max_work,
            max_seconds: self.max_seconds,
            max_memory_bytes: self.max_memory_mb.map_or(u64::MAX, |mb| u64::from(mb) * 1_000_000),
            threads: self.threads as usize,
            factorisation: match self.factorisation {
                FactorisationChoice::Auto => None,
                FactorisationChoice::Qdldl => Some(Factorisation::Qdldl),
                FactorisationChoice::Faer => Some(Factorisation::Faer),
            },
            segments: self.segments.map(|n| n as usize),
            dump: self.dump.clone(),
            stop: watch.stop(Interrupted::KeepsResults),
            ..Options::default()
        })
    }
}
