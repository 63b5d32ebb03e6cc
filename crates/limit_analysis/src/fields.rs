//! Solved fields as plain numbers, and how to find one's way in them.

use soilctl_certificate::Side;
use soilctl_conic::Form;

use crate::anisotropy::Ellipse;
use crate::lower::macro_element::{Curvature, curvatures};
use crate::lower::{Lower, SectionForces, node_stresses};
use crate::members::MemberEdge;
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::upper::{Element, Limit, Upper, Velocity, gradients, shear_rates};
use crate::vector::{Point, centroid, twice_area};

/// A stress field: values `[xx, yy, xy]` at the nodes of the three parts of each triangle.
#[derive(Debug, Clone)]
pub(crate) struct StressField {
    pub(crate) corners: Vec<[Point; 3]>,
    pub(crate) across: Vec<[Option<Side>; 3]>,
    pub(crate) parts: Vec<[[[f64; 3]; 3]; 3]>,
    /// The part of cohesion, adhesion and tension that it needs; one unless that is what is bounded.
    pub(crate) part: f64,
    /// What members bear along each edge.
    pub(crate) members: Vec<(MemberEdge, Forces)>,
}

/// How a member moves along an edge: Bernstein coefficients.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MemberVelocity {
    pub(crate) edge: MemberEdge,
    /// Along itself and across, to its left; of a row of bars, that of the soil right at them.
    pub(crate) along: [f64; 3],
    pub(crate) across: [f64; 3],
    /// How much faster than that bars move along themselves.
    pub(crate) slip: [f64; 3],
}

impl MemberVelocity {
    /// Its own velocity along itself.
    pub(crate) fn own(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.along[i] + self.slip[i])
    }
}

/// What a member bears along an edge: Bernstein coefficients.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Forces {
    pub(crate) axial: [f64; 3],
    /// Of a beam: moment and shear force.
    pub(crate) bent: Option<([f64; 4], [f64; 3])>,
}

impl Forces {
    fn new(forces: &SectionForces, x: &[f64]) -> Self {
        let bent = forces.bent.as_ref().map(|bent| {
            (bent.moment.each_ref().map(|f| f.value(x)), bent.shear.each_ref().map(|f| f.value(x)))
        });
        Self { axial: forces.axial.each_ref().map(|f| f.value(x)), bent }
    }
}

/// A velocity field.
#[derive(Debug, Clone)]
pub(crate) struct VelocityField {
    /// Control points of each triangle. Where there is a stream function they are right along the edges only.
    pub(crate) control: Vec<[Point; 6]>,
    /// Parts of each triangle on which the strain rate is linear: the triangle itself, or thirds of it.
    pub(crate) pieces: Vec<Vec<Piece>>,
    /// Which limit of each triangle's strength counts.
    pub(crate) limits: Vec<Limit>,
    /// Power of the loads whose factor is bounded; one if a force is.
    pub(crate) live: f64,
    /// How members move on each edge.
    pub(crate) members: Vec<MemberVelocity>,
}

/// Strain rates `[exx, eyy, 2 exy]` at corners, and the rate that a second kind of strength works on: the shear rate beyond the dilation
/// where tension is cut off, all of it, directed, where there is no friction; of an envelope all power.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    pub(crate) corners: [Point; 3],
    pub(crate) rates: [[f64; 4]; 3],
}

impl StressField {
    pub(crate) fn new(problem: &Problem, mesh: &Mesh, topology: &Topology, lower: &Lower, x: &[f64]) -> Self {
        let corners = (0..mesh.triangles.len()).map(|t| mesh.corners(t)).collect();
        let parts = (0..mesh.triangles.len())
            .map(|t| {
                node_stresses(&lower.reference, mesh, &lower.function, t)
                    .map(|part| part.map(|s| s.map_or([0.0; 3], |s| s.map(|f| f.value(x)))))
            })
            .collect();
        let members =
            lower.members.iter().map(|edge| (*edge, Forces::new(&lower.section_forces(problem, edge), x)));
        let members = members.collect();
        Self { corners, across: topology.across.clone(), parts, part: lower.part(x), members }
    }

    pub(crate) fn centre(&self, t: usize) -> Point {
        centroid(&self.corners[t])
    }
}

/// The triangle at a point: a walk towards it, and a search of all if a hole or a notch is in the way.
pub(crate) fn near(corners: &[[Point; 3]], across: &[[Option<Side>; 3]], p: Point, start: usize) -> usize {
    let mut here = start;
    for _ in 0..corners.len() {
        let v = &corners[here];
        let outside = (0..3)
            .map(|k| (k, twice_area([v[(k + 1) % 3], v[(k + 2) % 3], p])))
            .filter(|(k, a)| *a < 0.0 && across[here][*k].is_some())
            .min_by(|a, b| a.1.total_cmp(&b.1));
        match outside.and_then(|(k, _)| across[here][k]) {
            Some(next) => here = next.triangle,
            None => break,
        }
    }
    let holds = |v: &[Point; 3]| (0..3).all(|k| twice_area([v[(k + 1) % 3], v[(k + 2) % 3], p]) >= 0.0);
    if holds(&corners[here]) { here } else { corners.iter().position(holds).unwrap_or(here) }
}

impl VelocityField {
    pub(crate) fn new(upper: &Upper, x: &[f64]) -> Self {
        let value = |v: &Velocity| [v[0].value(x), v[1].value(x)];
        let control: Vec<[Point; 6]> = upper
            .elements
            .iter()
            .zip(&upper.control)
            .map(|(element, control)| match (element, control) {
                (_, Some(control)) => control.each_ref().map(value),
                (Element::Quadratic(nodes), None) => nodes.map(|n| value(&upper.velocities[n])),
                (Element::Stream(_) | Element::Rest, None) => [[0.0; 2]; 6],
            })
            .collect();
        let pieces = (0..control.len()).map(|t| match upper.stream_values(t, x) {
            Some(local) => thirds(&upper.corners[t], &local, &upper.ellipses[t]),
            None => vec![whole(&upper.corners[t], &control[t], &upper.limits[t])],
        });
        let value = |forms: &[Form; 3]| forms.each_ref().map(|f| f.value(x));
        let members = upper.members.iter().map(|m| MemberVelocity {
            edge: m.edge,
            along: value(&m.along),
            across: value(&m.across),
            slip: value(&m.slip),
        });
        let members = members.collect();
        Self { pieces: pieces.collect(), control, limits: upper.limits.clone(), live: upper.live, members }
    }
}

/// The strain rate of a quadratic velocity.
fn whole(v: &[Point; 3], control: &[Point; 6], limit: &Limit) -> Piece {
    let rates = std::array::from_fn(|k| {
        let mut e = [0.0; 4];
        for (node, [gx, gy]) in gradients(v, k).iter().enumerate() {
            let [vx, vy] = control[node];
            e[0] += gx * vx;
            e[1] += gy * vy;
            e[2] += gy * vx + gx * vy;
        }
        e[3] = limit.beyond(e[0] + e[1], (e[0] - e[1]).hypot(e[2]));
        e
    });
    Piece { corners: *v, rates }
}

/// Those of a stream function.
fn thirds(v: &[Point; 3], local: &[f64; 12], ellipse: &Ellipse) -> Vec<Piece> {
    let centre = centroid(v);
    let piece = |(k, part): (usize, &[Curvature; 3])| Piece {
        corners: [v[(k + 1) % 3], v[(k + 2) % 3], centre],
        rates: part.map(|curvature| {
            let [difference, shear] =
                shear_rates(&curvature).map(|row| row.iter().zip(local).map(|(r, l)| r * l).sum::<f64>());
            [0.5 * difference, -0.5 * difference, shear, ellipse.rate(difference, shear)]
        }),
    };
    curvatures(v, [false; 3]).iter().enumerate().map(piece).collect()
}
