//! Levels of meshes in answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::{Level, SHARES, Solve, Status};

use crate::Watch;
use crate::text::number;

/// One level of meshes.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct LevelAnswer {
    /// The upper bound on this level's mesh.
    pub upper: SolveAnswer,
    /// The lower bound on this level's mesh or one before; null if none was solved.
    pub lower: Option<SolveAnswer>,
    /// Gap of the two programs less the sum of its shares over all elements, relative to the upper bound; null without both
    /// bounds.
    pub identity_error: Option<f64>,
}

/// One solve.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SolveAnswer {
    /// Triangles.
    pub elements: usize,
    /// How the solver ended; proves nothing.
    pub status: Status,
    /// Steps of the solver.
    pub iterations: u32,
    /// Time in the solver in s.
    pub seconds: f64,
    /// Time for repair and proof in s.
    pub proof_seconds: f64,
    /// What was proven, in the units of the answer; null if nothing was.
    pub proven: Option<f64>,
}

impl LevelAnswer {
    /// A level whose bounds are multiplied by `unit`.
    pub(crate) fn new(level: &Level, unit: f64) -> Self {
        let solve = |s: &Solve| SolveAnswer {
            elements: s.elements,
            status: s.status,
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

/// Tells where the parts of a gap do not add up to it.
pub(super) fn note_doubts(levels: &[Level], watch: &dyn Watch) {
    for (index, level) in levels.iter().enumerate().filter(|(_, level)| !level.shares_tell()) {
        watch.note(&format!(
            "level {}: the gap's parts differ from the gap by {} of the upper bound, more than {} % of the gap; the mesh was \
             not refined by them. The bounds are proven all the same",
            index + 1,
            number(level.identity_residual()),
            number(100.0 * SHARES),
        ));
    }
}
