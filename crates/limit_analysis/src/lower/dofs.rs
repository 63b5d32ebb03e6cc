//! The stress function of a problem on a mesh: its unknowns, with the boundary conditions built in.

use soilctl_certificate::{Chain, Condition, Gradient, LineUse, LowerField, VertexCopy};

use super::given::{Across, Touching, shear_is_given, slopes_across};
use super::loads::{self, Loads, is_loaded};
use super::macro_element::turned;
use super::reference::Reference;
use super::shape::{Shape, Turn, Unknown};
use crate::form::Form;
use crate::mesh::{Mesh, Place};
use crate::problem::Problem;
use crate::program::Program;
use crate::topology::{Side, Topology};

type Point = [f64; 2];

/// The unknown stress function.
#[derive(Debug)]
pub(crate) struct StressFunction {
    /// Vertex copy at each triangle corner; copies are separated by boundaries only.
    pub(crate) corners: Vec<[usize; 3]>,
    vertex_of: Vec<usize>,
    shapes: Vec<Shape>,
    jets: Vec<[Form; 3]>,
    /// Copies at which all stress vanishes.
    pub(crate) apex: Vec<bool>,
    /// The slope across the middle of each triangle edge along the turned edge vector, apart from the affine function
    /// of the chain named.
    slopes: Vec<[(usize, Form); 3]>,
    /// Affine function of each chain of free boundary as constant and gradient; the first is zero.
    chains: Vec<[Form; 3]>,
    gradients: Vec<Slopes>,
    across: Vec<Option<Across>>,
    /// Stress along level far lines, beyond the reference.
    pub(crate) far_stress: Option<usize>,
    /// The factor that is bounded.
    multiplier: Option<usize>,
}

/// How a chain's gradient is stored.
#[derive(Debug, Clone, Copy)]
enum Slopes {
    Zero,
    Free,
    Along { line: usize, unit: f64 },
}

/// What is gathered about the copies before unknowns are handed out.
struct Copies<'a> {
    problem: &'a Problem,
    mesh: &'a Mesh,
    vertex_of: &'a [usize],
    /// Region of a triangle at each copy.
    region: &'a [usize],
    /// For copies on free and loaded boundaries, the chain and what the loads demand.
    chain_of: &'a [Option<(usize, [Form; 3])>],
    /// Lines of given shear through each copy, with the position on them.
    given: Vec<Vec<(usize, f64)>>,
    /// Apexes next to each copy.
    apexes: Vec<Vec<usize>>,
    /// Mean length of the edges at each copy.
    length: Vec<f64>,
}

impl Copies<'_> {
    fn position(&self, copy: usize) -> Point {
        self.mesh.vertices[self.vertex_of[copy]].position
    }

    fn shape(
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

impl StressFunction {
    pub(crate) fn new(
        problem: &Problem,
        mesh: &Mesh,
        topology: &Topology,
        reference: &Reference,
        program: &mut Program,
    ) -> Self {
        let condition = |s: Side| topology.line[s.triangle][s.corner].and_then(|l| problem.condition(l));
        let (corners, vertex_of) = topology.split(mesh, |s| condition(s).is_some());
        let count = vertex_of.len();
        let sides =
            || (0..mesh.triangles.len()).flat_map(|t| (0..3).map(move |k| Side { triangle: t, corner: k }));
        let ends =
            |s: Side| (corners[s.triangle][(s.corner + 1) % 3], corners[s.triangle][(s.corner + 2) % 3]);
        let position = |copy: usize| mesh.vertices[vertex_of[copy]].position;

        let loads = Loads::new(problem, reference);
        let mut region = vec![0; count];
        for (triangle, t) in mesh.triangles.iter().enumerate() {
            for copy in corners[triangle] {
                region[copy] = t.region;
            }
        }
        // Where on a line a copy is.
        let fraction = |copy: usize, line: usize| match mesh.vertices[vertex_of[copy]].place {
            Place::OnLine { s, .. } => s,
            Place::Corner(point) if point == problem.outline.lines[line].to => 1.0,
            _ => 0.0,
        };
        let mut chain_of: Vec<Option<(usize, [Form; 3])>> = vec![None; count];
        let mut apex = vec![false; count];
        for s in sides() {
            let Some(c) = condition(s).filter(|c| is_loaded(*c)) else { continue };
            let Some(use_) = topology.line[s.triangle][s.corner] else { continue };
            let side = LineUse { line: use_.line, forward: use_.forward };
            let strengthless = c == Condition::Free
                && problem.statement().surcharge == 0.0
                && problem.soils[mesh.triangles[s.triangle].region].cohesion.is_zero();
            for copy in <[usize; 2]>::from(ends(s)) {
                apex[copy] |= strengthless;
                if chain_of[copy].is_none()
                    && let Some(run) = loads.run(side)
                {
                    chain_of[copy] = Some((run, loads.at(side, fraction(copy, side.line))));
                }
            }
        }
        let chain_count = loads.runs.len().max(1);

        let mut touching: Vec<Vec<(usize, usize, f64)>> = vec![Vec::new(); mesh.lines.len()];
        let mut given: Vec<Vec<(usize, f64)>> = vec![Vec::new(); count];
        let mut apexes: Vec<Vec<usize>> = vec![Vec::new(); count];
        let mut length = vec![(0.0, 0.0); count];
        for s in sides() {
            let (a, b) = ends(s);
            let (p, q) = (position(a), position(b));
            for (i, j) in [(a, b), (b, a)] {
                length[i].0 += (p[0] - q[0]).hypot(p[1] - q[1]);
                length[i].1 += 1.0;
                if apex[j] && !apexes[i].contains(&j) {
                    apexes[i].push(j);
                }
            }
            let Some(side) = topology.line[s.triangle][s.corner] else { continue };
            if !condition(s).is_some_and(shear_is_given) {
                continue;
            }
            let line = &mut touching[side.line];
            for copy in [a, b] {
                let at = fraction(copy, side.line);
                if !given[copy].iter().any(|(l, _)| *l == side.line) {
                    given[copy].push((side.line, at));
                }
                if let Some((chain, _)) = &chain_of[copy]
                    && !line.iter().any(|(k, ..)| k == chain)
                {
                    line.push((*chain, copy, at));
                }
            }
        }
        for line in &mut touching {
            line.sort_by_key(|c| c.0);
        }

        // A smooth line that joins two chains carries no force along itself: the second chain's gradient is along it.
        let mut chains: Vec<[Form; 3]> = Vec::new();
        let mut gradients = Vec::new();
        for chain in 0..chain_count {
            if chain == 0 {
                chains.push([Form::default(), Form::default(), Form::default()]);
                gradients.push(Slopes::Zero);
                continue;
            }
            let constant = Form::unknown(program.unknown(), 1.0);
            let joined = touching.iter().position(|t| t.len() > 1 && t[1..].iter().any(|c| c.0 == chain));
            if let Some(line) = joined {
                let [p, q] = problem.ends(line);
                let u = program.unknown();
                let unit = 1.0 / (p[0] - q[0]).hypot(p[1] - q[1]);
                chains.push([
                    constant,
                    Form::unknown(u, unit * (q[0] - p[0])),
                    Form::unknown(u, unit * (q[1] - p[1])),
                ]);
                gradients.push(Slopes::Along { line, unit });
            } else {
                chains.push([
                    constant,
                    Form::unknown(program.unknown(), 1.0),
                    Form::unknown(program.unknown(), 1.0),
                ]);
                gradients.push(Slopes::Free);
            }
        }
        let slopes_at = |chain: usize, copy: usize| -> [Form; 2] {
            let demanded = chain_of[copy].as_ref().map(|c| &c.1);
            std::array::from_fn(|i| {
                let affine = chains[chain][1 + i].clone();
                demanded.map_or(affine.clone(), |d| affine.plus(1.0, &d[1 + i]))
            })
        };
        let touching: Touching = touching
            .iter()
            .map(|line| {
                line.iter().map(|(chain, copy, at)| (*chain, slopes_at(*chain, *copy), *at)).collect()
            })
            .collect();
        let across = slopes_across(problem, reference, &touching, program);
        let copies = Copies {
            problem,
            mesh,
            vertex_of: &vertex_of,
            region: &region,
            chain_of: &chain_of,
            given,
            apexes,
            length: length.iter().map(|(sum, n)| sum / n).collect(),
        };
        let shapes: Vec<Shape> =
            (0..count).map(|copy| copies.shape(copy, &across, &chains, program)).collect();

        let mut slopes: Vec<[(usize, Form); 3]> =
            (0..mesh.triangles.len()).map(|_| std::array::from_fn(|_| (0, Form::default()))).collect();
        for s in sides() {
            let (a, b) = ends(s);
            let (p, q) = (position(a), position(b));
            let l = (p[0] - q[0]).hypot(p[1] - q[1]);
            let middle = [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            let scale = problem.stress_scale(mesh.triangles[s.triangle].region, middle, l);
            let mut own = || Form::unknown(program.unknown(), l * l * scale);
            slopes[s.triangle][s.corner] = match condition(s) {
                _ if apex[a] || apex[b] => continue,
                Some(c) if is_loaded(c) => {
                    let Some(u) = topology.line[s.triangle][s.corner] else { continue };
                    let at = (fraction(a, u.line) + fraction(b, u.line)) / 2.0;
                    let demanded = loads.at(LineUse { line: u.line, forward: u.forward }, at);
                    let run = chain_of[a].as_ref().map_or(0, |c| c.0);
                    (run, loads::across([q[0] - p[0], q[1] - p[1]], &demanded))
                }
                Some(c) if shear_is_given(c) => {
                    let Some(side) = topology.line[s.triangle][s.corner] else { continue };
                    let Some(line) = &across[side.line] else { continue };
                    let at =
                        |c: usize| copies.given[c].iter().find(|(l, _)| *l == side.line).map_or(0.0, |g| g.1);
                    let (sa, sb) = (at(a), at(b));
                    (0, Form::default().plus(sb - sa, &line.at((sa + sb) / 2.0)))
                }
                Some(_) => (0, own()),
                None => {
                    let Some(other) = topology.across[s.triangle][s.corner] else { continue };
                    if (other.triangle, other.corner) < (s.triangle, s.corner) {
                        let (base, form) = &slopes[other.triangle][other.corner];
                        (*base, Form::default().plus(-1.0, form))
                    } else {
                        (0, own())
                    }
                }
            };
        }
        let far = problem.statement().boundaries.iter().any(|b| b.condition == Condition::Far);
        let far_stress = far.then(|| program.unknown());
        let jets = shapes.iter().map(Shape::jet).collect();
        Self {
            corners,
            vertex_of,
            shapes,
            jets,
            apex,
            slopes,
            chains,
            gradients,
            across,
            far_stress,
            multiplier: reference.multiplier,
        }
    }

    /// The affine function of a chain at a point: value and slopes.
    fn affine(&self, chain: usize, p: Point) -> [Form; 3] {
        let [c, gx, gy] = &self.chains[chain];
        [c.clone().plus(p[0], gx).plus(p[1], gy), gx.clone(), gy.clone()]
    }

    /// Slopes at a triangle corner, in full.
    pub(crate) fn gradient(&self, triangle: usize, corner: usize) -> [Form; 2] {
        let copy = self.corners[triangle][corner];
        let [_, gx, gy] = &self.chains[self.shapes[copy].base()];
        let [_, fx, fy] = &self.jets[copy];
        [fx.clone().plus(1.0, gx), fy.clone().plus(1.0, gy)]
    }

    /// The twelve local values of a triangle's element, up to an affine function.
    pub(crate) fn local(&self, triangle: usize, corners: &[Point; 3]) -> [Form; 12] {
        let copies = self.corners[triangle];
        let frame = copies.iter().map(|c| self.shapes[*c].base()).find(|b| *b != 0).unwrap_or(0);
        let mut local: [Form; 12] = std::array::from_fn(|_| Form::default());
        let shift = |base: usize, p: Point| -> Option<[Form; 3]> {
            (base != frame).then(|| {
                let (to, from) = (self.affine(base, p), self.affine(frame, p));
                std::array::from_fn(|i| to[i].clone().plus(-1.0, &from[i]))
            })
        };
        for k in 0..3 {
            let moved = shift(self.shapes[copies[k]].base(), corners[k]);
            for i in 0..3 {
                local[3 * k + i] = self.jets[copies[k]][i].clone();
                if let Some(moved) = &moved {
                    local[3 * k + i].add(1.0, &moved[i]);
                }
            }
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            if self.apex[copies[a]] || self.apex[copies[b]] {
                continue;
            }
            let (base, form) = &self.slopes[triangle][k];
            local[9 + k] = form.clone();
            if let Some(moved) = shift(*base, corners[a]) {
                let n = turned([corners[b][0] - corners[a][0], corners[b][1] - corners[a][1]]);
                local[9 + k].add(n[0], &moved[1]);
                local[9 + k].add(n[1], &moved[2]);
            }
        }
        local
    }

    /// The stress function of a solution, as a certificate stores it.
    pub(crate) fn saved(&self, mesh: &Mesh, topology: &Topology, problem: &Problem, x: &[f64]) -> LowerField {
        let gradient = |chain: usize| match self.gradients[chain] {
            Slopes::Zero => Gradient::Free { x: 0.0, y: 0.0 },
            Slopes::Free => {
                Gradient::Free { x: self.chains[chain][1].value(x), y: self.chains[chain][2].value(x) }
            }
            Slopes::Along { line, unit } => {
                // The unknown behind the gradient, along the line's own vector.
                let u = self.chains[chain].iter().skip(1).find_map(|f| f.terms.first().map(|t| t.0));
                Gradient::Along { line, value: u.map_or(0.0, |u| unit * x[u]) }
            }
        };
        let slopes = (0..mesh.triangles.len())
            .map(|triangle| {
                std::array::from_fn(|k| {
                    let condition = topology.line[triangle][k].and_then(|l| problem.condition(l));
                    let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                    let apex = self.apex[self.corners[triangle][a]] || self.apex[self.corners[triangle][b]];
                    let known = condition.is_some_and(|c| is_loaded(c) || shear_is_given(c));
                    if apex || known { 0.0 } else { self.slopes[triangle][k].1.value(x) }
                })
            })
            .collect();
        LowerField {
            mesh: crate::saved_mesh(mesh),
            corners: self.corners.clone(),
            copies: self
                .vertex_of
                .iter()
                .zip(&self.shapes)
                .map(|(vertex, shape)| VertexCopy { vertex: *vertex, jet: shape.saved(x) })
                .collect(),
            chains: (0..self.chains.len())
                .map(|c| Chain { constant: self.chains[c][0].value(x), gradient: gradient(c) })
                .collect(),
            lines: self
                .across
                .iter()
                .map(|a| a.as_ref().and_then(|a| a.free).map_or(0.0, |u| u.value(x)))
                .collect(),
            slopes,
            far_stress: self.far_stress.map_or(0.0, |u| x[u]),
            multiplier: self.multiplier.map_or(0.0, |u| x[u]),
        }
    }
}
