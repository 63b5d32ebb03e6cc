//! Where the distance between the bounds comes from.
//!
//! For any stress field in equilibrium and any velocity field that obeys the flow rule, `upper - lower` is the integral
//! of the dissipation that the stresses do not match, over the soil and over velocity jumps, and no part of it is
//! negative. The two fields may live on different meshes: the integral is taken over the pieces that the two meshes
//! cut each other into, on which stress and strain rate are both linear.

use soilctl_certificate::Condition;

use crate::fields::{Point, StressField, VelocityField, doubled_area, near};
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::upper::gradients;

/// The part of a convex polygon on the left of the line from `a` to `b`.
fn clip(polygon: &[Point], a: Point, b: Point, out: &mut Vec<Point>) {
    out.clear();
    for i in 0..polygon.len() {
        let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let (sp, sq) = (doubled_area(a, b, p), doubled_area(a, b, q));
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
    let total = doubled_area(v[0], v[1], v[2]);
    let l: [f64; 3] = std::array::from_fn(|k| doubled_area(v[(k + 1) % 3], v[(k + 2) % 3], p) / total);
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
    let mut shares = vec![0.0; mesh.triangles.len()];
    let mut seen = vec![usize::MAX; stress.corners.len()];
    let mut found = 0;
    let (mut cut, mut spare) = (Vec::new(), Vec::new());
    for (triangle, t) in mesh.triangles.iter().enumerate() {
        let v = t.corners.map(|c| mesh.vertices[c].position);
        let centre = [(v[0][0] + v[1][0] + v[2][0]) / 3.0, (v[0][1] + v[1][1] + v[2][1]) / 3.0];
        let shift = problem.soils[t.region].tension(centre);
        let control = &velocity.control[triangle];
        let strain: [[f64; 3]; 3] = std::array::from_fn(|k| {
            let mut e = [0.0; 3];
            for (node, [gx, gy]) in gradients(&v, k).iter().enumerate() {
                let [vx, vy] = control[node];
                e[0] += gx * vx;
                e[1] += gy * vy;
                e[2] += gy * vx + gx * vy;
            }
            e
        });
        let jumps = jumps(problem, topology, velocity, triangle, shift);
        found = near(&stress.corners, &stress.across, centre, found);
        let mut open = vec![found];
        seen[found] = triangle;
        while let Some(s) = open.pop() {
            let mut met = false;
            for k in 0..3 {
                let corners = &stress.corners[s];
                let part = [corners[(k + 1) % 3], corners[(k + 2) % 3], stress.centre(s)];
                cut.clear();
                cut.extend_from_slice(&v);
                for i in 0..3 {
                    clip(&cut, part[i], part[(i + 1) % 3], &mut spare);
                    std::mem::swap(&mut cut, &mut spare);
                }
                if cut.len() < 3 {
                    continue;
                }
                met = true;
                let values = &stress.parts[s][k];
                let at = |p: Point| {
                    let [xx, yy, xy] = linear(&part, values, p);
                    ([xx - shift, yy - shift, xy], linear(&v, &strain, p))
                };
                for i in 1..cut.len() - 1 {
                    let corners = [cut[0], cut[i], cut[i + 1]];
                    let area = 0.5 * doubled_area(corners[0], corners[1], corners[2]);
                    let nodes = corners.map(at);
                    let mut power = 0.0;
                    for c in 0..3 {
                        let sum_s: f64 = nodes.iter().map(|n| n.0[c]).sum();
                        let sum_e: f64 = nodes.iter().map(|n| n.1[c]).sum();
                        let paired: f64 = nodes.iter().map(|n| n.0[c] * n.1[c]).sum();
                        power += sum_s * sum_e + paired;
                    }
                    let share = -area / 12.0 * power;
                    shares[triangle] += share;
                }
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
    shares
}

/// A velocity jump at an edge: control points of the difference to the other side.
struct Jump {
    edge: usize,
    control: [Point; 3],
    tension: f64,
    factor: f64,
}

fn jumps(
    problem: &Problem,
    topology: &Topology,
    velocity: &VelocityField,
    triangle: usize,
    tension: f64,
) -> [Option<Jump>; 3] {
    std::array::from_fn(|k| {
        let condition = topology.line[triangle][k].and_then(|l| problem.condition(l));
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        let here = [a, 3 + k, b].map(|n| velocity.control[triangle][n]);
        let (there, tension, factor) = match condition {
            Some(Condition::Face { delta_deg, adhesion }) => {
                let tension = if delta_deg > 0.0 { adhesion / delta_deg.to_radians().tan() } else { 0.0 };
                ([problem.velocity(); 3], tension, 1.0)
            }
            None if topology.guide[triangle][k] => {
                let o = topology.across[triangle][k]?;
                let on = |n: usize| velocity.control[o.triangle][n];
                // Both sides see the jump; each takes half.
                ([on((o.corner + 2) % 3), on(3 + o.corner), on((o.corner + 1) % 3)], tension, 0.5)
            }
            _ => return None,
        };
        let control = std::array::from_fn(|i| [here[i][0] - there[i][0], here[i][1] - there[i][1]]);
        Some(Jump { edge: k, control, tension, factor })
    })
}

impl Jump {
    /// Unmatched dissipation on the piece of the edge inside a part of the stress field.
    fn share(&self, v: &[Point; 3], part: &[Point; 3], values: &[[f64; 3]; 3]) -> f64 {
        let (a, b) = (v[(self.edge + 1) % 3], v[(self.edge + 2) % 3]);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let size = doubled_area(part[0], part[1], part[2]);
        for i in 0..3 {
            let (sa, sb) =
                (doubled_area(part[i], part[(i + 1) % 3], a), doubled_area(part[i], part[(i + 1) % 3], b));
            // On the rim of a part the triangle's own side decides: its inside is on the left of the edge.
            let rim = 1e-9 * size;
            if sa.abs() < rim && sb.abs() < rim {
                let inside = doubled_area(part[i], part[(i + 1) % 3], v[self.edge]);
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
        let along = [b[0] - a[0], b[1] - a[1]];
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
            sum += weight / 6.0 * ((self.tension - normal) * open + shear * slide);
        }
        self.factor * sum * (to - from) * length
    }
}
