//! Where the distance between the bounds comes from.
//!
//! For any stress field in equilibrium and any velocity field that obeys the flow rule, `upper - lower` is the integral
//! of the dissipation that the stresses do not match, over the soil and over velocity jumps, and no part of it is
//! negative. The two fields may live on different meshes: the integral is taken over the pieces that the two meshes
//! cut each other into, on which stress and strain rate are both linear.
//!
//! The dissipation is that of the proof: in soil without friction, and where tension is cut off, from shear rates that
//! are linear between nodes. Cohesion and pore pressure are linear. For a factor on loads the integral is that over the
//! loads' power.

mod members;

use soilctl_certificate::{Condition, Side};

use crate::anisotropy::{Ellipse, ROUND};
use crate::envelope::greatest;
use crate::fields::{StressField, VelocityField, near};
use crate::mesh::Mesh;
use crate::problem::{Problem, Soil};
use crate::topology::Topology;
use crate::upper::{Edge, Limit, MeshedProblem, Toes};
use crate::vector::{Point, between, centroid, twice_area};

/// The part of a convex polygon on the left of the line from `a` to `b`.
fn clip(polygon: &[Point], a: Point, b: Point, out: &mut Vec<Point>) {
    out.clear();
    for i in 0..polygon.len() {
        let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let (sp, sq) = (twice_area([a, b, p]), twice_area([a, b, q]));
        if sp >= 0.0 {
            out.push(p);
        }
        if (sp > 0.0 && sq < 0.0) || (sp < 0.0 && sq > 0.0) {
            let s = sp / (sp - sq);
            out.push([p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])]);
        }
    }
}

/// Linear interpolation in a triangle.
fn linear<const N: usize>(v: &[Point; 3], values: &[[f64; N]; 3], p: Point) -> [f64; N] {
    let total = twice_area([v[0], v[1], v[2]]);
    let l: [f64; 3] = std::array::from_fn(|k| twice_area([v[(k + 1) % 3], v[(k + 2) % 3], p]) / total);
    std::array::from_fn(|i| l[0] * values[0][i] + l[1] * values[1][i] + l[2] * values[2][i])
}

/// Shares in the gap, one for each triangle of the velocity field's mesh.
pub(crate) fn shares(
    problem: &Problem,
    mesh: &Mesh,
    topology: &Topology,
    velocity: &VelocityField,
    stress: &StressField,
) -> Vec<f64> {
    let toes = Toes::new(problem, mesh, topology);
    let meshed = &MeshedProblem { problem, mesh, topology, toes: &toes };
    let soils: Vec<Soil> = problem.soils.iter().map(|soil| soil.part(stress.part)).collect();
    let mut shares = vec![0.0; mesh.triangles.len()];
    let mut seen = vec![usize::MAX; stress.corners.len()];
    let mut found = 0;
    let (mut cut, mut spare) = (Vec::new(), Vec::new());
    for (triangle, t) in mesh.triangles.iter().enumerate() {
        let v = mesh.corners(triangle);
        let centre = centroid(&v);
        let soil = &soils[t.region];
        let limit = &velocity.limits[triangle];
        let jumps = jumps(meshed, &soils, stress.part, velocity, triangle);
        found = near(&stress.corners, &stress.across, centre, found);
        let mut open = vec![found];
        seen[found] = triangle;
        while let Some(s) = open.pop() {
            let mut met = false;
            for k in 0..3 {
                let corners = &stress.corners[s];
                let part = [corners[(k + 1) % 3], corners[(k + 2) % 3], stress.centre(s)];
                let values = &stress.parts[s][k];
                let mut met_part = false;
                for piece in &velocity.pieces[triangle] {
                    cut.clear();
                    cut.extend_from_slice(&piece.corners);
                    for i in 0..3 {
                        clip(&cut, part[i], part[(i + 1) % 3], &mut spare);
                        std::mem::swap(&mut cut, &mut spare);
                    }
                    if cut.len() < 3 {
                        continue;
                    }
                    met_part = true;
                    let at = |p: Point| {
                        let [xx, yy, xy] = linear(&part, values, p);
                        let [shift, extra] = strength(soil, limit, stress.part, p);
                        let stress = [xx - shift, yy - shift, xy, -extra];
                        (stress, linear(&piece.corners, &piece.rates, p))
                    };
                    add_unmatched(&cut, at, &mut shares[triangle]);
                }
                if !met_part {
                    continue;
                }
                met = true;
                for jump in jumps.iter().flatten() {
                    let share = jump.share(&v, &part, values);
                    shares[triangle] += share;
                }
            }
            if met {
                for next in stress.across[s].iter().flatten() {
                    if seen[next.triangle] != triangle {
                        seen[next.triangle] = triangle;
                        open.push(next.triangle);
                    }
                }
            }
        }
    }
    members::add_shares(problem, velocity, stress, &mut shares);
    shares.iter_mut().for_each(|share| *share /= velocity.live * stress.part);
    shares
}

/// What soil dissipates for each unit of dilation, and of the shear rate in [`Piece`](crate::fields::Piece).
fn strength(soil: &Soil, limit: &Limit, part: f64, p: Point) -> [f64; 2] {
    if matches!(limit, Limit::Envelope(_)) {
        [-soil.pore_pressure.at(p), part]
    } else if !soil.is_isochoric {
        [limit.tension(soil, p) - soil.pore_pressure.at(p), limit.radius(soil, p)]
    } else {
        [0.0, soil.cohesion.at(p).max(0.0)]
    }
}

/// Takes from `share` the integral of the product of two things that are linear on a convex polygon.
fn add_unmatched(polygon: &[Point], at: impl Fn(Point) -> ([f64; 4], [f64; 4]), share: &mut f64) {
    for i in 1..polygon.len() - 1 {
        let corners = [polygon[0], polygon[i], polygon[i + 1]];
        let area = 0.5 * twice_area([corners[0], corners[1], corners[2]]);
        let nodes = corners.map(&at);
        let mut power = 0.0;
        for c in 0..4 {
            let sum_s: f64 = nodes.iter().map(|n| n.0[c]).sum();
            let sum_e: f64 = nodes.iter().map(|n| n.1[c]).sum();
            let paired: f64 = nodes.iter().map(|n| n.0[c] * n.1[c]).sum();
            power += sum_s * sum_e + paired;
        }
        *share -= area / 12.0 * power;
    }
}

/// What dissipates in a jump beside what opening costs: a rate, or of an envelope all power.
enum Rate<'a> {
    /// What opening and slip together are more than the opening.
    Beyond,
    Slip,
    OfCircles(&'a [Point]),
    OfTractions(Vec<Point>),
    /// What slip along an edge takes up in soil without friction.
    Along(Ellipse, Point),
}

impl Rate<'_> {
    fn at(&self, open: f64, slip: f64) -> f64 {
        match self {
            Self::Beyond => (open.hypot(slip) - open.max(0.0)).max(0.0),
            Self::Slip => slip.abs(),
            Self::OfCircles(circles) => greatest(circles, open, open.hypot(slip)),
            // Slip is counted against the edge here.
            Self::Along(ellipse, edge) => ellipse.along(*edge, -slip),
            Self::OfTractions(tractions) => greatest(tractions, open, slip.abs()),
        }
    }
}

/// A velocity jump at an edge: control points of the difference to the other side.
struct Jump {
    edge: usize,
    control: [Point; 3],
    /// What opening costs at both ends.
    tension: [f64; 2],
    /// What slip beyond the opening costs at both ends, and how much of it there is at the control points.
    radius: [f64; 2],
    beyond: [f64; 3],
    factor: f64,
}

fn jumps(
    meshed: &MeshedProblem,
    soils: &[Soil],
    part: f64,
    velocity: &VelocityField,
    triangle: usize,
) -> [Option<Jump>; 3] {
    std::array::from_fn(|k| {
        let side = Side { triangle, corner: k };
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        let here = [a, 3 + k, b].map(|n| velocity.control[triangle][n]);
        let ends = meshed.ends(side);
        let water = ends.map(|p| meshed.soil(triangle).pore_pressure.at(p));
        let mut rate = Rate::Beyond;
        let (there, tension, radius, factor) = match meshed.edge(side) {
            Edge::Boundary(Condition::Face { delta_deg, adhesion }) => {
                let adhesion = part * adhesion;
                let tension = if delta_deg > 0.0 { adhesion / delta_deg.to_radians().tan() } else { 0.0 };
                let radius = if delta_deg > 0.0 { 0.0 } else { adhesion };
                ([meshed.problem.velocity(); 3], water.map(|u| tension - u), [radius; 2], 1.0)
            }
            Edge::Jump { other: o, region } => {
                let on = |n: usize| velocity.control[o.triangle][n];
                let soil = &soils[region];
                let limit = Limit::around(soil, &ends);
                if let Some(envelope) = &soil.envelope {
                    rate = Rate::OfCircles(&envelope.circles);
                }
                let there = [on((o.corner + 2) % 3), on(3 + o.corner), on((o.corner + 1) % 3)];
                // Both sides see the jump; each takes half.
                let tension = |p| limit.tension(soil, p) - soil.pore_pressure.at(p);
                (there, ends.map(tension), ends.map(|p| limit.radius(soil, p)), 0.5)
            }
            Edge::Slip { other: o } => {
                let on = |n: usize| velocity.control[o.triangle][n];
                let soil = &soils[meshed.mesh.triangles[triangle].region];
                rate = Rate::Along(soil.ellipse, between(ends[0], ends[1]));
                let there = [on((o.corner + 2) % 3), on(3 + o.corner), on((o.corner + 1) % 3)];
                (there, [0.0; 2], ends.map(|p| soil.cohesion.at(p).max(0.0)), 0.5)
            }
            Edge::Member { .. } | Edge::Boundary(Condition::Lined { .. }) => {
                let (there, bond) = members::beside(meshed.problem, velocity, side)?;
                let soil = &soils[meshed.mesh.triangles[triangle].region];
                let [opening, slip] = crate::upper::bond(soil, bond, &ends);
                let tension = [0, 1].map(|i| opening[i] - water[i]);
                // Soil that keeps its volume does not open, whatever the last digits say.
                rate = match &soil.envelope {
                    Some(envelope) => {
                        let tractions =
                            envelope.tractions.iter().map(|[normal, shear]| [*normal, bond * shear]);
                        Rate::OfTractions(tractions.collect())
                    }
                    None if soil.ellipse == ROUND => Rate::Slip,
                    None => Rate::Along(soil.ellipse, between(ends[0], ends[1])),
                };
                (there, tension, slip, 1.0)
            }
            _ => return None,
        };
        let control = std::array::from_fn(|i| [here[i][0] - there[i][0], here[i][1] - there[i][1]]);
        let length = (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]);
        let n = [(ends[0][1] - ends[1][1]) / length, (ends[1][0] - ends[0][0]) / length];
        let beyond = control.map(|d: Point| {
            let (open, slip) = (d[0] * n[0] + d[1] * n[1], d[1] * n[0] - d[0] * n[1]);
            rate.at(open, slip)
        });
        Some(Jump { edge: k, control, tension, radius, beyond, factor })
    })
}

impl Jump {
    /// Unmatched dissipation on the piece of the edge inside a part of the stress field.
    fn share(&self, v: &[Point; 3], part: &[Point; 3], values: &[[f64; 3]; 3]) -> f64 {
        let (a, b) = (v[(self.edge + 1) % 3], v[(self.edge + 2) % 3]);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let size = twice_area([part[0], part[1], part[2]]);
        for i in 0..3 {
            let (sa, sb) =
                (twice_area([part[i], part[(i + 1) % 3], a]), twice_area([part[i], part[(i + 1) % 3], b]));
            // On the rim of a part the triangle's own side decides: its inside is on the left of the edge.
            let rim = 1e-9 * size;
            if sa.abs() < rim && sb.abs() < rim {
                let inside = twice_area([part[i], part[(i + 1) % 3], v[self.edge]]);
                if inside < 0.0 {
                    return 0.0;
                }
            } else if sa < sb {
                from = from.max(-sa / (sb - sa));
            } else if sb < sa {
                to = to.min(sa / (sa - sb));
            } else if sa < 0.0 {
                return 0.0;
            }
        }
        if to <= from {
            return 0.0;
        }
        let along = between(a, b);
        let length = along[0].hypot(along[1]);
        let t = [along[0] / length, along[1] / length];
        let n = [t[1], -t[0]];
        let mut sum = 0.0;
        for (weight, s) in [(1.0, from), (4.0, 0.5 * (from + to)), (1.0, to)] {
            let [xx, yy, xy] = linear(part, values, [a[0] + s * along[0], a[1] + s * along[1]]);
            let normal = xx * n[0] * n[0] + yy * n[1] * n[1] + 2.0 * xy * n[0] * n[1];
            let shear = xx * t[0] * n[0] + yy * t[1] * n[1] + xy * (t[0] * n[1] + t[1] * n[0]);
            let c = &self.control;
            let d: Point = std::array::from_fn(|i| {
                (1.0 - s) * (1.0 - s) * c[0][i] + 2.0 * s * (1.0 - s) * c[1][i] + s * s * c[2][i]
            });
            let open = -(d[0] * n[0] + d[1] * n[1]);
            let slide = d[0] * t[0] + d[1] * t[1];
            let between = |[from, to]: [f64; 2]| from + s * (to - from);
            let z = &self.beyond;
            let beyond = (1.0 - s) * (1.0 - s) * z[0] + 2.0 * s * (1.0 - s) * z[1] + s * s * z[2];
            let unmatched = (between(self.tension) - normal) * open + shear * slide;
            sum += weight / 6.0 * (unmatched + between(self.radius) * beyond);
        }
        self.factor * sum * (to - from) * length
    }
}
