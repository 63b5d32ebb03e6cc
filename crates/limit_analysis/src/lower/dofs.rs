//! The Airy stress function of a problem on a mesh: its unknowns, with the static boundary conditions built in.

use std::collections::BTreeMap;

use soilctl_certificate::{Condition, Gauge, Gradient, LineUse, LowerField, Side, VertexCopy};
use soilctl_conic::{Form, Program};

use super::given::{Across, Touching, slopes_across};
use super::loads::{self, Loads};
use super::reference::ReferenceStress;
use super::split_vertices::{Meeting, SplitVertices};
use super::surfaces::Surfaces;
use super::unknown_jet::UnknownJet;
use crate::members::{MemberEdge, member_edges};
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::vector::{Point, between, distance, midpoint, turned};

/// The unknown stress function.
#[derive(Debug)]
pub(crate) struct StressFunction {
    /// Vertex copy at each triangle corner; copies are separated by boundaries only.
    pub(crate) corners: Vec<[usize; 3]>,
    vertex_of: Vec<usize>,
    shapes: Vec<UnknownJet>,
    jets: Vec<[Form; 3]>,
    /// SplitVertices at which all stress vanishes.
    pub(crate) apex: Vec<bool>,
    pub(crate) surfaces: Surfaces,
    loads: Loads,
    /// The slope across the middle of each triangle edge along the turned edge vector, apart from the affine function
    /// of the gauge named.
    slopes: Vec<[(usize, Form); 3]>,
    /// Affine function of each gauge of free boundary as constant and gradient; the first is zero.
    gauges: Vec<[Form; 3]>,
    gradients: Vec<Slopes>,
    across: Vec<Option<Across>>,
    /// Stress along level far lines, beyond the reference.
    pub(crate) far_stress: Option<usize>,
    /// The factor that is bounded.
    multiplier: Option<usize>,
}

/// How a gauge's gradient is stored.
#[derive(Debug, Clone, Copy)]
enum Slopes {
    Zero,
    Free,
    Along { line: usize, unit: f64 },
}

/// Affine functions of the gauges, and how their gradients are stored.
fn gauges(problem: &Problem, copies: &SplitVertices, program: &mut Program) -> (Vec<[Form; 3]>, Vec<Slopes>) {
    // A smooth line that joins two gauges carries no force along itself: the second gauge's gradient is along it.
    let mut gauges: Vec<[Form; 3]> = Vec::new();
    let mut gradients = Vec::new();
    for gauge in 0..copies.branches.gauges() {
        if gauge == 0 {
            gauges.push([Form::default(), Form::default(), Form::default()]);
            gradients.push(Slopes::Zero);
            continue;
        }
        let constant = Form::unknown(program.unknown(), 1.0);
        let joined =
            copies.meetings.iter().position(|m| m.len() > 1 && m[1..].iter().any(|m| m.gauge == gauge));
        if let Some(line) = joined {
            let [p, q] = problem.ends(line);
            let u = program.unknown();
            let unit = 1.0 / distance(p, q);
            gauges.push([
                constant,
                Form::unknown(u, unit * (q[0] - p[0])),
                Form::unknown(u, unit * (q[1] - p[1])),
            ]);
            gradients.push(Slopes::Along { line, unit });
        } else {
            gauges.push([
                constant,
                Form::unknown(program.unknown(), 1.0),
                Form::unknown(program.unknown(), 1.0),
            ]);
            gradients.push(Slopes::Free);
        }
    }
    (gauges, gradients)
}

/// The edges on both sides of bars to which the soil hands nothing there, with the axial force times the length of the edge, by which
/// the slopes across both add up.
fn free_edges(
    problem: &Problem,
    mesh: &Mesh,
    topology: &Topology,
    copies: &SplitVertices,
    jets: &[[Form; 3]],
) -> BTreeMap<Side, Form> {
    let mut free = BTreeMap::new();
    for edge in member_edges(problem, mesh, topology).into_iter().filter(|edge| copies.is_free(edge)) {
        let Some([side, other]) = edge.both() else { continue };
        let force = kink(&edge, jets, copies.ends(side).0, copies.ends(other).1);
        let force = Form::default().plus(edge.length(), &force);
        free.insert(side, force.clone());
        free.insert(other, force);
    }
    free
}

/// What the slope to the left of a member is more on its left, at a copy there and one on its right.
fn kink(edge: &MemberEdge, jets: &[[Form; 3]], left: usize, right: usize) -> Form {
    if left == right {
        return Form::default();
    }
    let t = edge.along();
    let difference = |i: usize| jets[left][i].clone().plus(-1.0, &jets[right][i]);
    let force = Form::default().plus(-t[1], &difference(1)).plus(t[0], &difference(2));
    // What is the same on both sides leaves nothing behind.
    let terms = force.terms.into_iter().filter(|(_, c)| c.abs() > 0.0).collect();
    Form { terms, ..force }
}

/// The slope across the middle of each edge.
fn slopes(
    problem: &Problem,
    mesh: &Mesh,
    topology: &Topology,
    copies: &SplitVertices,
    across: &[Option<Across>],
    free: &BTreeMap<Side, Form>,
    program: &mut Program,
) -> Vec<[(usize, Form); 3]> {
    let mut slopes: Vec<[(usize, Form); 3]> =
        (0..mesh.triangles.len()).map(|_| std::array::from_fn(|_| (0, Form::default()))).collect();
    for s in copies.sides() {
        let (a, b) = copies.ends(s);
        let (p, q) = (copies.position(a), copies.position(b));
        let l = distance(p, q);
        let middle = [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
        let scale = problem.stress_scale(mesh.triangles[s.triangle].region, middle, l);
        let mut own = || Form::unknown(program.unknown(), l * l * scale);
        slopes[s.triangle][s.corner] = match copies.boundary(s) {
            _ if copies.apex[a] || copies.apex[b] => continue,
            Some((side, c)) if c.traction_is_given() => {
                let at = (copies.fraction(a, side.line) + copies.fraction(b, side.line)) / 2.0;
                let gauge = copies.gauge_of[a].as_ref().map_or(0, |c| c.0);
                (gauge, loads::across(between(p, q), &copies.loads.at(side, at)))
            }
            Some((side, c)) if c.shear_is_given() => {
                let Some(line) = &across[side.line] else { continue };
                let (sa, sb) = (copies.fraction(a, side.line), copies.fraction(b, side.line));
                (0, Form::default().plus(sb - sa, &line.at((sa + sb) / 2.0)))
            }
            Some(_) => (0, own()),
            None => {
                let Some(other) = topology.across[s.triangle][s.corner] else { continue };
                if topology.line[s.triangle][s.corner].is_some_and(|l| copies.is_kinked_along(l.line)) {
                    let is_second = (other.triangle, other.corner) < (s.triangle, s.corner);
                    slopes[s.triangle][s.corner] = match free.get(&s).filter(|_| is_second) {
                        Some(force) => (0, force.clone().plus(-1.0, &slopes[other.triangle][other.corner].1)),
                        None => (0, own()),
                    };
                    continue;
                }
                let base = copies.cut(s).unwrap_or(0);
                if (other.triangle, other.corner) < (s.triangle, s.corner) {
                    let (_, form) = &slopes[other.triangle][other.corner];
                    (base, Form::default().plus(-1.0, form))
                } else {
                    (base, own())
                }
            }
        };
    }
    slopes
}

impl StressFunction {
    pub(crate) fn new(
        problem: &Problem,
        mesh: &Mesh,
        topology: &Topology,
        reference: &ReferenceStress,
        program: &mut Program,
    ) -> Self {
        let copies = SplitVertices::new(problem, mesh, topology, reference);
        let (gauges, gradients) = gauges(problem, &copies, program);
        let slopes_at = |m: &Meeting| -> [Form; 2] {
            let demanded = copies.gauge_of[m.copy].as_ref().map(|c| &c.1);
            std::array::from_fn(|i| {
                let affine = gauges[m.gauge][1 + i].clone();
                demanded.map_or(affine.clone(), |d| affine.plus(1.0, &d[1 + i]))
            })
        };
        let touching: Touching = copies
            .meetings
            .iter()
            .map(|line| line.iter().map(|m| (m.gauge, slopes_at(m), m.at)).collect())
            .collect();
        let across = slopes_across(problem, reference, &touching, program);
        let shapes = copies.shapes(&across, &gauges, program);
        let jets: Vec<[Form; 3]> = shapes.iter().map(UnknownJet::jet).collect();
        let free = free_edges(problem, mesh, topology, &copies, &jets);
        let slopes = slopes(problem, mesh, topology, &copies, &across, &free, program);
        let far = problem.statement().boundaries.iter().any(|b| b.condition == Condition::Far);
        let far_stress = far.then(|| program.unknown());
        let SplitVertices { corners, vertex_of, apex, surfaces, loads, .. } = copies;
        Self {
            corners,
            vertex_of,
            shapes,
            jets,
            apex,
            surfaces,
            loads,
            slopes,
            gauges,
            gradients,
            across,
            far_stress,
            multiplier: reference.multiplier,
        }
    }

    /// The axial force of a flexible member at the start, in the middle and at the end of an edge: what the slope to its left is more on
    /// its left. Both sides are relative to the same gauges.
    pub(crate) fn axial_force(&self, edge: &MemberEdge) -> [Form; 3] {
        let Some([side, other]) = edge.both() else { return std::array::from_fn(|_| Form::default()) };
        let corner = |side: Side, i: usize| self.corners[side.triangle][(side.corner + i) % 3];
        let at = |left: usize, right: usize| kink(edge, &self.jets, left, right);
        let slope = |side: Side| &self.slopes[side.triangle][side.corner].1;
        let by = 1.0 / edge.length();
        let middle = Form::default().plus(by, slope(side)).plus(by, slope(other));
        [at(corner(side, 1), corner(other, 2)), middle, at(corner(side, 2), corner(other, 1))]
    }

    /// Value and slopes at the start and the end of an edge of a beam, and the slope to the beam's left in the middle, all on its left less
    /// those on its right: in the soil, or of the loads on the outer side.
    pub(super) fn jump_at_beam(&self, problem: &Problem, edge: &MemberEdge) -> ([[Form; 3]; 2], Form) {
        let less = |a: &[Form; 3], b: &[Form; 3]| std::array::from_fn(|i| a[i].clone().plus(-1.0, &b[i]));
        let [left, right] = [0, 1].map(|on| self.trace(problem, edge, on));
        ([0, 1].map(|i| less(&left.0[i], &right.0[i])), left.1.plus(-1.0, &right.1))
    }

    /// Value and slopes at the start and the end, and the slope in the middle, on one side of a beam.
    fn trace(&self, problem: &Problem, edge: &MemberEdge, on: usize) -> ([[Form; 3]; 2], Form) {
        let t = edge.along();
        let n = turned(t);
        let [p, q] = edge.ends;
        let middle = midpoint(p, q);
        let across = |slopes: &[Form; 3]| Form::default().plus(n[0], &slopes[1]).plus(n[1], &slopes[2]);
        let Some(side) = edge.sides[on] else {
            // The side of the soil that is lined, and where on its line the edge is.
            let lined = LineUse { line: edge.line, forward: edge.is_forward ^ (on == 0) };
            let [from, to] = problem.ends(edge.line);
            let length = distance(from, to);
            let gauge = self.loads.run(lined).unwrap_or(0);
            let at = |p: Point| {
                let affine = self.affine(gauge, p);
                let demanded = self.loads.at(lined, distance(from, p) / length);
                std::array::from_fn(|i| demanded[i].clone().plus(1.0, &affine[i]))
            };
            let slope = across(&at(middle));
            return ([at(p), at(q)], slope);
        };
        let mut corners = [1, 2].map(|i| (side.corner + i) % 3);
        if on == 1 {
            corners.reverse();
        }
        let copies = corners.map(|k| self.corners[side.triangle][k]);
        let whole = |copy: usize, p: Point| -> [Form; 3] {
            let affine = self.affine(self.shapes[copy].base(), p);
            let beyond = self.surfaces.jet(self.surfaces.of_copy[copy], p);
            std::array::from_fn(|i| {
                let form = self.jets[copy][i].clone().plus(1.0, &affine[i]);
                beyond.as_ref().map_or(form.clone(), |beyond| form.plus(1.0, &beyond[i]))
            })
        };
        let at = [whole(copies[0], p), whole(copies[1], q)];
        if copies.iter().any(|copy| self.apex[*copy]) {
            // Beyond the polynomial of the surface it grows with the square of the distance from the apex.
            let frame = self.affine(self.shapes[copies[0]].base(), middle);
            let surface = |p: Point| -> Form {
                let own = self.surfaces.of_triangle(side.triangle, p);
                across(&frame).plus(1.0, &own.map_or(Form::default(), |own| across(&own)))
            };
            let rest = |i: usize, p: Point| across(&at[i]).plus(-1.0, &surface(p));
            let slope = surface(middle).plus(0.25, &rest(0, p)).plus(0.25, &rest(1, q));
            return (at, slope);
        }
        let (base, own) = &self.slopes[side.triangle][side.corner];
        let sign = if on == 0 { 1.0 } else { -1.0 };
        let slope = across(&self.affine(*base, middle)).plus(sign / edge.length(), own);
        (at, slope)
    }

    /// The affine function of a gauge at a point: value and slopes.
    fn affine(&self, gauge: usize, p: Point) -> [Form; 3] {
        let [c, gx, gy] = &self.gauges[gauge];
        [c.clone().plus(p[0], gx).plus(p[1], gy), gx.clone(), gy.clone()]
    }

    /// Slopes at a triangle corner, in full.
    pub(crate) fn gradient(&self, triangle: usize, corner: usize, at: Point) -> [Form; 2] {
        let copy = self.corners[triangle][corner];
        let [_, gx, gy] = &self.gauges[self.shapes[copy].base()];
        let [_, fx, fy] = &self.jets[copy];
        let slopes = [fx.clone().plus(1.0, gx), fy.clone().plus(1.0, gy)];
        match self.surfaces.jet(self.surfaces.of_copy[copy], at) {
            Some([_, qx, qy]) => {
                let [x, y] = slopes;
                [x.plus(1.0, &qx), y.plus(1.0, &qy)]
            }
            None => slopes,
        }
    }

    /// The twelve local values of a triangle's element, up to an affine function and beyond the polynomial of its surface.
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
            let beyond = self.surfaces.beyond(copies[k], triangle, corners[k]);
            for i in 0..3 {
                if !self.apex[copies[k]] {
                    local[3 * k + i] = self.jets[copies[k]][i].clone();
                    for more in [&moved, &beyond].into_iter().flatten() {
                        local[3 * k + i].add(1.0, &more[i]);
                    }
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
            if let Some([_, qx, qy]) = self.surfaces.of_triangle(triangle, midpoint(corners[a], corners[b])) {
                let n = turned(between(corners[a], corners[b]));
                local[9 + k].add(-n[0], &qx);
                local[9 + k].add(-n[1], &qy);
            }
        }
        local
    }

    /// The stress function of a solution, as a certificate stores it.
    pub(crate) fn saved(&self, mesh: &Mesh, topology: &Topology, problem: &Problem, x: &[f64]) -> LowerField {
        let gradient = |gauge: usize| match self.gradients[gauge] {
            Slopes::Zero => Gradient::Free { x: 0.0, y: 0.0 },
            Slopes::Free => {
                Gradient::Free { x: self.gauges[gauge][1].value(x), y: self.gauges[gauge][2].value(x) }
            }
            Slopes::Along { line, unit } => {
                // The unknown behind the gradient, along the line's own vector.
                let u = self.gauges[gauge].iter().skip(1).find_map(|f| f.terms.first().map(|t| t.0));
                Gradient::Along { line, value: u.map_or(0.0, |u| unit * x[u]) }
            }
        };
        let slopes = (0..mesh.triangles.len())
            .map(|triangle| {
                std::array::from_fn(|k| {
                    let condition = topology.line[triangle][k].and_then(|l| problem.condition(l));
                    let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                    let apex = self.apex[self.corners[triangle][a]] || self.apex[self.corners[triangle][b]];
                    let known = condition.is_some_and(|c| c.traction_is_given() || c.shear_is_given());
                    if apex || known { 0.0 } else { self.slopes[triangle][k].1.value(x) }
                })
            })
            .collect();
        LowerField {
            mesh: mesh.saved(),
            corners: self.corners.clone(),
            copies: self
                .vertex_of
                .iter()
                .zip(&self.shapes)
                .map(|(vertex, shape)| VertexCopy { vertex: *vertex, jet: shape.saved(x) })
                .collect(),
            gauges: (0..self.gauges.len())
                .map(|c| Gauge { constant: self.gauges[c][0].value(x), gradient: gradient(c) })
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
