use super::grid::grid;
use super::{forward, lines, on, soil};
use crate::{
    Condition, Flow, Gauge, Gradient, Jet, LowerField, Mesh, Objective, Place, Region, Statement, Triangle,
    UpperField, Velocity, Vertex, VertexCopy,
};

/// A smooth vertical wall, two high, pushed against level soil of unit weight one with a friction of 30 degrees. The
/// force is `Kp h^2/2` = 6 exactly (Rankine 1857).
pub(crate) fn wall() -> Statement {
    let face = Condition::Face { delta_deg: 0.0, adhesion: 0.0 };
    let conditions = [face, Condition::Fixed, Condition::Fixed, Condition::Free];
    Statement {
        points: vec![[0.0, 0.0], [0.0, -2.0], [4.0, -2.0], [4.0, 0.0]],
        lines: lines(&[(0, 1), (1, 2), (2, 3), (3, 0)]),
        regions: vec![Region {
            loops: vec![vec![forward(0), forward(1), forward(2), forward(3)]],
            material: soil(30.0),
        }],
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        objective: Objective::Structure { velocity: [1.0, 0.0] },
        width: None,
        members: Vec::new(),
        boundaries: conditions.into_iter().enumerate().map(|(l, c)| on(forward(l), c)).collect(),
    }
}

/// The place of a point of the rectangle.
fn place([x, y]: [f64; 2]) -> Place {
    match (x, y) {
        (0.0, 0.0) => Place::Corner { point: 0 },
        (0.0, -2.0) => Place::Corner { point: 1 },
        (4.0, -2.0) => Place::Corner { point: 2 },
        (4.0, 0.0) => Place::Corner { point: 3 },
        (0.0, _) => Place::OnLine { line: 0, s: -y / 2.0 },
        (4.0, _) => Place::OnLine { line: 2, s: 1.0 + y / 2.0 },
        (_, -2.0) => Place::OnLine { line: 1, s: x / 4.0 },
        (_, 0.0) => Place::OnLine { line: 3, s: 1.0 - x / 4.0 },
        _ => Place::Inside,
    }
}

/// Rankine's stress field for [`wall`], with the horizontal stress `kp` times the vertical one, on cells of size `4/n`.
pub(crate) fn rankine_field(n: usize, kp: f64) -> LowerField {
    pushed_field(n, kp - 1.0, 0.0)
}

/// A stress field for [`wall`] with the pressure `push * depth + more` beyond that at rest. With `more`, there must be
/// surcharge or cohesion.
pub(crate) fn pushed_field(n: usize, push: f64, more: f64) -> LowerField {
    let size = 4.0 / n as f64;
    let vertex = |i: usize, j: usize| {
        let p = [i as f64 * size, -(j as f64 * size)];
        (p, place(p))
    };
    let mesh = grid(n, n / 2, vertex, |_| false);
    // f_yy = push y - more.
    let along_y = |y: f64| (push * y * y * y / 6.0 - more * y * y / 2.0, push * y * y / 2.0 - more * y);
    let copies = mesh.vertices.iter().enumerate().map(|(vertex, v)| {
        let [x, y] = v.position;
        let (f, fy) = along_y(y);
        let jet = match (x, y) {
            (_, 0.0) => Jet::Gauge { gauge: 0 },
            (_, y) if y == -size && more == 0.0 => Jet::ManyApexes { base: 0, f },
            // n = (2, 0)
            (0.0, _) => Jet::OneLine { line: 0, f, along: -fy / 2.0 },
            _ => Jet::Free { base: 0, f, fx: 0.0, fy },
        };
        VertexCopy { vertex, jet }
    });
    let copies = copies.collect();
    let slope = |t: &Triangle, k: usize| {
        let [a, b] = [1, 2].map(|i| mesh.vertices[t.corners[(k + i) % 3]].position);
        let y = (a[1] + b[1]) / 2.0;
        (b[0] - a[0]) * along_y(y).1
    };
    LowerField {
        corners: mesh.triangles.iter().map(|t| t.corners).collect(),
        slopes: mesh.triangles.iter().map(|t| [0, 1, 2].map(|k| slope(t, k))).collect(),
        copies,
        gauges: vec![Gauge { constant: 0.0, gradient: Gradient::Free { x: 0.0, y: 0.0 } }],
        lines: vec![0.0; 4],
        far_stress: 0.0,
        multiplier: 0.0,
        mesh,
    }
}

/// Coulomb's wedge for [`wall`]: bounded by a slip line from the foot of the wall at 30 degrees to the level, it moves at
/// `up` vertically for each unit horizontally; `sqrt(3)` is the least that the friction allows.
pub(crate) fn wedge_field(up: f64) -> UpperField {
    let at = |position: [f64; 2]| Vertex { position, place: place(position) };
    let top = 12.0_f64.sqrt();
    let vertices = vec![at([0.0, 0.0]), at([0.0, -2.0]), at([4.0, -2.0]), at([4.0, 0.0]), at([top, 0.0])];
    let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4]].map(|corners| Triangle { corners, region: 0 });
    let mesh = Mesh { vertices, triangles: triangles.to_vec() };
    UpperField {
        mesh,
        flows: [[0, 1, 2, 3, 4, 5], [6; 6], [6; 6]].map(Flow::Quadratic).to_vec(),
        velocities: [vec![Velocity::Free { x: 1.0, y: up }; 6], vec![Velocity::Zero]].concat(),
        stream: Vec::new(),
        walls: Vec::new(),
        members: Vec::new(),
    }
}
