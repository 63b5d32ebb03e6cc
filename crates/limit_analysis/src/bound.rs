//! Both bounds of a problem on a sequence of meshes, each made from what the last one showed.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use soilctl_certificate::{LowerField, UpperField, prove_lower, prove_upper};

use crate::adapt::wanted_sizes;
use crate::bowl::Bowl;
use crate::error::LimitError;
use crate::fields::{StressField, VelocityField};
use crate::gap::shares;
use crate::lower::Lower;
use crate::mesh::{Mesh, Request, generate};
use crate::problem::Problem;
use crate::program::Program;
use crate::solver::{self, Accuracy, Answer, Status};
use crate::start::Start;
use crate::topology::Topology;
use crate::upper::Upper;

/// When to stop, and what may be spent.
#[derive(Debug, Clone)]
pub struct Options {
    /// Relative gap, `(U - L) / ((U + L) / 2)`, at which to stop.
    pub max_gap: f64,
    /// Time in seconds. Which level is the last then depends on the machine; what each level gives does not.
    pub max_seconds: f64,
    /// No mesh has more elements.
    pub max_elements: usize,
    /// 1: one solve at a time; more: both bounds of a level at once. The results are the same.
    pub threads: usize,
    /// Replaces each cone by a pyramid of so many sides inside it (at least 3), which makes the programs linear: for
    /// comparison. Bounds are proven as always, but further apart.
    pub segments: Option<usize>,
    /// An existing folder for programs that end in numerical trouble, one file each, to reproduce it from.
    pub dump: Option<PathBuf>,
    /// Set to end the run early with the best bounds so far.
    pub stop: Arc<AtomicBool>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            max_gap: 0.01,
            max_seconds: 60.0,
            max_elements: 20_000,
            threads: 1,
            segments: None,
            dump: None,
            stop: Arc::new(AtomicBool::new(false)),
        }
    }
}

/// A proven bound.
#[derive(Debug, Clone)]
pub struct Bound<F> {
    /// The bound, as the certificate proves it: power of the structure's force at its velocity.
    pub value: f64,
    /// Triangles of its mesh.
    pub elements: usize,
    /// What proves it.
    pub field: F,
}

/// One solve of a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solve {
    /// Triangles.
    pub elements: usize,
    /// How the solver ended.
    pub status: Status,
    /// Its steps.
    pub iterations: u32,
    /// Time in the solver in seconds.
    pub seconds: f64,
    /// Time for repair and proof in seconds.
    pub proof_seconds: f64,
    /// The proven bound, if there is one.
    pub proven: Option<f64>,
}

/// One mesh and what was solved after it was made.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The upper bound, on this level's mesh.
    pub upper: Solve,
    /// A lower bound, on the mesh of this level or of one before.
    pub lower: Option<Solve>,
    /// Gap by the objectives, and by the sum of its shares over the soil: equal but for rounding.
    pub identity: Option<[f64; 2]>,
}

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// The gap asked for is reached.
    Gap,
    /// Time is up, or the next level would not fit.
    Time,
    /// The next mesh would have too many elements.
    Elements,
    /// The user asked.
    Stopped,
}

/// The bounds of a problem.
#[derive(Debug, Clone)]
pub struct Bounds {
    /// The greatest lower bound proven.
    pub lower: Bound<LowerField>,
    /// The least upper bound proven.
    pub upper: Bound<UpperField>,
    /// All levels.
    pub levels: Vec<Level>,
    /// Why there are no more.
    pub ended: Ended,
    /// Time in seconds.
    pub seconds: f64,
}

impl Bounds {
    /// Distance of the bounds over their mean.
    #[must_use]
    pub fn gap(&self) -> f64 {
        relative_gap(self.lower.value, self.upper.value)
    }
}

fn relative_gap(lower: f64, upper: f64) -> f64 {
    2.0 * (upper - lower) / (upper + lower).abs()
}

/// Elements of the first mesh, roughly, and how much each next one is larger; one that grows less than this is not
/// worth its time.
const FIRST: f64 = 600.0;
const GROWTH: f64 = 1.5;
const LEAST_GROWTH: f64 = 1.15;

/// Time of a solve grows with about this power of the elements.
const COST: f64 = 1.3;

/// Solver accuracies. The gap shows in the bound; what a stress field misses its cones by costs much of the bound, so
/// lower bounds need more.
const UPPER_ACCURACY: Accuracy = Accuracy { gap: 1e-5, feasibility: 1e-8 };
const LOWER_ACCURACY: Accuracy = Accuracy { gap: 1e-6, feasibility: 1e-8 };

/// What stays clear of all cones of an upper bound, in units of the structure's velocity; more if the proof fails.
const TIGHTENING: [f64; 3] = [1e-6, 1e-5, 1e-4];

/// What stays clear of all cones of a lower bound, in units of the local stress times the edge length over the plate's;
/// more if the proof fails; and how much of it must be left for the proof.
const LOWER_TIGHTENING: [f64; 3] = [3e-9, 3e-7, 1e-5];
const LEFT: f64 = 0.5;

/// The mesh whose lower bound is solved with a level's upper bound: lower bounds need far fewer elements.
fn lower_mesh(level: usize) -> Option<usize> {
    match level {
        0 => Some(0),
        2 | 4 => Some(level - 1),
        _ => level.is_multiple_of(2).then(|| level - 2),
    }
}

/// Bounds the load of a problem, calling `progress` after each level.
///
/// # Errors
///
/// [`LimitError`] if the mesh cannot be made, the solver refuses, or no pair of bounds is proven within the budget.
pub fn bound(
    problem: &Problem,
    options: &Options,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<Bounds, LimitError> {
    problem.covered()?;
    let mut run = Run::new(problem, options);
    let ended = loop {
        if let Some(ended) = run.level(progress)? {
            if matches!(ended, Ended::Time | Ended::Elements) {
                run.last_lower(progress)?;
            }
            break ended;
        }
    };
    match (run.lower, run.upper) {
        (Some(lower), Some(upper)) => {
            Ok(Bounds { lower, upper, levels: run.levels, ended, seconds: run.start.elapsed().as_secs_f64() })
        }
        _ => Err(LimitError::NothingProven {
            spent: format!("{} levels, {:.1} s", run.levels.len(), run.start.elapsed().as_secs_f64()),
        }),
    }
}

struct Run<'a> {
    problem: &'a Problem,
    options: &'a Options,
    start: Instant,
    begin: Start,
    meshes: Vec<(Mesh, Topology)>,
    levels: Vec<Level>,
    lower: Option<Bound<LowerField>>,
    upper: Option<Bound<UpperField>>,
    /// The stress field behind the best lower bound, and its objective.
    stress: Option<(StressField, f64)>,
    bowl: Bowl,
    /// Which tightening the last upper bound needed; finer meshes need no less.
    tightening: usize,
    /// Elements asked for on the last mesh.
    target: f64,
    /// Shares in the gap of the triangles of the last mesh for which they are known.
    shares: Option<(usize, Vec<f64>)>,
    guides: Vec<crate::mesh::Guide>,
}

impl<'a> Run<'a> {
    fn new(problem: &'a Problem, options: &'a Options) -> Self {
        let begin = Start::new(problem);
        let guides = begin.guides.clone();
        let bowl = begin.bowl(0, &guides);
        Self {
            problem,
            options,
            start: Instant::now(),
            begin,
            bowl,
            meshes: Vec::new(),
            levels: Vec::new(),
            lower: None,
            upper: None,
            stress: None,
            tightening: 0,
            target: FIRST,
            shares: None,
            guides,
        }
    }

    fn remaining(&self) -> f64 {
        self.options.max_seconds - self.start.elapsed().as_secs_f64()
    }

    /// Time that a solve on `elements` will take, from the last one like it.
    fn estimate(&self, elements: usize, of: impl Fn(&Level) -> Option<Solve>) -> f64 {
        self.levels.iter().rev().find_map(of).map_or(0.0, |last| {
            1.1 * (last.seconds + last.proof_seconds) * (elements as f64 / last.elements as f64).powf(COST)
        })
    }

    /// About how many elements the next mesh shall have, or why there is none.
    fn next_target(&self) -> Result<f64, Ended> {
        let Some(last) = self.levels.last() else { return Ok(FIRST) };
        if self.options.stop.load(Ordering::Relaxed) {
            return Err(Ended::Stopped);
        }
        let solved = last.upper.elements as f64;
        let growth = GROWTH.min(self.options.max_elements as f64 / solved);
        if growth < LEAST_GROWTH {
            return Err(Ended::Elements);
        }
        let needed = self.estimate((growth * solved) as usize, |l| Some(l.upper));
        let growth = growth * (self.remaining() / needed).clamp(0.0, 1.0).powf(1.0 / COST);
        if growth < LEAST_GROWTH { Err(Ended::Time) } else { Ok(growth * self.target) }
    }

    /// One level. Returns why to stop, if so.
    fn level(&mut self, progress: &mut dyn FnMut(&Level, Option<f64>)) -> Result<Option<Ended>, LimitError> {
        let number = self.levels.len();
        let target = match self.next_target() {
            Ok(target) => target,
            Err(ended) => return Ok(Some(ended)),
        };
        self.target = target;
        let fans = self.begin.fans(number);
        // Until shares are known, all of it gets finer.
        let finer = (FIRST / target).sqrt();
        let first = |p: [f64; 2]| finer * self.begin.size(p);
        let field = self
            .shares
            .as_ref()
            .map(|(m, shares)| wanted_sizes(&self.meshes[*m].0, shares, target as usize, self.begin.largest))
            .transpose()?;
        let later = field.as_ref().map(|field| |p: [f64; 2]| field.size(p));
        let size: &dyn Fn([f64; 2]) -> f64 = match &later {
            Some(size) => size,
            None => &first,
        };
        self.bowl = self.begin.bowl(number, &self.guides);
        let mut guides = self.guides.clone();
        guides.extend(self.bowl.guide());
        let request = Request {
            outline: &self.problem.outline,
            guides: &guides,
            fans: &fans,
            size,
            // The size field asks for about the target; the fans come on top.
            max_triangles: 4 * self.options.max_elements + 10_000,
        };
        let mesh = generate(&request)?;
        let topology = Topology::new(&mesh);
        self.meshes.push((mesh, topology));

        let lower_mesh = lower_mesh(number).filter(|m| {
            number == 0 || self.estimate(self.meshes[*m].0.triangles.len(), |l| l.lower) < self.remaining()
        });
        let run = &*self;
        let (upper, lower) = if self.options.threads > 1 {
            std::thread::scope(|scope| {
                let lower = scope.spawn(|| lower_mesh.map(|m| run.solve_lower(m)).transpose());
                let upper = run.solve_upper(number);
                let lower = lower.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
                (upper, lower)
            })
        } else {
            (run.solve_upper(number), lower_mesh.map(|m| run.solve_lower(m)).transpose())
        };
        let (tightening, upper_solve, upper_field, velocity, objective) = upper?;
        self.tightening = tightening;
        let mut level = Level { upper: upper_solve, lower: None, identity: None };
        if let Some((solve, field, stress, objective)) = lower? {
            level.lower = Some(solve);
            self.keep_lower(&solve, field, stress, objective);
        }
        if let Some(value) = upper_solve.proven.filter(|v| self.upper.as_ref().is_none_or(|b| *v < b.value)) {
            self.upper = Some(Bound { value, elements: upper_solve.elements, field: upper_field });
        }
        let gap = self.gap();
        let (mesh, topology) = &self.meshes[number];
        if let Some((stress, lower_objective)) = self.stress.as_ref().filter(|_| upper_solve.proven.is_some())
        {
            let by_triangle = shares(self.problem, mesh, topology, &velocity, stress);
            level.identity = Some([objective - lower_objective, by_triangle.iter().sum()]);
            self.shares = Some((number, by_triangle));
            self.guides = crate::slip::guides(self.problem, mesh, topology, &velocity, &self.begin.tips);
        }
        progress(&level, gap);
        self.levels.push(level);
        if gap.is_some_and(|g| g <= self.options.max_gap) {
            return Ok(Some(Ended::Gap));
        }
        if self.options.stop.load(Ordering::Relaxed) {
            return Ok(Some(Ended::Stopped));
        }
        Ok((upper_solve.status == Status::Stopped || self.remaining() <= 0.0).then_some(Ended::Time))
    }

    /// Spends what is left on a lower bound on the finest mesh that fits.
    fn last_lower(&mut self, progress: &mut dyn FnMut(&Level, Option<f64>)) -> Result<(), LimitError> {
        let solved = self.levels.iter().filter_map(|l| l.lower).map(|s| s.elements).max().unwrap_or(0);
        let fits = |m: &usize| {
            let elements = self.meshes[*m].0.triangles.len();
            elements > solved && self.estimate(elements, |l| l.lower) < self.remaining()
        };
        let Some(number) = (0..self.meshes.len()).rev().find(fits) else { return Ok(()) };
        let (solve, field, stress, objective) = self.solve_lower(number)?;
        self.keep_lower(&solve, field, stress, objective);
        let gap = self.gap();
        if let Some(level) = self.levels.last_mut().filter(|l| l.lower.is_none()) {
            level.lower = Some(solve);
            progress(level, gap);
        }
        Ok(())
    }

    /// Takes over a lower bound, with the stress field behind it, if it is the best.
    fn keep_lower(&mut self, solve: &Solve, field: LowerField, stress: StressField, objective: f64) {
        if let Some(value) = solve.proven.filter(|v| self.lower.as_ref().is_none_or(|b| *v > b.value)) {
            self.lower = Some(Bound { value, elements: solve.elements, field });
            self.stress = Some((stress, objective));
        }
    }

    fn gap(&self) -> Option<f64> {
        Some(relative_gap(self.lower.as_ref()?.value, self.upper.as_ref()?.value))
    }

    /// Solves a program, as cones or linearised, in the time that is left.
    fn solve(&self, program: &Program, accuracy: Accuracy, name: &str) -> Result<Answer, LimitError> {
        let file = format!("{name}-{}-unknowns.json", program.unknowns);
        let dump = self.options.dump.as_ref().map(|folder| folder.join(file));
        let linear = self.options.segments.map(|p| program.linearised(p.max(3)));
        let program = linear.as_ref().unwrap_or(program);
        solver::solve(program, accuracy, self.remaining().max(0.0), &self.options.stop, dump.as_deref())
    }

    fn solve_upper(
        &self,
        number: usize,
    ) -> Result<(usize, Solve, UpperField, VelocityField, f64), LimitError> {
        let (mesh, topology) = &self.meshes[number];
        let still = self.bowl.still(mesh);
        let mut spent = 0.0;
        for (attempt, tightening) in TIGHTENING.iter().enumerate().skip(self.tightening) {
            let upper = Upper::new(self.problem, mesh, topology, &still, *tightening);
            let answer = self.solve(&upper.program, UPPER_ACCURACY, "upper")?;
            let start = Instant::now();
            let field = upper.saved(mesh, &answer.x);
            let proven = prove_upper(self.problem.statement(), &field).ok().filter(|v| v.is_finite());
            spent += answer.seconds;
            let solve = Solve {
                elements: mesh.triangles.len(),
                status: answer.status,
                iterations: answer.iterations,
                seconds: spent,
                proof_seconds: start.elapsed().as_secs_f64(),
                proven,
            };
            // A tighter program is no more feasible.
            let hopeless = matches!(answer.status, Status::Stopped | Status::Infeasible);
            if proven.is_some() || hopeless || attempt + 1 == TIGHTENING.len() {
                let velocity = VelocityField::new(&upper, &answer.x);
                let objective = upper.force.value(&answer.x);
                return Ok((attempt, solve, field, velocity, objective));
            }
        }
        Err(LimitError::NothingProven { spent: format!("{spent:.1} s") })
    }

    fn solve_lower(&self, number: usize) -> Result<(Solve, LowerField, StressField, f64), LimitError> {
        let (mesh, topology) = &self.meshes[number];
        let mut spent = 0.0;
        for (attempt, tightening) in LOWER_TIGHTENING.iter().enumerate() {
            let lower = Lower::new(self.problem, mesh, topology, *tightening);
            let answer = self.solve(&lower.program, LOWER_ACCURACY, "lower")?;
            spent += answer.seconds;
            let start = Instant::now();
            let x = lower.drawn_inside(&answer.x, -LEFT * tightening);
            let field = lower.function.saved(mesh, topology, self.problem, &x);
            let proven = prove_lower(self.problem.statement(), &field).ok().filter(|v| v.is_finite());
            let hopeless = matches!(answer.status, Status::Stopped | Status::Infeasible);
            if proven.is_some() || hopeless || attempt + 1 == LOWER_TIGHTENING.len() {
                let solve = Solve {
                    elements: mesh.triangles.len(),
                    status: answer.status,
                    iterations: answer.iterations,
                    seconds: spent,
                    proof_seconds: start.elapsed().as_secs_f64(),
                    proven,
                };
                let objective = lower.force.value(&x);
                let stress = StressField::new(mesh, topology, &lower, &x);
                return Ok((solve, field, stress, objective));
            }
        }
        Err(LimitError::NothingProven { spent: format!("{spent:.1} s") })
    }
}
