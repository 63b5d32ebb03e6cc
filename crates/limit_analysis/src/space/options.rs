//! What a run may spend, and what comes of it.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use soilctl_certificate::{Claim, Computed, SpaceStress};
use soilctl_conic::{SOLVER, Status};

use super::FACTORISATION;

/// When to stop, and what may be spent.
#[derive(Debug, Clone)]
pub struct EndOptions {
    /// Meshes after the first, each finer where the soil yielded.
    pub steps: usize,
    /// How many tetrahedra the last mesh has, about; those before have fewer, each by the same factor. The first has a
    /// little more than a hundred, and no fewer if fewer are asked for. A step bisects none twice on purpose, so each mesh has at
    /// most about three times as many as that before: few steps do not get there. Time grows a little faster than their number.
    /// The certificate reads at most 10,000.
    pub tetrahedra: usize,
    /// Time in seconds, if the user wants to limit it. Where the run ends then depends on the machine.
    pub max_seconds: Option<f64>,
    /// Set one of them to end the run early with the best field so far.
    pub stops: [Arc<AtomicBool>; 2],
}

impl Default for EndOptions {
    fn default() -> Self {
        Self { steps: 5, tetrahedra: 1_200, max_seconds: None, stops: Default::default() }
    }
}

/// One mesh that was solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndLevel {
    /// Tetrahedra about the end.
    pub tetrahedra: usize,
    /// Triangles of the section between the ends.
    pub triangles: usize,
    /// The force per unit width that the solver found, in units of weight times depth squared; meaningless if it failed.
    pub value: f64,
    /// The same of the section alone, where there are no ends.
    pub between: f64,
    /// How the solve ended.
    pub status: Status,
    /// Steps of the solver.
    pub iterations: u32,
    /// Time in seconds from the start of the run.
    pub seconds: f64,
}

/// A stress field about the end of a plate. Nothing is proven of it:
/// [`prove_end`](soilctl_certificate::prove_end) does.
#[derive(Debug, Clone)]
pub struct EndLower {
    /// The best field that was found.
    pub field: SpaceStress,
    /// Its force per unit width, in units of weight times depth squared, as the solver has it.
    pub value: f64,
    /// All meshes, in order.
    pub levels: Vec<EndLevel>,
}

impl EndLower {
    /// The field with what is proven of it, for a file.
    #[must_use]
    pub fn claim(self, proven: f64) -> Claim<SpaceStress> {
        let factorisation = FACTORISATION.name().to_owned();
        let computed = Computed { solver: SOLVER.to_owned(), factorisation };
        Claim { field: self.field, claimed: proven, computed: Some(computed) }
    }
}
