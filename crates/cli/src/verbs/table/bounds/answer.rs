//! What `table build --model bounds` answers.

use std::collections::BTreeMap;
use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::BracketTable;

use super::cases::Node;
use super::cost::{Cost, duration};
use crate::text::number;
use crate::verbs::table::answer::Head;
use crate::verbs::table::brackets::Gaps;

/// How far a table of bounds was built.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BuiltBounds {
    /// What is in the table.
    table: Head,
    /// Its gaps; null while there is no case.
    gaps: Option<Gaps>,
    /// Whether every case is done and the file, if one was asked for, is written.
    pub(in crate::verbs::table) finished: bool,
    /// The table if it is finished, otherwise, or if no table was asked for, the journal or store from which the next run goes on.
    file: String,
    /// Cases of the grid, or of the shard.
    cases: usize,
    /// Cases without an answer.
    empty: Vec<EmptyNode>,
}

/// A case without an answer.
#[derive(Debug, Serialize, JsonSchema)]
struct EmptyNode {
    /// Alpha, phi and delta in degrees.
    node: Node,
    /// Why there is none.
    reason: String,
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

    pub(in crate::verbs::table) fn text(&self) -> String {
        let mut text = self.table.text() + &self.gaps.as_ref().map_or_else(String::new, Gaps::text);
        let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
        for empty in &self.empty {
            *reasons.entry(&empty.reason).or_default() += 1;
        }
        for (reason, count) in reasons {
            text += &format!("empty: {count}, since {reason}\n");
        }
        text + &if self.finished {
            format!("written to {}\n", self.file)
        } else {
            let done = self.table.filled + self.empty.len();
            format!(
                "stopped with {done} cases done, of {} asked for; nothing is lost: {} holds them, and the same command \
                 goes on from there\n",
                self.cases, self.file
            )
        }
    }
}

/// What a build would do.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Plan {
    /// Cases of the grid, or of the shard.
    cases: usize,
    /// Of these, done already.
    done: usize,
    /// Cases solved at a time.
    threads: usize,
    /// Estimated time a case in s.
    seconds_per_case: f64,
    /// Estimated time for all that is left in s.
    seconds: f64,
    /// Number of cases of this table whose measured times the estimate rests on; 0: on times measured elsewhere.
    measured: usize,
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

    pub(in crate::verbs::table) fn text(&self) -> String {
        let basis = match self.measured {
            0 => "times measured on one machine; yours may take half or twice as long".to_owned(),
            n => format!("the {n} cases solved so far"),
        };
        format!(
            "cases: {}, done: {}\nestimate: {} s a case, {} in all with {} at a time\nby {basis}\n",
            self.cases,
            self.done,
            number((10.0 * self.seconds_per_case).round() / 10.0),
            duration(self.seconds),
            self.threads,
        )
    }
}
