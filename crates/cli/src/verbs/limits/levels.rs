//! Levels of meshes in answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_figure::{Align, Table};
use soilctl_limit_analysis::{IDENTITY, Level, Solve, Status};

use crate::error::CliError;
use crate::output::Output;
use crate::text::{columns, number, number_or_dash};

/// One level of meshes.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct LevelAnswer {
    /// The upper bound on this level's mesh.
    upper: SolveAnswer,
    /// The lower bound on this level's mesh or one before; null if none was solved.
    lower: Option<SolveAnswer>,
    /// Gap of the two programs less the sum of its shares over all elements, relative to the upper bound; null without both
    /// bounds.
    identity_error: Option<f64>,
}

/// One solve.
#[derive(Debug, Serialize, JsonSchema)]
struct SolveAnswer {
    /// Triangles.
    elements: usize,
    /// How the solver ended; proves nothing.
    status: &'static str,
    /// Steps of the solver.
    iterations: u32,
    /// Time in the solver in s.
    seconds: f64,
    /// Time for repair and proof in s.
    proof_seconds: f64,
    /// What was proven, in the units of the answer; null if nothing was.
    proven: Option<f64>,
}

impl LevelAnswer {
    /// A level whose bounds are multiplied by `unit`.
    pub(crate) fn new(level: &Level, unit: f64) -> Self {
        let solve = |s: &Solve| SolveAnswer {
            elements: s.elements,
            status: status(s.status),
            iterations: s.iterations,
            seconds: s.seconds,
            proof_seconds: s.proof_seconds,
            proven: s.proven.map(|p| p * unit),
        };
        Self {
            upper: solve(&level.upper),
            lower: level.lower.as_ref().map(solve),
            identity_error: level.identity.map(|_| level.identity_residual()),
        }
    }
}

fn status(status: Status) -> &'static str {
    match status {
        Status::Solved => "solved",
        Status::Almost => "almost_solved",
        Status::Infeasible => "infeasible",
        Status::Unbounded => "unbounded",
        Status::Stopped => "stopped",
        Status::Failed => "failed",
    }
}

/// Says on stderr where the parts of a gap do not add up to it.
pub(crate) fn note_doubts(levels: &[Level], output: &Output) {
    for (index, level) in levels.iter().enumerate().filter(|(_, level)| !level.identity_holds()) {
        output.note(&format!(
            "level {}: the gap's parts differ from the gap by {} of the upper bound, allowed is {IDENTITY}; the mesh was \
             not refined by them. The bounds are proven all the same",
            index + 1,
            number(level.identity_residual()),
        ));
    }
}

/// All levels as a table.
pub(crate) fn level_table(levels: &[LevelAnswer]) -> String {
    let header = ["elements", "upper", "s", "elements", "lower", "s"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    for level in levels {
        let mut row = level.upper.cells();
        row.extend(level.lower.as_ref().map_or_else(|| vec!["-".to_owned(); 3], SolveAnswer::cells));
        rows.push(row);
    }
    columns(&rows)
}

/// All levels as a table of a page; without times, which are different each time.
pub(crate) fn level_page_table(levels: &[LevelAnswer]) -> Result<Option<Table>, CliError> {
    if levels.is_empty() {
        return Ok(None);
    }
    let columns = ["level", "elements", "upper bound", "elements", "lower bound"].map(|c| (c, Align::Right));
    let mut table = Table::new("Meshes from coarse to fine, and what was proven on each", columns);
    for (index, level) in levels.iter().enumerate() {
        let two = |s: &SolveAnswer| [s.elements.to_string(), number_or_dash(s.proven)];
        let [upper, lower] = [Some(&level.upper), level.lower.as_ref()]
            .map(|s| s.map_or_else(|| ["-".to_owned(), "-".to_owned()], two));
        table.row([(index + 1).to_string()].into_iter().chain(upper).chain(lower))?;
    }
    Ok(Some(table))
}

impl SolveAnswer {
    fn cells(&self) -> Vec<String> {
        let seconds = self.seconds + self.proof_seconds;
        vec![self.elements.to_string(), number_or_dash(self.proven), format!("{seconds:.2}")]
    }
}
