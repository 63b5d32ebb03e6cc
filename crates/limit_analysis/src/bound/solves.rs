//! One solve, and the proof of what comes out.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use soilctl_certificate::{CertificateError, LowerField, UpperField, prove_lower, prove_upper};
use soilctl_conic::{Accuracy, Answer, How, Program, Status};
use web_time::Instant;

use super::Solve;
use super::run::Run;
use crate::accuracy;
use crate::error::LimitError;
use crate::fields::{StressField, VelocityField};
use crate::lower::Lower;
use crate::mesh::Mesh;
use crate::topology::Topology;
use crate::upper::Upper;

/// What stays clear of all cones of an upper bound, in units of the structure's velocity; more if the proof fails.
const TIGHTENING: [f64; 3] = [1e-6, 1e-5, 1e-4];

/// What stays clear of all cones of a lower bound, in units of the local stress times the edge length over the plate's;
/// more if the proof fails; and how much of it must be left for the proof.
const LOWER_TIGHTENING: [f64; 3] = [3e-9, 3e-7, 1e-5];
/// The same for soil with curved strength: regularised more, the solver misses its cones by up to 6e-7, and drawing the solution inside costs more
/// than that where soil bears next to nothing.
const TIGHTENING_BELOW_LINES: [f64; 3] = [1e-6, 3e-6, 1e-5];
const LEFT: f64 = 0.5;

/// What the programs of upper bounds are found to need; those of finer meshes need no less.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Need {
    /// Which of [`TIGHTENING`].
    tightening: usize,
    /// [`accuracy::FLOW_STEADY`].
    steady: bool,
}

impl Need {
    fn accuracy(self) -> Accuracy {
        if self.steady { accuracy::FLOW_STEADY } else { accuracy::FLOW }
    }

    /// What to try after a program that ended so and whose flow was not proven; nothing if there is nothing left.
    fn next(self, status: Status) -> Option<Self> {
        if status == Status::Failed && !self.steady {
            return Some(Self { steady: true, ..self });
        }
        let tightening = self.tightening + 1;
        (tightening < TIGHTENING.len()).then_some(Self { tightening, ..self })
    }
}

/// An upper bound: what it needed, its figures, its flow as proven and as solved.
pub(super) type SolvedUpper = (Need, Solve, UpperField, VelocityField);

/// A lower bound: its figures, its stresses as proven and as solved, and its objective.
pub(super) type SolvedLower = (Solve, LowerField, StressField, f64);

/// What a proof says, and what it does not cover.
fn proven(proof: Result<f64, CertificateError>) -> (Option<f64>, Option<&'static str>) {
    match proof {
        Ok(value) => (Some(value).filter(|v| v.is_finite()), None),
        Err(CertificateError::NotCovered { what, .. }) => (None, Some(what)),
        Err(_) => (None, None),
    }
}

/// What the attempts at a solve took.
#[derive(Default)]
struct Spent {
    work: u64,
    seconds: f64,
}

impl Spent {
    fn add(&mut self, answer: &Answer, mesh: &Mesh) {
        self.work += u64::from(answer.iterations) * mesh.triangles.len() as u64;
        self.seconds += answer.seconds;
    }

    /// The figures of the last attempt, whose proof was begun at `start`.
    fn solve(
        &self,
        answer: &Answer,
        mesh: &Mesh,
        start: Instant,
        (proven, uncovered): (Option<f64>, Option<&'static str>),
    ) -> Solve {
        Solve {
            elements: mesh.triangles.len(),
            size: answer.size,
            status: answer.status,
            iterations: answer.iterations,
            work: self.work,
            factorisation: answer.factorisation,
            seconds: self.seconds,
            proof_seconds: start.elapsed().as_secs_f64(),
            proven,
            uncovered,
        }
    }
}

impl Run<'_> {
    /// Solves a program, as cones or linearised, in the user's time if there is any, unless it becomes needless.
    fn solve(
        &self,
        program: &Program,
        accuracy: Accuracy,
        name: &str,
        needless: &Arc<AtomicBool>,
    ) -> Result<Answer, LimitError> {
        let file = format!("{name}-{}-unknowns.json", program.unknowns);
        let dump = self.options.dump.as_ref().map(|folder| folder.join(file));
        let linear = self.options.segments.map(|p| program.linearised(p.max(3)));
        let program = linear.as_ref().unwrap_or(program);
        let stops = [&self.options.stop, &self.options.end, needless];
        let how = How {
            accuracy,
            factorisation: self.options.factorisation,
            seconds: self.clock.left(),
            dump: dump.as_deref(),
        };
        Ok(soilctl_conic::solve(program, how, stops)?)
    }

    pub(super) fn solve_upper(
        &self,
        number: usize,
        needless: &Arc<AtomicBool>,
    ) -> Result<SolvedUpper, LimitError> {
        let (mesh, topology) = &self.meshes[number];
        let still = self.mobile.still(mesh);
        let mut spent = Spent::default();
        let mut need = self.need;
        loop {
            let upper = Upper::new(self.problem, mesh, topology, &still, TIGHTENING[need.tightening]);
            let mut answer = self.solve(&upper.program, need.accuracy(), "upper", needless)?;
            if answer.status == Status::Infeasible {
                spent.add(&answer, mesh);
                answer = self.solve(&upper.program, accuracy::FLOW_AGAIN, "upper", needless)?;
            }
            spent.add(&answer, mesh);
            let start = Instant::now();
            let field = upper.saved(mesh, &answer.x);
            let (proven, uncovered) = proven(prove_upper(&self.problem.plane_statement(), &field));
            // A tighter program is no more feasible.
            let hopeless = matches!(answer.status, Status::Stopped | Status::Infeasible);
            let is_over = proven.is_some() || hopeless || uncovered.is_some();
            match need.next(answer.status).filter(|_| !is_over) {
                Some(next) => need = next,
                None => {
                    let solve = spent.solve(&answer, mesh, start, (proven, uncovered));
                    return Ok((need, solve, field, VelocityField::new(&upper, &answer.x)));
                }
            }
        }
    }

    pub(super) fn solve_lower(
        &self,
        (mesh, topology): &(Mesh, Topology),
        needless: &Arc<AtomicBool>,
    ) -> Result<SolvedLower, LimitError> {
        let mut spent = Spent::default();
        let is_curved = self.problem.soils.iter().any(|soil| soil.envelope.is_some());
        let accuracy = if is_curved { accuracy::STRESS_BELOW_LINES } else { accuracy::STRESS };
        let tightenings = if is_curved { TIGHTENING_BELOW_LINES } else { LOWER_TIGHTENING };
        for (attempt, tightening) in tightenings.iter().enumerate() {
            let lower = Lower::new(self.problem, mesh, topology, *tightening);
            let answer = self.solve(&lower.program, accuracy, "lower", needless)?;
            spent.add(&answer, mesh);
            let start = Instant::now();
            let x = lower.drawn_inside(&answer.x, -LEFT * tightening);
            let field = lower.saved(self.problem, mesh, topology, &x);
            let proof = prove_lower(self.problem.statement(), &field);
            let (proven, uncovered) = proven(proof);
            let hopeless = matches!(answer.status, Status::Stopped | Status::Infeasible);
            if proven.is_some() || hopeless || uncovered.is_some() || attempt + 1 == tightenings.len() {
                let solve = spent.solve(&answer, mesh, start, (proven, uncovered));
                let objective = lower.claim(&x);
                let stress = StressField::new(self.problem, mesh, topology, &lower, &x);
                return Ok((solve, field, stress, objective));
            }
        }
        Err(LimitError::nothing_proven(
            self.problem.has_no_tension(),
            format!("{} element steps", spent.work),
        ))
    }
}
