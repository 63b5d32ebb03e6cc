//! What building a table of bounds answers.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::BracketTable;

use super::cases::Node;
use super::cost::Cost;
use crate::table::{Gaps, Head};

/// How far a table of bounds was built.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BuiltBounds {
    /// What is in the table.
    pub table: Head,
    /// Its gaps; null while there is no case.
    pub gaps: Option<Gaps>,
    /// Whether every case is done and the file, if one was asked for, is written.
    pub finished: bool,
    /// The table if it is finished, otherwise, or if no table was asked for, the journal or store from which the next run goes on.
    pub file: String,
    /// Cases of the grid, or of the shard.
    pub cases: usize,
    /// Cases without an answer.
    pub empty: Vec<EmptyNode>,
}

/// A case without an answer.
#[derive(Debug, Serialize, JsonSchema)]
pub struct EmptyNode {
    /// Alpha, phi and delta in degrees.
    pub node: Node,
    /// Why there is none.
    pub reason: String,
}

impl BuiltBounds {
    pub(super) fn new(
        table: &BracketTable,
        empty: Vec<(Node, String)>,
        cases: usize,
        finished: bool,
        file: &Path,
    ) -> Self {
        Self {
            table: Head::of_brackets(table),
            gaps: Gaps::of(table),
            finished,
            file: file.display().to_string(),
            cases,
            empty: empty.into_iter().map(|(node, reason)| EmptyNode { node, reason }).collect(),
        }
    }
}

/// What a build would do.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Plan {
    /// Cases of the grid, or of the shard.
    pub cases: usize,
    /// Of these, done already.
    pub done: usize,
    /// Cases solved at a time.
    pub threads: usize,
    /// Estimated time a case in s.
    pub seconds_per_case: f64,
    /// Estimated time for all that is left in s.
    pub seconds: f64,
    /// Number of cases of this table whose measured times the estimate rests on; 0: on times measured elsewhere.
    pub measured: usize,
}

impl Plan {
    pub(super) fn new(cases: usize, todo: &[Node], cost: &Cost, threads: usize) -> Self {
        let work: f64 = todo.iter().map(|node| cost.seconds(*node)).sum();
        Self {
            cases,
            done: cases - todo.len(),
            threads,
            seconds_per_case: work / todo.len().max(1) as f64,
            seconds: work / threads as f64,
            measured: cost.measured,
        }
    }
}
