//! How a table of bounds is built.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::BracketRules;
use soilctl_jobs::Shard;

use crate::machine::cores;
use crate::request::finite;

/// Options of the model `bounds`.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct BoundsOptions {
    /// Bounds: gap (U - L) / ((U + L) / 2) at which a case is done [default: 0.01]
    #[arg(long, value_name = "FRACTION", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub max_gap: Option<f64>,

    /// Bounds: most elements that a case is given [default: 12000]
    #[arg(long, value_name = "N")]
    #[schemars(range(min = 600, max = 1_000_000))]
    pub max_elements: Option<u32>,

    /// Bounds: cases solved at a time; the table is the same for any number [default: all cores]
    #[arg(long, value_name = "N")]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: Option<u32>,

    /// Bounds: only each N-th case, starting with the I-th; all shards may fill one --store, or `table merge` unites their files
    #[arg(long, value_name = "I/N")]
    #[schemars(with = "Option<String>")]
    pub shard: Option<Shard>,

    /// Bounds: folder where each solved case is a file of its own, for any number of runs and machines at a time; what is there
    /// is not solved again
    #[arg(long, value_name = "DIR")]
    pub store: Option<PathBuf>,

    /// Bounds: folder for the fields that prove each case, for `soilctl certify`
    #[arg(long, value_name = "DIR")]
    pub save: Option<PathBuf>,

    /// Bounds: only says how many cases there are and how long they will take
    #[arg(long)]
    pub dry_run: bool,
}

impl BoundsOptions {
    /// The first of these options that was given: they are for the model `bounds` only.
    pub(in crate::table) fn given(&self) -> Option<&'static str> {
        [
            (self.max_gap.is_some(), "--max-gap"),
            (self.max_elements.is_some(), "--max-elements"),
            (self.threads.is_some(), "--threads"),
            (self.shard.is_some(), "--shard"),
            (self.store.is_some(), "--store"),
            (self.save.is_some(), "--save"),
            (self.dry_run, "--dry-run"),
        ]
        .into_iter()
        .find_map(|(given, name)| given.then_some(name))
    }

    pub(super) fn rules(&self) -> BracketRules {
        let max_elements = self.max_elements.unwrap_or(12_000) as usize;
        BracketRules { max_gap: self.max_gap.unwrap_or(0.01), max_elements }
    }

    pub(super) fn threads(&self) -> usize {
        self.threads.map_or_else(cores, |threads| threads as usize)
    }
}
