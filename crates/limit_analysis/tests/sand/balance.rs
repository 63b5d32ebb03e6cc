//! Whether stresses balance and are borne, computed from nothing but their values at nodes: no stress function, no reference.

use soilctl_certificate::{Adjoins, Condition, LowerField, ShownStress, Statement, show_stress};

/// The parts of equilibrium and strength that are farthest off, in units of the greatest unit weight times the greatest height.
#[derive(Debug)]
pub(crate) struct Worst {
    /// Stresses that do not balance the weight inside a part.
    pub(crate) inside: f64,
    /// Tractions that differ on the two sides of an edge, or from what is given on it.
    pub(crate) edges: f64,
    /// What is missing to yield.
    pub(crate) strength: f64,
}

/// Stresses of a part at its nodes, and their positions.
type Part = ([[f64; 3]; 3], [[f64; 2]; 3]);

fn part(shown: &ShownStress, triangle: usize, k: usize) -> Part {
    let v = shown.corners[triangle];
    let centre = [0, 1].map(|i| (v[0][i] + v[1][i] + v[2][i]) / 3.0);
    (shown.parts[triangle][k], [v[(k + 1) % 3], v[(k + 2) % 3], centre])
}

/// Slopes along x and y of a linear function by its values at three points.
fn slopes(values: [f64; 3], [p, q, r]: [[f64; 2]; 3]) -> [f64; 2] {
    let det = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
    let (a, b) = (values[1] - values[0], values[2] - values[0]);
    [(a * (r[1] - p[1]) - b * (q[1] - p[1])) / det, (b * (q[0] - p[0]) - a * (r[0] - p[0])) / det]
}

/// Traction times the length of the edge from `p` to `q`, the soil on its left.
fn traction([xx, yy, xy]: [f64; 3], p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    let n = [q[1] - p[1], p[0] - q[0]];
    [xx * n[0] + xy * n[1], xy * n[0] + yy * n[1]]
}

fn size(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}

/// Pore pressure of a region at a point.
fn water(statement: &Statement, region: usize, p: [f64; 2]) -> f64 {
    let u = statement.regions[region].material.pore_pressure;
    u.at_origin + u.gradient[0] * p[0] + u.gradient[1] * p[1]
}

/// Checks a field for a statement whose free sides bear no surcharge. Of cohesion there is the part that the field's factor leaves.
pub(crate) fn worst(statement: &Statement, field: &LowerField, regions: &[usize]) -> Worst {
    let shown = show_stress(statement, field).unwrap();
    let heights = || statement.points.iter().map(|p| p[1]);
    let height = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
    let weight = statement.regions.iter().map(|r| r.material.unit_weight).fold(0.0, f64::max);
    let unit = weight * height * size(statement.gravity);
    let mut worst = Worst { inside: 0.0, edges: 0.0, strength: 0.0 };
    for (triangle, region) in regions.iter().enumerate() {
        let material = &statement.regions[*region].material;
        let (sin, cos) = material.phi_deg.to_radians().sin_cos();
        for k in 0..3 {
            let (stresses, at) = part(&shown, triangle, k);
            let of = |i: usize| slopes(stresses.map(|s| s[i]), at);
            let (xx, yy, xy) = (of(0), of(1), of(2));
            let rest = [0, 1].map(|i| material.unit_weight * statement.gravity[i]);
            let off = [xx[0] + xy[1] + rest[0], xy[0] + yy[1] + rest[1]];
            let length = size([at[1][0] - at[0][0], at[1][1] - at[0][1]]);
            worst.inside = worst.inside.max(size(off) * length / unit);
            for (s, p) in stresses.iter().zip(at) {
                let cohesion = material.cohesion.at_origin
                    + material.cohesion.gradient[0] * p[0]
                    + material.cohesion.gradient[1] * p[1];
                let radius = (0.5 * (s[0] - s[1])).hypot(s[2]);
                let bears = cohesion / field.multiplier * cos
                    - (0.5 * (s[0] + s[1]) + water(statement, *region, p)) * sin;
                worst.strength = worst.strength.max((radius - bears) / unit);
            }
            // Inside a triangle the next part adjoins along the line from a corner to the centroid.
            let (beyond, _) = part(&shown, triangle, (k + 1) % 3);
            for (here, there) in [(1, 0), (2, 2)] {
                let [a, b] = [stresses[here], beyond[there]].map(|s| traction(s, at[1], at[2]));
                worst.edges = worst.edges.max(size([a[0] - b[0], a[1] - b[1]]) / (unit * length));
            }
            match shown.adjoins[triangle][k] {
                Adjoins::Soil(other) => {
                    let (beyond, _) = part(&shown, other.triangle, other.corner);
                    for (here, there) in [(0, 1), (1, 0)] {
                        let [a, b] = [stresses[here], beyond[there]].map(|s| traction(s, at[0], at[1]));
                        worst.edges = worst.edges.max(size([a[0] - b[0], a[1] - b[1]]) / (unit * length));
                    }
                }
                Adjoins::Boundary { condition: Condition::Free, .. } => {
                    for s in &stresses[..2] {
                        worst.edges = worst.edges.max(size(traction(*s, at[0], at[1])) / (unit * length));
                    }
                }
                // The water's pressure, against the outward normal, is all that acts.
                Adjoins::Boundary { condition: Condition::Submerged, .. } => {
                    for (s, p) in stresses[..2].iter().zip(at) {
                        let u = water(statement, *region, p);
                        let effective = traction([s[0] + u, s[1] + u, s[2]], at[0], at[1]);
                        worst.edges = worst.edges.max(size(effective) / (unit * length));
                    }
                }
                Adjoins::Boundary { .. } => {}
            }
        }
    }
    worst
}
