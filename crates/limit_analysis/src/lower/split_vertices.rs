//! Vertices, split where boundaries or branch cuts part the soil, and what the boundary conditions say at each copy.

use soilctl_certificate::{Condition, LineUse, Place, Side};
use soilctl_conic::{Form, Program};

use super::branches::{BranchCuts, Branches, walked};
use super::given::Across;
use super::loads::Loads;
use super::reference::ReferenceStress;
use super::surfaces::{AT_REST, Surfaces, is_bare, numbers};
use super::unknown_jet::{Turn, Unknown, UnknownJet};
use crate::members::{MemberEdge, bears_force, member_edges};
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::vector::{Point, between, distance, turned};

/// Where a gauge meets a line of given shear.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting {
    pub(super) gauge: usize,
    pub(super) copy: usize,
    /// Position on the line, 0 or 1.
    pub(super) at: f64,
}

/// What is gathered about the copies before unknowns are handed out.
pub(super) struct SplitVertices<'a> {
    problem: &'a Problem,
    mesh: &'a Mesh,
    topology: &'a Topology,
    pub(super) loads: Loads,
    /// Copy at each triangle corner.
    pub(super) corners: Vec<[usize; 3]>,
    pub(super) vertex_of: Vec<usize>,
    /// Region of a triangle at each copy.
    region: Vec<usize>,
    /// For copies on free and loaded boundaries, the gauge and what the loads demand.
    pub(super) gauge_of: Vec<Option<(usize, [Form; 3])>>,
    /// SplitVertices at which all stress must vanish.
    pub(super) apex: Vec<bool>,
    /// Lines of given shear through each copy, with the position on them.
    given: Vec<Vec<(usize, f64)>>,
    /// Apexes next to each copy.
    apexes: Vec<Vec<usize>>,
    /// Mean length of the edges at each copy.
    length: Vec<f64>,
    /// For each line of given shear, the gauges that meet it.
    pub(super) meetings: Vec<Vec<Meeting>>,
    pub(super) branches: Branches,
    /// For copies on cuts from bodies to the rim, the gauge that values there are relative to.
    pub(super) branch_of: Vec<Option<usize>>,
    /// For one of the two copies at each vertex of a cut, the other one, which has the same unknowns.
    pub(super) twin_of: Vec<Option<usize>>,
    /// For one of the two copies at each vertex of a member, how it depends on the other one.
    kink_of: Vec<Option<Kink>>,
    /// Copies on both sides of a member next to apexes, where it bears no force.
    is_flat: Vec<bool>,
    /// What the stress function is known to be at surfaces of soil without cohesion.
    pub(super) surfaces: Surfaces,
}

/// How a copy at a member depends on that on the other side.
#[derive(Debug, Clone, Copy)]
struct Kink {
    copy: usize,
    line: usize,
    /// Whether the member may bear a force there.
    bears: bool,
    /// The copy whose jump this one is too, and its sign: along bars to which the soil hands nothing the force is one.
    shares: Option<(usize, f64)>,
}

impl<'a> SplitVertices<'a> {
    pub(super) fn new(
        problem: &'a Problem,
        mesh: &'a Mesh,
        topology: &'a Topology,
        reference: &ReferenceStress,
    ) -> Self {
        let cuts = BranchCuts::new(problem, mesh, topology);
        let cut = |s: Side| {
            let line = topology.line[s.triangle][s.corner];
            let bears = |member: usize| bears_force(&problem.members()[member]);
            line.is_some_and(|l| {
                problem.condition(l).is_some() || problem.member_on(l.line).is_some_and(bears)
            }) || cuts.holds(mesh, s)
        };
        let (corners, vertex_of) = topology.split(mesh, cut);
        let count = vertex_of.len();
        let mut region = vec![0; count];
        for (copies, t) in corners.iter().zip(&mesh.triangles) {
            for copy in copies {
                region[*copy] = t.region;
            }
        }
        let loads = Loads::new(problem, reference);
        let mut copies = Self {
            problem,
            mesh,
            topology,
            loads,
            surfaces: Surfaces::default(),
            corners,
            vertex_of,
            region,
            gauge_of: vec![None; count],
            apex: vec![false; count],
            given: vec![Vec::new(); count],
            apexes: vec![Vec::new(); count],
            length: vec![0.0; count],
            meetings: vec![Vec::new(); mesh.lines.len()],
            branches: Branches::default(),
            branch_of: vec![None; count],
            twin_of: vec![None; count],
            kink_of: vec![None; count],
            is_flat: vec![false; count],
        };
        copies.find_branches(&cuts);
        copies.find_gauges();
        copies.follow(&cuts);
        copies.find_neighbours();
        copies.find_surfaces(reference);
        copies.find_given();
        copies.find_kinks();
        copies.join_free();
        copies
    }

    /// Finds which copies depend on those across members.
    fn find_kinks(&mut self) {
        for e in member_edges(self.problem, self.mesh, self.topology) {
            let m = &self.problem.members()[e.member];
            // What is on one side of a beam does not depend on what is on the other.
            let Some([side, other]) = e.both().filter(|_| m.bending.is_none()) else { continue };
            let ((a, b), (d, c)) = (self.ends(side), self.ends(other));
            for (end, (left, right)) in [(a, c), (b, d)].into_iter().enumerate() {
                let is_done = [left, right].iter().any(|copy| self.kink_of[*copy].is_some());
                let are_given = self.gauge_of[left].is_some() && self.gauge_of[right].is_some();
                if left == right || is_done || are_given {
                    continue;
                }
                if [left, right].iter().all(|copy| !self.apexes[*copy].is_empty()) {
                    (self.is_flat[left], self.is_flat[right]) = (true, true);
                    continue;
                }
                let is_known = |copy: usize| {
                    self.gauge_of[copy].is_some()
                        || !self.apexes[copy].is_empty()
                        || !self.given[copy].is_empty()
                };
                let (copy, own) =
                    if is_known(right) && !is_known(left) { (right, left) } else { (left, right) };
                let bears = !e.is_end[end] || m.attached[end];
                self.kink_of[own] = Some(Kink { copy, line: e.line, bears, shares: None });
                self.surfaces.of_copy[own] = self.surfaces.of_copy[copy];
            }
        }
    }

    /// Makes the force of bars one number from end to end of where the soil hands them nothing: zero, if it is so anywhere there.
    fn join_free(&mut self) {
        let edges = member_edges(self.problem, self.mesh, self.topology);
        let mut run: Vec<Option<(usize, bool)>> = Vec::new();
        for (i, e) in edges.iter().enumerate() {
            if !self.is_free(e) {
                continue;
            }
            let Some([side, other]) = e.both() else { continue };
            let ((a, b), (d, c)) = (self.ends(side), self.ends(other));
            for (left, right) in [(a, c), (b, d)] {
                let depends = |own: usize, copy: usize| self.kink_of[own].is_some_and(|k| k.copy == copy);
                let on_left = depends(left, right).then_some((left, true));
                run.push(on_left.or_else(|| depends(right, left).then_some((right, false))));
            }
            let goes_on = |next: &MemberEdge| next.member == e.member && self.is_free(next);
            if !edges.get(i + 1).is_some_and(goes_on) {
                self.join(&std::mem::take(&mut run));
            }
        }
    }

    /// Whether the soil hands nothing to bars along an edge.
    pub(super) fn is_free(&self, edge: &MemberEdge) -> bool {
        bears_force(&self.problem.members()[edge.member]) && edge.is_free(self.problem, self.mesh)
    }

    fn join(&mut self, run: &[Option<(usize, bool)>]) {
        let kinks: Vec<(usize, bool)> = run.iter().copied().flatten().collect();
        let bears = |(own, _): &(usize, bool)| self.kink_of[*own].is_some_and(|kink| kink.bears);
        let is_one = kinks.len() == run.len() && kinks.iter().all(bears);
        // Unknowns are handed out in the order of copies.
        let Some(&(first, is_left)) = kinks.iter().min() else { return };
        let Some(line) = self.kink_of[first].map(|kink| kink.line) else { return };
        for (own, on_left) in kinks {
            let Some(kink) = &mut self.kink_of[own] else { continue };
            kink.bears = is_one;
            if is_one {
                kink.line = line;
                kink.shares = (own != first).then_some((first, if on_left == is_left { 1.0 } else { -1.0 }));
            }
        }
    }

    pub(super) fn sides(&self) -> impl Iterator<Item = Side> + use<> {
        (0..self.corners.len()).flat_map(|triangle| (0..3).map(move |corner| Side { triangle, corner }))
    }

    /// SplitVertices at the start and the end of an edge.
    pub(super) fn ends(&self, s: Side) -> (usize, usize) {
        let c = &self.corners[s.triangle];
        (c[(s.corner + 1) % 3], c[(s.corner + 2) % 3])
    }

    pub(super) fn position(&self, copy: usize) -> Point {
        self.mesh.vertices[self.vertex_of[copy]].position
    }

    /// The boundary side that an edge lies on, with its condition.
    pub(super) fn boundary(&self, s: Side) -> Option<(LineUse, Condition)> {
        let side = self.topology.line[s.triangle][s.corner]?;
        Some((side, self.problem.condition(side)?))
    }

    /// Where on a line a copy is.
    pub(super) fn fraction(&self, copy: usize, line: usize) -> f64 {
        match self.mesh.vertices[self.vertex_of[copy]].place {
            Place::OnLine { s, .. } => s,
            Place::Corner { point } if point == self.problem.statement().lines[line].to => 1.0,
            _ => 0.0,
        }
    }

    /// Finds on which runs cuts end, and where.
    fn find_branches(&mut self, cuts: &BranchCuts) {
        let mut on_runs = Vec::new();
        for (number, cut) in cuts.all.iter().enumerate() {
            let at = self.sides().find_map(|s| {
                let (side, _) = self.boundary(s)?;
                let run = self.loads.run(side)?;
                let end = self.ends(s).1;
                let sides = &self.loads.runs[run].sides;
                let place = sides.iter().position(|other| *other == side)?;
                let here = self.vertex_of[end] == cut[0];
                here.then(|| (run, (place, walked(side, self.fraction(end, side.line))), number))
            });
            on_runs.extend(at);
        }
        self.branches = Branches::new(self.loads.runs.len(), cuts.all.len(), on_runs);
    }

    /// Goes along the cuts and finds which copies are on which side of them.
    fn follow(&mut self, cuts: &BranchCuts) {
        for (number, cut) in cuts.all.iter().enumerate() {
            for (i, step) in cut.windows(2).enumerate() {
                let on_step = |s: &Side| {
                    let (a, b) = self.ends(*s);
                    let ends = [self.vertex_of[a], self.vertex_of[b]];
                    ends == [step[0], step[1]] || ends == [step[1], step[0]]
                };
                let sides: Vec<Side> = self.sides().filter(on_step).collect();
                let mut pairs: Vec<[usize; 2]> = sides
                    .iter()
                    .map(|s| {
                        let (a, b) = self.ends(*s);
                        if self.vertex_of[a] == step[0] { [a, b] } else { [b, a] }
                    })
                    .collect();
                if i == 0 {
                    let gauge = |copy: usize| self.gauge_of[copy].as_ref().map(|c| c.0);
                    let [low, high] = self.branches.around(number);
                    for (pair, else_gauge) in pairs.iter().zip([low, high]) {
                        self.branch_of[pair[0]] = gauge(pair[0]).or(Some(else_gauge));
                    }
                }
                pairs.sort_by_key(|p| self.branch_of[p[0]]);
                if let [[a, b], [c, d]] = pairs[..] {
                    (self.branch_of[b], self.branch_of[d]) = (self.branch_of[a], self.branch_of[c]);
                    (self.twin_of[c], self.twin_of[d]) = (Some(a), Some(b));
                }
            }
        }
    }

    fn find_gauges(&mut self) {
        for s in self.sides() {
            let Some((side, _)) = self.boundary(s).filter(|b| b.1.traction_is_given()) else { continue };
            let strengthless = is_bare(self.problem, side);
            let ends = <[usize; 2]>::from(self.ends(s));
            let middle = 0.5 * ends.map(|c| walked(side, self.fraction(c, side.line))).iter().sum::<f64>();
            let sides = self.loads.run(side).map(|run| &self.loads.runs[run].sides);
            let place = sides.and_then(|sides| sides.iter().position(|other| *other == side)).unwrap_or(0);
            for copy in ends {
                self.apex[copy] |= strengthless;
                if let Some(run) = self.loads.run(side).filter(|_| self.gauge_of[copy].is_none()) {
                    let gauge = self.branches.gauge(run, (place, middle));
                    self.gauge_of[copy] = Some((gauge, self.loads.at(side, self.fraction(copy, side.line))));
                }
            }
        }
    }

    fn find_surfaces(&mut self, reference: &ReferenceStress) {
        let numbers = numbers(self.problem, &self.loads);
        let mut at: Vec<Vec<usize>> = vec![Vec::new(); self.apex.len()];
        for s in self.sides() {
            let Some((side, _)) = self.boundary(s).filter(|b| b.1.traction_is_given()) else { continue };
            for copy in <[usize; 2]>::from(self.ends(s)).into_iter().filter(|copy| self.apex[*copy]) {
                let along = walked(side, self.fraction(copy, side.line));
                for there in self.loads.sides_at(side, along == 0.0, along == 1.0) {
                    let number = numbers.iter().find(|(side, _)| *side == there).map(|n| n.1);
                    if let Some(number) = number.filter(|number| !at[copy].contains(number)) {
                        at[copy].push(number);
                    }
                }
            }
        }
        let loads = &self.loads;
        self.surfaces =
            Surfaces::new(self.problem, reference, loads, &numbers, &self.corners, &at, &self.twin_of);
        // What a run demands is demanded in full.
        for (copy, gauge) in self.gauge_of.iter().enumerate() {
            if gauge.is_some() {
                self.surfaces.of_copy[copy] = AT_REST;
            }
        }
    }

    fn find_neighbours(&mut self) {
        let mut count = vec![0.0; self.length.len()];
        for s in self.sides() {
            let (a, b) = self.ends(s);
            let (p, q) = (self.position(a), self.position(b));
            for (i, j) in [(a, b), (b, a)] {
                self.length[i] += distance(p, q);
                count[i] += 1.0;
                if self.apex[j] && !self.apexes[i].contains(&j) {
                    self.apexes[i].push(j);
                }
            }
        }
        self.length.iter_mut().zip(count).for_each(|(sum, n)| *sum /= n);
        // What is next to an apex on one side of a cut is so on the other one too.
        for (copy, twin) in self.twin_of.iter().enumerate() {
            let Some(twin) = *twin else { continue };
            for apex in self.apexes[copy].clone() {
                let known = |other: &usize| self.vertex_of[*other] == self.vertex_of[apex];
                if !self.apexes[twin].iter().any(known) {
                    self.apexes[twin].push(apex);
                }
            }
        }
    }

    fn find_given(&mut self) {
        for s in self.sides() {
            let Some((side, _)) = self.boundary(s).filter(|b| b.1.shear_is_given()) else { continue };
            for copy in <[usize; 2]>::from(self.ends(s)) {
                let at = self.fraction(copy, side.line);
                if !self.given[copy].iter().any(|(l, _)| *l == side.line) {
                    self.given[copy].push((side.line, at));
                }
                let meetings = &mut self.meetings[side.line];
                if let Some((gauge, _)) = &self.gauge_of[copy]
                    && !meetings.iter().any(|m| m.gauge == *gauge)
                {
                    meetings.push(Meeting { gauge: *gauge, copy, at });
                }
            }
        }
        for line in &mut self.meetings {
            line.sort_by_key(|m| m.gauge);
        }
    }

    /// What is known and unknown at all copies.
    pub(super) fn shapes(
        &self,
        across: &[Option<Across>],
        gauges: &[[Form; 3]],
        program: &mut Program,
    ) -> Vec<UnknownJet> {
        let mut shapes: Vec<UnknownJet> = (0..self.vertex_of.len())
            .map(|copy| match self.twin_of[copy] {
                None if self.kink_of[copy].is_none() => self.shape(copy, across, gauges, program),
                _ => UnknownJet::Zero { base: 0 },
            })
            .collect();
        for (own, kink) in self.kink_of.iter().enumerate() {
            let Some(Kink { copy, line, bears, shares }) = *kink else { continue };
            let n = turned(self.along_line(line));
            let h = self.length[own];
            let stress = self.problem.stress_scale(self.region[own], self.position(own), h);
            let unit = h * stress / n[0].hypot(n[1]);
            let shared = shares.and_then(|(first, sign)| match &shapes[first] {
                UnknownJet::Kinked { jump: Some(jump), .. } => {
                    Some(Unknown { unit: sign * jump.unit, ..*jump })
                }
                _ => None,
            });
            let jump = shared.or_else(|| bears.then(|| Unknown { index: program.unknown(), unit }));
            let (base, beyond) = (shapes[copy].base(), shapes[copy].jet());
            shapes[own] = UnknownJet::Kinked { copy, base, beyond, line, n, jump };
        }
        for (copy, twin) in self.twin_of.iter().enumerate() {
            let (Some(twin), Some(base)) = (*twin, self.branch_of[copy]) else { continue };
            let vertex = |apex: usize| self.vertex_of[apex];
            let same =
                |apex: usize| self.apexes[copy].iter().copied().find(|own| vertex(*own) == vertex(apex));
            shapes[copy] = shapes[twin].on(base, same);
        }
        shapes
    }

    /// Whether the slope across a line may jump.
    pub(super) fn is_kinked_along(&self, line: usize) -> bool {
        self.problem.member_on(line).is_some_and(|member| bears_force(&self.problem.members()[member]))
    }

    fn along_line(&self, line: usize) -> Point {
        let [p, q] = self.problem.ends(line);
        between(p, q)
    }

    /// The gauge that values along an edge of a cut are relative to.
    pub(super) fn cut(&self, s: Side) -> Option<usize> {
        let other = self.topology.across[s.triangle][s.corner]?;
        let ((a, b), (d, c)) = (self.ends(s), self.ends(other));
        ((a, b) != (c, d)).then_some(self.branch_of[a]).flatten()
    }

    /// What is known and unknown at a copy.
    fn shape(
        &self,
        copy: usize,
        across: &[Option<Across>],
        gauges: &[[Form; 3]],
        program: &mut Program,
    ) -> UnknownJet {
        if let Some((gauge, demanded)) = &self.gauge_of[copy] {
            return UnknownJet::Gauge { gauge: *gauge, demanded: demanded.clone() };
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
            let base = self.gauge_of[apex].as_ref().map_or(0, |c| c.0);
            if self.is_flat[copy] {
                return UnknownJet::Zero { base };
            }
            if self.apexes[copy].len() > 1 {
                let upright = lines.iter().all(|(a, ..)| a.n[1] == 0.0);
                let up = ([0.0, 1.0], p[1] - self.problem.statement().datum);
                let (n, away) = self.surfaces.away(copy, p).unwrap_or(up);
                return if upright && (lines.is_empty() || n[0] == 0.0) {
                    UnknownJet::ManyApexes { base, f: unknown(h * h), n, away }
                } else {
                    UnknownJet::Zero { base }
                };
            }
            let q = self.position(apex);
            let r = between(q, p);
            let f = unknown(h * h);
            let turn = match lines.first() {
                None => Turn::Unknown(unknown(h / r[0].hypot(r[1]))),
                Some((a, _, s)) => {
                    let t = turned(r);
                    let [_, gx, gy] = &gauges[base];
                    let mut own = a.at(*s).plus(-a.n[0], gx).plus(-a.n[1], gy);
                    if let Some([_, qx, qy]) = self.surfaces.jet(self.surfaces.of_copy[copy], p) {
                        own = own.plus(-a.n[0], &qx).plus(-a.n[1], &qy);
                    }
                    Turn::Given(Form::default().plus(1.0 / (t[0] * a.n[0] + t[1] * a.n[1]), &own))
                }
            };
            return UnknownJet::OneApex { base, apex, r, f, turn };
        }
        let f = unknown(h * h);
        match lines.as_slice() {
            [] => {
                let base = self.branch_of[copy].unwrap_or(0);
                UnknownJet::Free { base, f, fx: unknown(h), fy: unknown(h) }
            }
            [(a, line, s)] => {
                let along = unknown(h / a.n[0].hypot(a.n[1]));
                UnknownJet::OneLine { line: *line, n: a.n, across: a.at(*s), f, along }
            }
            [(a, _, s), (b, _, t), ..] => {
                UnknownJet::TwoLines { normals: [a.n, b.n], across: [a.at(*s), b.at(*t)], f }
            }
        }
    }
}
