//! The static program: the largest force, or the largest factor on loads, over statically admissible stresses.
//!
//! Stresses are second derivatives of an Airy stress function with continuous slopes, so that equilibrium holds whatever the
//! unknowns are, and only yield is left to the cones of the program.

mod apart;
mod branches;
pub(crate) mod dofs;
mod far;
mod given;
mod loads;
pub(crate) mod macro_element;
mod members;
mod reference;
mod splice;
mod split_vertices;
pub(crate) mod surfaces;
#[cfg(test)]
pub(crate) mod tests;
mod unknown_jet;

use soilctl_certificate::{Condition, LowerField, Objective};
use soilctl_conic::{Cone, Form, Program};

pub(crate) use apart::apart;
use dofs::StressFunction;
use macro_element::{Curvature, curvatures};
pub(crate) use members::SectionForces;
use reference::ReferenceStress;
use splice::Splice;

use crate::envelope::Line;
use crate::members::{MemberEdge, member_edges};
use crate::mesh::Mesh;
use crate::problem::{Problem, Soil};
use crate::topology::Topology;
use crate::vector::{Point, between, centroid, distance, length};

/// The least part of the strength that is looked for: soil that needs no more bears anything.
const LEAST_PART: f64 = 1e-3;

/// A stress `[xx, yy, xy]`.
pub(crate) type Stress = [Form; 3];

/// The program of the lower bound with what is needed to read its answer.
#[derive(Debug)]
pub(crate) struct Lower {
    pub(crate) program: Program,
    pub(crate) function: StressFunction,
    pub(crate) reference: ReferenceStress,
    /// The force or factor to be made large.
    pub(crate) force: Form,
    /// The unknown part of cohesion, adhesion and tension that is enough for everything that acts, if that is bounded.
    part: Option<usize>,
    /// The edges of members.
    pub(crate) members: Vec<MemberEdge>,
    /// What follows from the ends of the structure, if the bound shall hold for every width.
    splice: Option<Splice>,
    /// Circles of Mohr that envelopes limit.
    circles: Vec<Circle>,
}

/// A circle of Mohr whose radius and mean stress (tension positive) are unknowns, for many limits on both: the true radius is not above the
/// one, the true mean stress not above the other, and limits fall with the latter. All times one scale.
#[derive(Debug)]
struct Circle {
    radius: usize,
    mean: usize,
    true_mean: Form,
    spans: [Form; 2],
    limits: Vec<Form>,
}

fn stress(c: &Curvature, local: &[Form; 12], reference: &Stress) -> Stress {
    let form = |row: &[f64; 12], sign: f64, start: &Form| {
        let mut f = start.clone();
        for (coefficient, value) in row.iter().zip(local) {
            f.add(sign * coefficient, value);
        }
        f
    };
    [form(&c[1], 1.0, &reference[0]), form(&c[0], 1.0, &reference[1]), form(&c[2], -1.0, &reference[2])]
}

/// The cone of Mohr and Coulomb for the effective stress at a point, scaled. Of strength that depends on the direction it is that of its ellipse.
///
/// Of cohesion and tension there is the given part.
fn mohr_coulomb(soil: &Soil, part: &Form, [xx, yy, xy]: &Stress, at: Point, scale: f64) -> [Form; 3] {
    let mean = -0.5 * soil.sin * scale;
    let cohesion = soil.cohesion.at(at).max(0.0);
    let water = soil.pore_pressure.at(at);
    let level = 0.5 * scale / soil.ellipse.level;
    [
        Form::constant(-scale * soil.sin * water)
            .plus(scale * (cohesion * soil.cos), part)
            .plus(mean, xx)
            .plus(mean, yy),
        Form::default()
            .plus(level, xx)
            .plus(-level, yy)
            .plus(-soil.ellipse.middle * cohesion * level * 2.0, part),
        Form::default().plus(scale / soil.ellipse.shear, xy),
    ]
}

/// The cone of the greatest effective tension at a point, scaled.
fn cut_off(soil: &Soil, tension: &Form, [xx, yy, xy]: &Stress, at: Point, scale: f64) -> [Form; 3] {
    let water = soil.pore_pressure.at(at);
    [
        Form::constant(-scale * water).plus(scale, tension).plus(-0.5 * scale, xx).plus(-0.5 * scale, yy),
        Form::default().plus(0.5 * scale, xx).plus(-0.5 * scale, yy),
        Form::default().plus(scale, xy),
    ]
}

/// Stress at the nodes of all three parts of a triangle, `None` where it vanishes.
pub(crate) fn node_stresses(
    reference: &ReferenceStress,
    mesh: &Mesh,
    function: &StressFunction,
    triangle: usize,
) -> [[Option<Stress>; 3]; 3] {
    let region = mesh.triangles[triangle].region;
    let v = mesh.corners(triangle);
    let apex = function.corners[triangle].map(|c| function.apex[c]);
    let curvature = curvatures(&v, apex);
    let local = function.local(triangle, &v);
    std::array::from_fn(|k| {
        std::array::from_fn(|node| {
            let corner = (k + 1 + node) % 3;
            if node < 2 && apex[corner] {
                return None;
            }
            let at = if node < 2 { v[corner] } else { centroid(&v) };
            let rest = function.surfaces.stress(reference, triangle, region, at);
            Some(stress(&curvature[k][node], &local, &rest))
        })
    })
}

/// Normal and shear stress on a plane with unit direction `t`, the soil on its left.
fn traction([xx, yy, xy]: &Stress, t: Point) -> (Form, Form) {
    let n = [t[1], -t[0]];
    let on = |a: Point, b: Point| {
        Form::default().plus(a[0] * b[0], xx).plus(a[1] * b[1], yy).plus(a[0] * b[1] + a[1] * b[0], xy)
    };
    (on(n, n), on(t, n))
}

impl Lower {
    pub(crate) fn new(problem: &Problem, mesh: &Mesh, topology: &Topology, tighten: f64) -> Self {
        let mut program = Program::default();
        let factor = problem.has_factor().then(|| program.unknown());
        let all = problem.statement().objective == Objective::Everything;
        let (part, multiplier) = if all { (factor, None) } else { (None, factor) };
        let reference = ReferenceStress::new(problem, multiplier);
        let function = StressFunction::new(problem, mesh, topology, &reference, &mut program);
        // The factor on everything is one over the part of the strength, which is made small.
        let sign = if all { -1.0 } else { 1.0 };
        let force = factor.map_or(Form::default(), |m| Form::unknown(m, sign));
        if let Some(part) = part {
            program.non_negative(Form::unknown(part, 1.0).plus(-LEAST_PART, &Form::constant(1.0)));
        }
        let splice = problem.is_spliced().then(|| Splice::new(problem));
        let members = member_edges(problem, mesh, topology);
        let circles = Vec::new();
        let mut lower = Self { program, function, reference, force, part, members, splice, circles };
        for triangle in 0..mesh.triangles.len() {
            lower.add_triangle(problem, mesh, topology, triangle);
        }
        lower.add_members(problem, mesh);
        lower.program.tighten(tighten);
        for &(index, coefficient) in &lower.force.terms {
            lower.program.objective.push((index, -coefficient));
        }
        lower
    }

    fn add_triangle(&mut self, problem: &Problem, mesh: &Mesh, topology: &Topology, triangle: usize) {
        let t = &mesh.triangles[triangle];
        let v = mesh.corners(triangle);
        let soil = &problem.soils[t.region];
        let stresses = node_stresses(&self.reference, mesh, &self.function, triangle);
        let h = (0..3).map(|k| distance(v[k], v[(k + 1) % 3])).sum::<f64>() / 3.0;
        // Multipliers are then about as large as strains times lengths, like the unknowns of the upper bound.
        let scale = |p: Point| h / problem.stress_scale(t.region, p, h);
        for part in 0..3 {
            for node in 0..2 {
                if let Some(s) = &stresses[part][node] {
                    self.add_strength(soil, s, v[(part + 1 + node) % 3], &scale);
                }
            }
        }
        // All three parts have the same stress at the centroid.
        if let Some(s) = &stresses[0][2] {
            self.add_strength(soil, s, centroid(&v), &scale);
        }
        for (k, part) in stresses.iter().enumerate() {
            let Some(side) = topology.line[triangle][k] else { continue };
            if let Some(member) = problem.member_on(side.line) {
                self.add_bond(&problem.members()[member], soil, part, &v, k, &scale);
            }
            let Some(condition) = problem.condition(side) else { continue };
            let ends = [(k + 1) % 3, (k + 2) % 3];
            let along = between(v[ends[0]], v[ends[1]]);
            let unit = along.map(|x| x / length(along));
            if !problem.has_factor() && matches!(condition, Condition::Face { .. }) {
                self.add_force(problem, mesh, triangle, ends, &v);
            }
            for (node, corner) in ends.into_iter().enumerate() {
                let Some(s) = &part[node] else { continue };
                let at = v[corner];
                match condition {
                    Condition::Face { delta_deg, adhesion } => {
                        let water = soil.pore_pressure.at(at);
                        self.add_face(s, unit, scale(at), delta_deg, adhesion, water);
                    }
                    Condition::Far => {
                        let vertex = t.corners[corner];
                        self.add_far(problem, mesh, side, vertex, s, scale(at));
                    }
                    Condition::Free
                    | Condition::Loaded { .. }
                    | Condition::Lined { .. }
                    | Condition::Submerged
                    | Condition::Fixed
                    | Condition::Smooth => {}
                }
            }
        }
    }

    fn add_strength(&mut self, soil: &Soil, s: &Stress, at: Point, scale: &impl Fn(Point) -> f64) {
        self.add_yield(soil, s, at, scale(at));
        let part = self.strength();
        if let Some(tension) = soil.cut_off {
            let tension = Form::default().plus(tension, &part);
            self.program.second_order(cut_off(soil, &tension, s, at, scale(at)));
        }
    }

    /// Yield without a limit to the tension, and what ends demand.
    fn add_yield(&mut self, soil: &Soil, s: &Stress, at: Point, scale: f64) {
        let part = self.strength();
        let [most, difference, shear] = mohr_coulomb(soil, &part, s, at, scale);
        match &soil.envelope {
            None => self.program.second_order([most, difference, shear]),
            Some(envelope) => {
                let own = Line { sin: soil.sin, cos: soil.cos, cohesion: soil.cohesion.at(at).max(0.0) };
                let [xx, yy, _] = s;
                let mean = Form::constant(scale * soil.pore_pressure.at(at));
                let mean = mean.plus(0.5 * scale, xx).plus(0.5 * scale, yy);
                let lines = std::iter::once(&own).chain(&envelope.inside);
                let limits = lines
                    .map(|line| (line.sin, Form::default().plus(scale * line.cohesion * line.cos, &part)));
                let limits = limits.collect();
                self.add_circle([difference, shear], mean, limits);
            }
        }
        for cone in self.splice.iter().flat_map(|splice| splice.cones(s, at, scale)) {
            self.program.second_order(cone);
        }
    }

    /// Limits the radius of a circle of Mohr by lines, given by what they fall with the mean stress and what they are where that is zero.
    fn add_circle(&mut self, spans: [Form; 2], true_mean: Form, lines: Vec<(f64, Form)>) {
        let [radius, mean] = [self.program.unknown(), self.program.unknown()];
        let [difference, shear] = spans.clone();
        self.program.second_order([Form::unknown(radius, 1.0), difference, shear]);
        self.program.non_negative(Form::unknown(mean, 1.0).plus(-1.0, &true_mean));
        let limit = |(falls, start): (f64, Form)| start.plus(-falls, &Form::unknown(mean, 1.0));
        let limits: Vec<Form> = lines.into_iter().map(limit).collect();
        for limit in &limits {
            self.program.non_negative(limit.clone().plus(-1.0, &Form::unknown(radius, 1.0)));
        }
        self.circles.push(Circle { radius, mean, true_mean, spans, limits });
    }

    fn add_face(&mut self, s: &Stress, t: Point, scale: f64, delta_deg: f64, adhesion: f64, water: f64) {
        let (normal, shear) = traction(s, t);
        let condition = Condition::Face { delta_deg, adhesion };
        if condition.shear_is_given() {
            return self.program.non_negative(Form::constant(-scale * water).plus(-scale, &normal));
        }
        let tan = delta_deg.to_radians().tan();
        let hold = Form::constant(-scale * tan * water)
            .plus(scale * adhesion, &self.strength())
            .plus(-scale * tan, &normal);
        self.program.non_negative(hold.clone().plus(scale, &shear));
        self.program.non_negative(hold.plus(-scale, &shear));
    }

    /// Adds what a face edge contributes to the structure's force on the soil, along the structure's velocity.
    fn add_force(
        &mut self,
        problem: &Problem,
        mesh: &Mesh,
        triangle: usize,
        [a, b]: [usize; 2],
        v: &[Point; 3],
    ) {
        let [ax, ay] = self.function.gradient(triangle, a, v[a]);
        let [bx, by] = self.function.gradient(triangle, b, v[b]);
        let [u, w] = problem.velocity();
        let region = mesh.triangles[triangle].region;
        for (factor, slope) in [(u, &by), (-u, &ay), (-w, &bx), (w, &ax)] {
            self.force.add(factor, slope);
        }
        // The reference stress on the face, by the trapezium rule, which is exact for linear stress.
        let n = [v[b][1] - v[a][1], v[a][0] - v[b][0]];
        for p in [v[a], v[b]] {
            let [xx, yy, xy] = self.reference.at(region, p).map(|f| f.constant);
            self.force.constant += 0.5 * (u * (xx * n[0] + xy * n[1]) + w * (xy * n[0] + yy * n[1]));
        }
    }

    /// The part of cohesion, adhesion and tension that there is.
    fn strength(&self) -> Form {
        self.part.map_or(Form::constant(1.0), |part| Form::unknown(part, 1.0))
    }

    /// The same in a solution.
    pub(crate) fn part(&self, x: &[f64]) -> f64 {
        self.part.map_or(1.0, |part| x[part].max(LEAST_PART))
    }

    /// The bound that a solution claims.
    pub(crate) fn claim(&self, x: &[f64]) -> f64 {
        if self.part.is_some() { 1.0 / self.part(x) } else { self.force.value(x) }
    }

    /// The stress field of a solution, as a certificate stores it.
    pub(crate) fn saved(&self, problem: &Problem, mesh: &Mesh, topology: &Topology, x: &[f64]) -> LowerField {
        let mut field = self.function.saved(mesh, topology, problem, x);
        if self.part.is_some() {
            field.multiplier = self.claim(x);
        }
        field
    }

    /// Moves a solution towards the state at rest until it is inside all cones by `margin`.
    ///
    /// At rest all unknowns are zero, which is strictly inside unless the ground itself is at its limit. Where that is looked
    /// for, more strength does as well.
    pub(crate) fn drawn_inside(&self, x: &[f64], margin: f64) -> Vec<f64> {
        let mut rest = vec![0.0; x.len()];
        if let Some(part) = self.part {
            rest.copy_from_slice(x);
            rest[part] = 2.0 * self.part(x);
        }
        for circle in &self.circles {
            let [a, b] = circle.spans.each_ref().map(|span| span.value(&rest));
            rest[circle.mean] = circle.true_mean.value(&rest);
            let limit = circle.limits.iter().map(|form| form.value(&rest)).fold(f64::INFINITY, f64::min);
            let spare = limit - a.hypot(b);
            rest[circle.mean] += 0.25 * spare;
            rest[circle.radius] = a.hypot(b) + 0.375 * spare;
        }
        let mut share: f64 = 0.0;
        let mut row = 0;
        for cone in &self.program.cones {
            let (here, there) = (self.program.slack(row, *cone, x), self.program.slack(row, *cone, &rest));
            if *cone != Cone::Zero && here < margin && there > margin {
                share = share.max((margin - here) / (there - here));
            }
            row += cone.rows();
        }
        let share = share.min(1.0);
        x.iter().zip(&rest).map(|(v, r)| v * (1.0 - share) + r * share).collect()
    }
}
