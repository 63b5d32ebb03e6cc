//! The upper bound: the least force that some flow of the soil, its dilation as large as its friction demands, allows.
//!
//! Velocities are quadratic on six-node triangles and may jump across guides and structure faces (Makrodimopoulos &
//! Martin 2007, 2008).

mod motion;

use soilctl_certificate::{Condition, Flow, UpperField, Velocity as Saved};

use motion::{Motion, motions};

use crate::form::Form;
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::program::Program;
use crate::topology::{Side, Topology};

/// Velocity of a node.
pub(crate) type Velocity = [Form; 2];

#[derive(Debug)]
pub(crate) struct Upper {
    pub(crate) program: Program,
    /// Control points of each triangle: corners, then those of the edges opposite to them.
    pub(crate) nodes: Vec<[usize; 6]>,
    motions: Vec<Motion>,
    pub(crate) velocities: Vec<Velocity>,
    /// What the program minimises: the force on the structure.
    pub(crate) force: Form,
}

/// Gradients at corner `k` of the Bernstein polynomials that belong to the control points.
pub(crate) fn gradients(v: &[[f64; 2]; 3], k: usize) -> [[f64; 2]; 6] {
    let double = (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]);
    let g: [[f64; 2]; 3] = std::array::from_fn(|i| {
        let (a, b) = (v[(i + 1) % 3], v[(i + 2) % 3]);
        [(a[1] - b[1]) / double, (b[0] - a[0]) / double]
    });
    let mut rows = [[0.0; 2]; 6];
    for axis in 0..2 {
        rows[k][axis] = 2.0 * g[k][axis];
        for i in (0..3).filter(|i| *i != k) {
            // The edge between corners k and i lies opposite to the third.
            rows[3 + (3 - k - i)][axis] = 2.0 * g[i][axis];
        }
    }
    rows
}

impl Upper {
    pub(crate) fn new(
        problem: &Problem,
        mesh: &Mesh,
        topology: &Topology,
        still: &[bool],
        tighten: f64,
    ) -> Self {
        let mut program = Program::default();
        let condition = |s: Side| topology.line[s.triangle][s.corner].and_then(|l| problem.condition(l));
        let cut = |s: Side| condition(s).is_some() || topology.guide[s.triangle][s.corner];
        let (mut corners, vertex_of) = topology.split(mesh, cut);
        weld_sharp_bends(problem, mesh, topology, &mut corners, vertex_of.len());
        let mut count = vertex_of.len();
        let mut nodes: Vec<[usize; 6]> =
            corners.iter().map(|c| [c[0], c[1], c[2], usize::MAX, usize::MAX, usize::MAX]).collect();
        for triangle in 0..nodes.len() {
            for k in 0..3 {
                if nodes[triangle][3 + k] != usize::MAX {
                    continue;
                }
                nodes[triangle][3 + k] = count;
                if let Some(other) =
                    topology.across[triangle][k].filter(|_| !cut(Side { triangle, corner: k }))
                {
                    nodes[other.triangle][3 + other.corner] = count;
                }
                count += 1;
            }
        }
        let motions = motions(problem, mesh, topology, &nodes, count, still, &mut program);
        let velocities: Vec<Velocity> = motions.iter().map(|m| m.velocity(problem)).collect();

        let mut force = Form::default();
        for (triangle, t) in mesh.triangles.iter().enumerate() {
            let v = t.corners.map(|c| mesh.vertices[c].position);
            let soil = &problem.soils[t.region];
            let area =
                0.5 * ((v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]));
            let h = (2.0 * area).sqrt();
            let velocity = |node: usize| &velocities[nodes[triangle][node]];
            for k in 0..3 {
                let g = gradients(&v, k);
                let [mut volume, mut difference, mut shear] =
                    [Form::default(), Form::default(), Form::default()];
                for (node, [gx, gy]) in g.iter().enumerate() {
                    let [vx, vy] = velocity(node);
                    volume.add(h * gx, vx);
                    volume.add(h * gy, vy);
                    difference.add(h * gx, vx);
                    difference.add(-h * gy, vy);
                    shear.add(h * gy, vx);
                    shear.add(h * gx, vy);
                }
                if volume.terms.is_empty() {
                    continue;
                }
                force.add(soil.tension(v[0]) * area / 3.0 / h, &volume);
                let bounded = Form::constant(-tighten).plus(1.0 / soil.sin, &volume);
                program.second_order([bounded, difference, shear]);
            }
            for k in 0..3 {
                let [bx, by] = problem.statement().gravity.map(|g| -g * soil.unit_weight * area / 6.0);
                for node in [k, 3 + k] {
                    force.add(bx, &velocity(node)[0]);
                    force.add(by, &velocity(node)[1]);
                }
            }
            for k in 0..3 {
                let side = Side { triangle, corner: k };
                let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                let along = [v[b][0] - v[a][0], v[b][1] - v[a][1]];
                let length = along[0].hypot(along[1]);
                let t = [along[0] / length, along[1] / length];
                let here = [a, 3 + k, b].map(|node| velocity(node).clone());
                let (there, tan, tension): ([Velocity; 3], f64, f64) = match condition(side) {
                    Some(Condition::Face { delta_deg, adhesion }) => {
                        let rigid = || problem.velocity().map(Form::constant);
                        let tan = delta_deg.to_radians().tan();
                        let tension = if tan > 0.0 { adhesion / tan } else { 0.0 };
                        ([rigid(), rigid(), rigid()], tan, tension)
                    }
                    Some(Condition::Free) => {
                        let n = [t[1], -t[0]];
                        for v in &here {
                            let q = problem.statement().surcharge * length / 3.0;
                            force.add(q * n[0], &v[0]);
                            force.add(q * n[1], &v[1]);
                        }
                        continue;
                    }
                    Some(_) => continue,
                    None if topology.guide[triangle][k] => {
                        let Some(other) = topology.across[triangle][k] else { continue };
                        if other.triangle < triangle {
                            continue;
                        }
                        let on = |node: usize| velocities[nodes[other.triangle][node]].clone();
                        let (oa, om, ob) =
                            (on((other.corner + 2) % 3), on(3 + other.corner), on((other.corner + 1) % 3));
                        ([oa, om, ob], soil.tan, soil.tension(v[a]))
                    }
                    None => continue,
                };
                let jump: [Velocity; 3] = std::array::from_fn(|i| {
                    [here[i][0].clone().plus(-1.0, &there[i][0]), here[i][1].clone().plus(-1.0, &there[i][1])]
                });
                let component =
                    |j: &Velocity, d: [f64; 2]| Form::default().plus(d[0], &j[0]).plus(d[1], &j[1]);
                let normal = jump.each_ref().map(|j| component(j, [-t[1], t[0]]));
                let tangent = jump.each_ref().map(|j| component(j, t));
                for n in &normal {
                    force.add(tension * length / 3.0, n);
                }
                // Where the coefficients of a quadratic keep a sign, it does.
                for (n, s) in normal.iter().zip(&tangent) {
                    if n.terms.is_empty() && s.terms.is_empty() && n.constant == 0.0 {
                        continue;
                    }
                    let open = Form::constant(-tighten).plus(1.0, n);
                    if tan == 0.0 {
                        program.non_negative(open);
                    } else {
                        program.non_negative(open.clone().plus(tan, s));
                        program.non_negative(open.plus(-tan, s));
                    }
                }
            }
        }
        for &(index, coefficient) in &force.terms {
            program.objective.push((index, coefficient));
        }
        Self { program, nodes, motions, velocities, force }
    }

    /// The flow of a solution, as a certificate stores it.
    pub(crate) fn saved(&self, mesh: &Mesh, x: &[f64]) -> UpperField {
        let velocities = self
            .motions
            .iter()
            .map(|motion| match *motion {
                Motion::Still => Saved::Zero,
                Motion::Slide { line, index, unit } => Saved::Slide { line, value: unit * x[index] },
                Motion::Free { x: i, y: j } => Saved::Free { x: x[i], y: x[j] },
            })
            .collect();
        UpperField {
            mesh: crate::saved_mesh(mesh),
            flows: self.nodes.iter().map(|nodes| Flow::Quadratic(*nodes)).collect(),
            velocities,
            stream: Vec::new(),
            walls: Vec::new(),
        }
    }
}

/// Joins both sides of a guide at its sharp bends: a wedge of soil between two jumps can leave its notch only if the
/// notch is wider than twice the friction angle.
fn weld_sharp_bends(
    problem: &Problem,
    mesh: &Mesh,
    topology: &Topology,
    corners: &mut [[usize; 3]],
    count: usize,
) {
    let mut angle = vec![0.0; count];
    let mut guides = vec![Vec::new(); count];
    let mut other_rim = vec![false; count];
    for (triangle, copies) in corners.iter().enumerate() {
        for (k, &copy) in copies.iter().enumerate() {
            angle[copy] += motion::corner_angle(mesh, (triangle, k));
            for edge in [(k + 1) % 3, (k + 2) % 3] {
                let side = topology.line[triangle][edge].and_then(|l| problem.condition(l));
                if topology.guide[triangle][edge] {
                    let across = topology.across[triangle][edge].map(|o| {
                        // Corner k lies at the other end of the neighbour's sense of the edge.
                        let at = if edge == (k + 2) % 3 { (o.corner + 2) % 3 } else { (o.corner + 1) % 3 };
                        corners[o.triangle][at]
                    });
                    guides[copy].extend(across);
                } else if side.is_some() {
                    other_rim[copy] = true;
                }
            }
        }
    }
    let mut join: Vec<usize> = (0..count).collect();
    for copy in 0..count {
        let notch = 2.0 * problem.soils[0].tan.atan() + 0.1;
        if !other_rim[copy] && guides[copy].len() == 2 && angle[copy] < notch {
            let with = guides[copy][0];
            let (from, to) = (join[copy].max(join[with]), join[copy].min(join[with]));
            join.iter_mut().for_each(|j| {
                if *j == from {
                    *j = to;
                }
            });
        }
    }
    for copies in corners.iter_mut() {
        *copies = copies.map(|c| join[c]);
    }
}
