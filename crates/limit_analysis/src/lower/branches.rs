//! Branch cuts from bodies inside the soil to its rim.
//!
//! An Airy stress function that is single-valued all around a body carries no force on it: forces are changes of its
//! slopes. So along a cut from each such body to the rim the function beyond is the function before plus an affine one, a
//! *branch*, whose slopes are the force and whose value is the moment (Michell's conditions for multiply connected regions).

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use soilctl_certificate::{Condition, LineUse, Side};

use crate::members::member_edges;
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;

/// Mesh edges along which the stress function may differ by a branch: one cut for each body, from the rim to the body.
#[derive(Debug, Clone, Default)]
pub(super) struct BranchCuts {
    pub(super) all: Vec<Vec<usize>>,
    edges: BTreeSet<[usize; 2]>,
}

/// What is known about the vertices of boundaries.
struct Rim {
    /// Boundary edges of each vertex: what holds there, and the other end.
    touching: BTreeMap<usize, Vec<(Condition, usize)>>,
    /// Vertices that hang together along boundaries have the same number.
    part: BTreeMap<usize, usize>,
}

impl Rim {
    fn new(problem: &Problem, mesh: &Mesh, topology: &Topology) -> Self {
        let mut touching: BTreeMap<usize, Vec<(Condition, usize)>> = BTreeMap::new();
        for (triangle, t) in mesh.triangles.iter().enumerate() {
            for corner in 0..3 {
                let line = topology.line[triangle][corner];
                let Some(condition) = line.and_then(|l| problem.condition(l)) else { continue };
                let ends = [1, 2].map(|i| t.corners[(corner + i) % 3]);
                for (end, other) in [(ends[0], ends[1]), (ends[1], ends[0])] {
                    touching.entry(end).or_default().push((condition, other));
                }
            }
        }
        let mut part = BTreeMap::new();
        for (number, start) in touching.keys().enumerate() {
            let mut open = vec![*start];
            while let Some(here) = open.pop() {
                if part.contains_key(&here) {
                    continue;
                }
                part.insert(here, number);
                open.extend(touching[&here].iter().map(|(_, other)| *other));
            }
        }
        Self { touching, part }
    }

    /// Whether the function is free at a vertex, or known from one run of loads on both sides: a cut may end there.
    fn may_end(&self, vertex: usize) -> bool {
        let conditions = || self.touching[&vertex].iter().map(|(c, _)| *c);
        !conditions().any(Condition::shear_is_given)
            && (!conditions().any(Condition::traction_is_given)
                || (conditions().count() == 2 && conditions().all(Condition::traction_is_given)))
    }
}

impl BranchCuts {
    pub(super) fn new(problem: &Problem, mesh: &Mesh, topology: &Topology) -> Self {
        let rim = Rim::new(problem, mesh, topology);
        let leftmost = |v: &&usize| mesh.vertices[**v].position;
        let outermost = rim.part.keys().min_by(|a, b| {
            let ([ax, ay], [bx, by]) = (leftmost(a), leftmost(b));
            ax.total_cmp(&bx).then(ay.total_cmp(&by))
        });
        let Some(outer) = outermost.map(|v| rim.part[v]) else { return Self::default() };
        let bodies: BTreeSet<usize> = rim.part.values().copied().filter(|p| *p != outer).collect();
        let mut cuts = Self::default();
        if bodies.is_empty() {
            return cuts;
        }
        let mut neighbours: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); mesh.vertices.len()];
        for (triangle, t) in mesh.triangles.iter().enumerate() {
            for corner in (0..3).filter(|k| topology.across[triangle][*k].is_some()) {
                let line = topology.line[triangle][corner];
                if line.is_some_and(|l| problem.condition(l).is_some()) {
                    continue;
                }
                let [a, b] = [1, 2].map(|i| t.corners[(corner + i) % 3]);
                neighbours[a].insert(b);
                neighbours[b].insert(a);
            }
        }
        // What a member does to the function has nothing to do with branches: cuts keep away from it.
        let edges = member_edges(problem, mesh, topology);
        let on_members = edges.iter().flat_map(|e| {
            let Side { triangle, corner } = e.first();
            [1, 2].map(|i| mesh.triangles[triangle].corners[(corner + i) % 3])
        });
        let mut taken: BTreeSet<usize> = on_members.collect();
        for body in bodies {
            let is_free = |v: &usize| !taken.contains(v);
            let starts = rim.part.iter().filter(|(v, p)| **p == body && rim.may_end(**v)).map(|(v, _)| *v);
            let starts = starts.filter(is_free);
            let ends = |v: usize| rim.part.get(&v) == Some(&outer) && rim.may_end(v);
            let passes = |v: usize| !rim.part.contains_key(&v);
            let Some(cut) = shortest(&neighbours, starts, |v| taken.contains(&v), ends, passes) else {
                continue;
            };
            taken.extend(&cut);
            cuts.edges.extend(cut.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]));
            cuts.all.push(cut);
        }
        cuts
    }

    /// Whether an edge is on a cut.
    pub(super) fn holds(&self, mesh: &Mesh, side: Side) -> bool {
        let corners = mesh.triangles[side.triangle].corners;
        let [a, b] = [1, 2].map(|i| corners[(side.corner + i) % 3]);
        self.edges.contains(&[a.min(b), a.max(b)])
    }
}

/// The cut with the fewest edges, from where it ends to where it starts.
fn shortest(
    neighbours: &[BTreeSet<usize>],
    starts: impl Iterator<Item = usize>,
    is_taken: impl Fn(usize) -> bool,
    ends: impl Fn(usize) -> bool,
    passes: impl Fn(usize) -> bool,
) -> Option<Vec<usize>> {
    let mut from: BTreeMap<usize, Option<usize>> = BTreeMap::new();
    let mut open: VecDeque<usize> = VecDeque::new();
    for start in starts {
        from.insert(start, None);
        open.push_back(start);
    }
    while let Some(here) = open.pop_front() {
        for next in &neighbours[here] {
            if from.contains_key(next) || is_taken(*next) {
                continue;
            }
            if ends(*next) {
                let mut cut = vec![*next, here];
                let mut at = here;
                while let Some(before) = from.get(&at).copied().flatten() {
                    cut.push(before);
                    at = before;
                }
                return Some(cut);
            }
            if passes(*next) {
                from.insert(*next, Some(here));
                open.push_back(*next);
            }
        }
    }
    None
}

/// Where a branch starts on a run of loads: the number of the side in the run and how far along it, as it is walked.
pub(super) type Place = (usize, f64);

/// The gauges of all parts of runs: a run has its own up to the first cut that ends on it, then a branch for each.
#[derive(Debug, Clone, Default)]
pub(super) struct Branches {
    /// Run, place, and cut of each branch on a run, in the order of the runs and along them.
    on_runs: Vec<(usize, Place, usize)>,
    /// Number of runs, at least one.
    runs: usize,
    /// Number of cuts.
    cuts: usize,
}

impl Branches {
    pub(super) fn new(runs: usize, cuts: usize, mut on_runs: Vec<(usize, Place, usize)>) -> Self {
        on_runs.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.0.cmp(&b.1.0)).then(a.1.1.total_cmp(&b.1.1)));
        Self { on_runs, runs: runs.max(1), cuts }
    }

    /// Number of gauges, branches included.
    pub(super) fn gauges(&self) -> usize {
        self.runs + self.cuts
    }

    /// The gauge of a part of a run.
    pub(super) fn gauge(&self, run: usize, place: Place) -> usize {
        let passed = |(r, p, _): &&(usize, Place, usize)| *r == run && *p < place;
        self.on_runs.iter().rev().find(passed).map_or(run, |(.., cut)| self.runs + cut)
    }

    /// The gauges on both sides of a cut that ends away from loads.
    pub(super) fn around(&self, cut: usize) -> [usize; 2] {
        [0, self.runs + cut]
    }
}

/// Fraction of a side as it is walked.
pub(super) fn walked(side: LineUse, s: f64) -> f64 {
    if side.forward { s } else { 1.0 - s }
}
