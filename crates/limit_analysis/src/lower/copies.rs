//! Vertices, split where boundaries cut the soil, and what the boundaries say there.

use soilctl_certificate::{Condition, LineUse};

use super::given::{Across, shear_is_given};
use super::loads::{Loads, is_loaded};
use super::macro_element::turned;
use super::reference::Reference;
use super::shape::{Shape, Turn, Unknown};
use crate::form::Form;
use crate::mesh::{Mesh, Place};
use crate::problem::Problem;
use crate::program::Program;
use crate::topology::{Side, Topology};

type Point = [f64; 2];

/// Where a chain meets a line of given shear.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    pub(super) chain: usize,
    pub(super) copy: usize,
    /// Position on the line, 0 or 1.
    pub(super) at: f64,
}

/// What is gathered about the copies before unknowns are handed out.
pub(super) struct Copies<'a> {
    problem: &'a Problem,
    mesh: &'a Mesh,
    topology: &'a Topology,
    pub(super) loads: Loads,
    /// Copy at each triangle corner.
    pub(super) corners: Vec<[usize; 3]>,
    pub(super) vertex_of: Vec<usize>,
    /// Region of a triangle at each copy.
    region: Vec<usize>,
    /// For copies on free and loaded boundaries, the chain and what the loads demand.
    pub(super) chain_of: Vec<Option<(usize, [Form; 3])>>,
    /// Copies at which all stress must vanish.
    pub(super) apex: Vec<bool>,
    /// Lines of given shear through each copy, with the position on them.
    given: Vec<Vec<(usize, f64)>>,
    /// Apexes next to each copy.
    apexes: Vec<Vec<usize>>,
    /// Mean length of the edges at each copy.
    length: Vec<f64>,
    /// For each line of given shear, the chains that meet it.
    pub(super) meetings: Vec<Vec<Meeting>>,
}

impl<'a> Copies<'a> {
    pub(super) fn new(
        problem: &'a Problem,
        mesh: &'a Mesh,
        topology: &'a Topology,
        reference: &Reference,
    ) -> Self {
        let cut =
            |s: Side| topology.line[s.triangle][s.corner].is_some_and(|l| problem.condition(l).is_some());
        let (corners, vertex_of) = topology.split(mesh, cut);
        let count = vertex_of.len();
        let mut region = vec![0; count];
        for (copies, t) in corners.iter().zip(&mesh.triangles) {
            for copy in copies {
                region[*copy] = t.region;
            }
        }
        let mut copies = Self {
            problem,
            mesh,
            topology,
            loads: Loads::new(problem, reference),
            corners,
            vertex_of,
            region,
            chain_of: vec![None; count],
            apex: vec![false; count],
            given: vec![Vec::new(); count],
            apexes: vec![Vec::new(); count],
            length: vec![0.0; count],
            meetings: vec![Vec::new(); mesh.lines.len()],
        };
        copies.find_chains();
        copies.find_neighbours();
        copies.find_given();
        copies
    }

    pub(super) fn sides(&self) -> impl Iterator<Item = Side> + use<> {
        (0..self.corners.len()).flat_map(|triangle| (0..3).map(move |corner| Side { triangle, corner }))
    }

    /// Copies at the start and the end of an edge.
    pub(super) fn ends(&self, s: Side) -> (usize, usize) {
        let c = &self.corners[s.triangle];
        (c[(s.corner + 1) % 3], c[(s.corner + 2) % 3])
    }

    pub(super) fn position(&self, copy: usize) -> Point {
        self.mesh.vertices[self.vertex_of[copy]].position
    }

    /// The boundary side that an edge lies on, with its condition.
    pub(super) fn boundary(&self, s: Side) -> Option<(LineUse, Condition)> {
        let line = self.topology.line[s.triangle][s.corner]?;
        let side = LineUse { line: line.line, forward: line.forward };
        Some((side, self.problem.condition_on(side)?))
    }

    /// Where on a line a copy is.
    pub(super) fn fraction(&self, copy: usize, line: usize) -> f64 {
        match self.mesh.vertices[self.vertex_of[copy]].place {
            Place::OnLine { s, .. } => s,
            Place::Corner(point) if point == self.problem.outline.lines[line].to => 1.0,
            _ => 0.0,
        }
    }

    fn find_chains(&mut self) {
        for s in self.sides() {
            let Some((side, condition)) = self.boundary(s).filter(|b| is_loaded(b.1)) else { continue };
            let strengthless = condition == Condition::Free
                && self.problem.statement().surcharge == 0.0
                && self.problem.soils[self.mesh.triangles[s.triangle].region].cohesion.is_zero();
            for copy in <[usize; 2]>::from(self.ends(s)) {
                self.apex[copy] |= strengthless;
                if let Some(run) = self.loads.run(side).filter(|_| self.chain_of[copy].is_none()) {
                    self.chain_of[copy] = Some((run, self.loads.at(side, self.fraction(copy, side.line))));
                }
            }
        }
    }

    fn find_neighbours(&mut self) {
        let mut count = vec![0.0; self.length.len()];
        for s in self.sides() {
            let (a, b) = self.ends(s);
            let (p, q) = (self.position(a), self.position(b));
            for (i, j) in [(a, b), (b, a)] {
                self.length[i] += (p[0] - q[0]).hypot(p[1] - q[1]);
                count[i] += 1.0;
                if self.apex[j] && !self.apexes[i].contains(&j) {
                    self.apexes[i].push(j);
                }
            }
        }
        self.length.iter_mut().zip(count).for_each(|(sum, n)| *sum /= n);
    }

    fn find_given(&mut self) {
        for s in self.sides() {
            let Some((side, _)) = self.boundary(s).filter(|b| shear_is_given(b.1)) else { continue };
            for copy in <[usize; 2]>::from(self.ends(s)) {
                let at = self.fraction(copy, side.line);
                if !self.given[copy].iter().any(|(l, _)| *l == side.line) {
                    self.given[copy].push((side.line, at));
                }
                let meetings = &mut self.meetings[side.line];
                if let Some((chain, _)) = &self.chain_of[copy]
                    && !meetings.iter().any(|m| m.chain == *chain)
                {
                    meetings.push(Meeting { chain: *chain, copy, at });
                }
            }
        }
        for line in &mut self.meetings {
            line.sort_by_key(|m| m.chain);
        }
    }

    /// What is known and unknown at a copy.
    pub(super) fn shape(
        &self,
        copy: usize,
        across: &[Option<Across>],
        chains: &[[Form; 3]],
        program: &mut Program,
    ) -> Shape {
        if let Some((chain, demanded)) = &self.chain_of[copy] {
            return Shape::Chain { chain: *chain, demanded: demanded.clone() };
        }
        let p = self.position(copy);
        let h = self.length[copy];
        let stress = self.problem.stress_scale(self.region[copy], p, h);
        let mut unknown = |scale: f64| Unknown { index: program.unknown(), unit: scale * stress };
        let mut lines: Vec<(&Across, usize, f64)> =
            self.given[copy].iter().filter_map(|(l, s)| across[*l].as_ref().map(|a| (a, *l, *s))).collect();
        // Lines that go on straight say the same.
        lines.dedup_by_key(|l| l.0.group);
        if let Some(&apex) = self.apexes[copy].first() {
            let base = self.chain_of[apex].as_ref().map_or(0, |c| c.0);
            if self.apexes[copy].len() > 1 {
                let upright = lines.iter().all(|(a, ..)| a.n[1] == 0.0);
                let depth = self.problem.statement().datum - p[1];
                return if upright {
                    Shape::ManyApexes { base, f: unknown(h * h), depth }
                } else {
                    Shape::Zero { base }
                };
            }
            let q = self.position(apex);
            let r = [p[0] - q[0], p[1] - q[1]];
            let f = unknown(h * h);
            let turn = match lines.first() {
                None => Turn::Unknown(unknown(h / r[0].hypot(r[1]))),
                Some((a, _, s)) => {
                    let t = turned(r);
                    let [_, gx, gy] = &chains[base];
                    let own = a.at(*s).plus(-a.n[0], gx).plus(-a.n[1], gy);
                    Turn::Given(Form::default().plus(1.0 / (t[0] * a.n[0] + t[1] * a.n[1]), &own))
                }
            };
            return Shape::OneApex { base, apex, r, f, turn };
        }
        let f = unknown(h * h);
        match lines.as_slice() {
            [] => Shape::Free { f, fx: unknown(h), fy: unknown(h) },
            [(a, line, s)] => {
                let along = unknown(h / a.n[0].hypot(a.n[1]));
                Shape::OneLine { line: *line, n: a.n, across: a.at(*s), f, along }
            }
            [(a, _, s), (b, _, t), ..] => {
                Shape::TwoLines { normals: [a.n, b.n], across: [a.at(*s), b.at(*t)], f }
            }
        }
    }
}
