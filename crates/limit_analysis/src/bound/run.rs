//! The levels of a run.

use std::sync::Arc;

use soilctl_certificate::{LowerField, UpperField};
use soilctl_conic::Status;

use super::memory::capacity;
use super::solves::Need;
use super::{Bound, Clock, Ended, Level, Options, Solve, relative_gap};
use crate::error::LimitError;
use crate::fields::StressField;
use crate::gap::shares;
use crate::mesh::{Guide, Mesh};
use crate::mobile::MobileZone;
use crate::problem::Problem;
use crate::slide::{self, Cut};
use crate::start::Start;
use crate::topology::Topology;

/// Elements of the first mesh, roughly, and how much each next one is larger; one that grows less than this is not
/// worth its time.
pub(super) const FIRST: f64 = 600.0;
const GROWTH: f64 = 1.5;
const LEAST_GROWTH: f64 = 1.15;

/// Work and time of a solve grow with about these powers of the elements: a little more steps, and steps that take longer.
const WORK: f64 = 1.1;
const TIME: f64 = 1.3;

/// What a solve is expected to take is so much more than what the last one took, enlarged.
const SPARE: f64 = 1.1;

/// The mesh whose lower bound is solved with a level's upper bound: lower bounds need far fewer elements.
fn lower_mesh(level: usize) -> Option<usize> {
    match level {
        0 => Some(0),
        2 | 4 => Some(level - 1),
        _ => level.is_multiple_of(2).then(|| level - 2),
    }
}

/// What a solve takes.
#[derive(Default)]
struct Cost {
    /// Element steps.
    work: f64,
    seconds: f64,
}

/// What a run leaves to one of the same ground with other strengths: it begins on a mesh nearly as fine.
#[derive(Debug, Clone)]
pub(crate) struct Seed {
    shares: (Mesh, Vec<f64>),
    guides: Vec<Guide>,
    need: Need,
    /// Its last level, what that was asked to have of elements, and how many levels there were.
    last: Level,
    target: f64,
    count: usize,
}

impl Seed {
    /// Elements of the last mesh.
    pub(crate) fn elements(&self) -> usize {
        self.last.upper.elements
    }
}

/// A run so far.
pub(super) struct Run<'a> {
    pub(super) problem: &'a Problem,
    pub(super) options: &'a Options,
    pub(super) clock: Clock,
    /// Element steps of all solves that count.
    pub(super) spent: u64,
    pub(super) begin: Start,
    pub(super) meshes: Vec<(Mesh, Topology)>,
    pub(super) levels: Vec<Level>,
    pub(super) lower: Option<Bound<LowerField>>,
    pub(super) upper: Option<Bound<UpperField>>,
    /// The stress field behind the best lower bound, and its objective.
    stress: Option<(StressField, f64)>,
    pub(super) mobile: MobileZone,
    /// What the last upper bound needed.
    pub(super) need: Need,
    /// Elements asked for on the last mesh.
    pub(super) target: f64,
    /// Shares in the gap of the triangles of the last mesh for which they are known, before it was cut.
    pub(super) shares: Option<(Mesh, Vec<f64>)>,
    /// Slip lines for the next mesh.
    pub(super) guides: Vec<Guide>,
    /// Levels that a run before this one has spared it, and the last of that run.
    pub(super) spared: usize,
    before: Option<Level>,
}

impl<'a> Run<'a> {
    pub(super) fn new(problem: &'a Problem, options: &'a Options) -> Self {
        let begin = Start::new(problem);
        let guides = begin.guides.clone();
        let mobile = begin.mobile(0, &guides);
        Self {
            problem,
            options,
            clock: Clock::start(options.max_seconds),
            spent: 0,
            begin,
            mobile,
            meshes: Vec::new(),
            levels: Vec::new(),
            lower: None,
            upper: None,
            stress: None,
            need: Need::default(),
            target: FIRST,
            shares: None,
            guides,
            spared: 0,
            before: None,
        }
    }

    /// The same from what a run on the same ground has left: its first mesh is as that run's last but one.
    pub(super) fn seeded(problem: &'a Problem, options: &'a Options, seed: Seed) -> Self {
        let Seed { shares, guides, need, last, target, count } = seed;
        let run = Self::new(problem, options);
        let guides = if guides.is_empty() { run.guides } else { guides };
        Self {
            shares: Some(shares),
            guides,
            need,
            target: target / GROWTH,
            spared: count.saturating_sub(2),
            before: Some(last),
            ..run
        }
    }

    /// What it leaves to the next; nothing if it is not known where its gap is.
    pub(super) fn seed(&self) -> Option<Seed> {
        Some(Seed {
            shares: self.shares.clone()?,
            guides: self.guides.clone(),
            need: self.need,
            last: self.levels.last()?.clone(),
            target: self.target,
            count: self.spared + self.levels.len(),
        })
    }

    /// What a solve on `elements` is expected to take, from the last one like it.
    fn estimate(&self, elements: f64, of: impl Fn(&Level) -> Option<Solve>) -> Cost {
        self.before.iter().chain(&self.levels).rev().find_map(of).map_or(Cost::default(), |last| {
            let ratio = elements / last.elements as f64;
            Cost {
                work: SPARE * last.work as f64 * ratio.powf(WORK),
                seconds: SPARE * (last.seconds + last.proof_seconds) * ratio.powf(TIME),
            }
        })
    }

    /// Element steps left.
    fn remaining(&self) -> f64 {
        self.options.max_work.saturating_sub(self.spent) as f64
    }

    /// About how many elements the next mesh shall have, or why there is none.
    fn next_target(&self) -> Result<f64, Ended> {
        let Some(last) = self.levels.last() else {
            return if self.capacity() < self.target { Err(Ended::Memory) } else { Ok(self.target) };
        };
        if self.options.is_stopped() {
            return Err(Ended::Stopped);
        }
        let solved = last.upper.elements as f64;
        let growth = GROWTH.min(self.options.max_elements as f64 / solved);
        if growth < LEAST_GROWTH {
            return Err(Ended::Elements);
        }
        let needed = self.estimate(growth * solved, |l| Some(l.upper)).work;
        let growth = growth * (self.remaining() / needed).clamp(0.0, 1.0).powf(1.0 / WORK);
        if growth < LEAST_GROWTH {
            return Err(Ended::Work);
        }
        let growth = growth.min(self.capacity() / solved);
        if growth < LEAST_GROWTH {
            return Err(Ended::Memory);
        }
        // The clock never changes a mesh, it only ends the run.
        let fits = self.clock.allows(self.estimate(growth * solved, |l| Some(l.upper)).seconds);
        if fits { Ok(growth * self.target) } else { Err(Ended::Time) }
    }

    /// How many elements a level may have in the memory allowed.
    fn capacity(&self) -> f64 {
        capacity(self.options.max_memory_bytes)
    }

    /// One level. Returns why to stop, if so.
    pub(super) fn level(
        &mut self,
        progress: &mut dyn FnMut(&Level, Option<f64>),
    ) -> Result<Option<Ended>, LimitError> {
        let number = self.levels.len();
        let target = match self.next_target() {
            Ok(target) => target,
            Err(ended) => return Ok(Some(ended)),
        };
        self.target = target;
        // What is held by a mobile zone around wrong slip lines may move in the first one.
        let is_lost = self.levels.last().is_some_and(|l| l.upper.proven.is_none());
        if is_lost {
            self.guides = self.begin.guides.clone();
        }
        self.mobile = self.begin.mobile(if is_lost { 0 } else { number }, &self.guides);
        let mut guides = self.guides.clone();
        guides.extend(self.mobile.guide());
        let made = self.mesh(target, &self.begin.fans(self.spared + number), &guides)?;
        let Cut { mesh, topology, uncut } = slide::cut(self.problem, made, &self.begin.slides);
        let made = (mesh, topology);
        if made.0.triangles.len() as f64 > self.capacity() {
            return Ok(Some(Ended::Memory));
        }
        self.meshes.push(made);

        let expected = |m: usize| self.estimate(self.meshes[m].0.triangles.len() as f64, |l| l.lower);
        let affordable = lower_mesh(number).filter(|m| number == 0 || expected(*m).work < self.remaining());
        let lower_mesh = affordable.filter(|m| number == 0 || self.clock.allows(expected(*m).seconds));
        let mut is_cut = affordable != lower_mesh;
        let own = lower_mesh.map(|m| self.lower_mesh(m)).transpose()?.flatten();
        let (upper, lower) = self.solve_both(number, own.as_ref().or(lower_mesh.map(|m| &self.meshes[m])))?;
        self.spent += upper.as_ref().map_or(0, |u| u.1.work) + lower.as_ref().map_or(0, |l| l.0.work);
        let solves = [upper.as_ref().map(|u| u.1.status), lower.as_ref().map(|l| l.0.status)];
        is_cut |= solves.contains(&Some(Status::Stopped));
        let Some((need, upper_solve, upper_field, velocity)) = upper else {
            // The lower bound was enough for the mesh before.
            self.meshes.pop();
            if let Some((solve, field, stress, objective)) = lower {
                self.keep_lower(&solve, field, stress, objective);
                self.tell_lower(solve, progress);
            }
            return Ok(Some(if is_cut { self.cut() } else { Ended::Gap }));
        };
        // What did not help is not held against the next mesh.
        if upper_solve.proven.is_some() {
            self.need = need;
        }
        let mut level = Level { upper: upper_solve, lower: None, identity: None };
        if let Some((solve, field, stress, objective)) = lower {
            level.lower = Some(solve);
            self.keep_lower(&solve, field, stress, objective);
        }
        if let Some(value) = upper_solve.proven.filter(|v| self.upper.as_ref().is_none_or(|b| *v < b.value)) {
            let Solve { elements, factorisation, .. } = upper_solve;
            self.upper = Some(Bound { value, elements, field: upper_field, factorisation });
        }
        let gap = self.gap();
        let (mesh, topology) = &self.meshes[number];
        if let (Some((stress, lower_objective)), Some(proven)) = (&self.stress, upper_solve.proven) {
            let by_triangle = shares(self.problem, mesh, topology, &velocity, stress);
            level.identity = Some([proven - lower_objective, by_triangle.iter().sum()]);
            // Shares that do not add up to the gap say nothing about where it is.
            if level.shares_tell() {
                self.shares = Some(match uncut {
                    Some((uncut, part_of)) => {
                        let mut shares = vec![0.0; uncut.triangles.len()];
                        part_of.iter().zip(by_triangle).for_each(|(whole, share)| shares[*whole] += share);
                        (uncut, shares)
                    }
                    None => (mesh.clone(), by_triangle),
                });
            }
            self.guides = crate::slip::guides(self.problem, mesh, topology, &velocity, &self.begin.tips);
        }
        progress(&level, gap);
        self.levels.push(level);
        // Without what was cut off the same gap may be reached later.
        if is_cut {
            return Ok(Some(self.cut()));
        }
        if gap.is_some_and(|g| g <= self.options.max_gap) {
            return Ok(Some(Ended::Gap));
        }
        let is_over = self.options.is_stopped() || !self.clock.allows(0.0);
        Ok(is_over.then(|| self.cut()))
    }

    /// Whether the user or the clock cut a level short.
    fn cut(&self) -> Ended {
        if self.options.is_stopped() { Ended::Stopped } else { Ended::Time }
    }

    /// Spends what is left on a lower bound on the finest mesh that fits, unless the run is to end at once. Returns why it
    /// ends, which is another reason if the clock does not let it have the mesh that the work allows.
    pub(super) fn last_lower(
        &mut self,
        mut ended: Ended,
        progress: &mut dyn FnMut(&Level, Option<f64>),
    ) -> Result<Ended, LimitError> {
        match ended {
            Ended::Gap | Ended::Stopped => return Ok(ended),
            Ended::Time | Ended::Elements | Ended::Work | Ended::Memory => {}
        }
        let solved = self.levels.iter().filter_map(|l| l.lower).map(|s| s.elements).max().unwrap_or(0);
        for number in (0..self.meshes.len()).rev() {
            let elements = self.meshes[number].0.triangles.len();
            let Cost { work, seconds } = self.estimate(elements as f64, |l| l.lower);
            if elements <= solved || work >= self.remaining() {
                continue;
            }
            if !self.clock.allows(seconds) {
                ended = Ended::Time;
                continue;
            }
            let own = self.lower_mesh(number)?;
            let mesh = own.as_ref().unwrap_or(&self.meshes[number]);
            let (solve, field, stress, objective) = self.solve_lower(mesh, &Arc::default())?;
            self.spent += solve.work;
            if solve.status == Status::Stopped {
                ended = self.cut();
            }
            self.keep_lower(&solve, field, stress, objective);
            self.tell_lower(solve, progress);
            break;
        }
        Ok(ended)
    }

    /// Adds a lower bound to the last level, which had none.
    fn tell_lower(&mut self, solve: Solve, progress: &mut dyn FnMut(&Level, Option<f64>)) {
        let gap = self.gap();
        if let Some(level) = self.levels.last_mut().filter(|l| l.lower.is_none()) {
            level.lower = Some(solve);
            progress(level, gap);
        }
    }

    /// Takes over a lower bound, with the stress field behind it, if it is the best.
    fn keep_lower(&mut self, solve: &Solve, field: LowerField, stress: StressField, objective: f64) {
        if let Some(value) = solve.proven.filter(|v| self.lower.as_ref().is_none_or(|b| *v > b.value)) {
            let Solve { elements, factorisation, .. } = *solve;
            self.lower = Some(Bound { value, elements, field, factorisation });
            self.stress = Some((stress, objective));
        }
    }

    fn gap(&self) -> Option<f64> {
        Some(relative_gap(self.lower.as_ref()?.value, self.upper.as_ref()?.value))
    }
}
