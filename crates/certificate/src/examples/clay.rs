//! Blocks of soil without friction, with flows by stream functions.

use super::grid::grid;
use super::{forward, lines, on, soil};
use crate::{
    Condition, Flow, Linear, Mesh, Objective, Place, Region, Statement, StreamCopy, StreamJet, Triangle,
    UpperField,
};

/// A block from 0 to `width` and from `-height` to 0, cohesion one, no weight. Lines 0 to 3 are its left side, its bottom,
/// its right side and its top, counter-clockwise.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Block {
    pub(crate) fn statement(self, conditions: [Condition; 4], objective: Objective) -> Statement {
        let Self { width, height } = self;
        let mut material = soil(0.0);
        material.cohesion = Linear::uniform(1.0);
        material.unit_weight = 0.0;
        Statement {
            points: vec![[0.0, 0.0], [0.0, -height], [width, -height], [width, 0.0]],
            lines: lines(&[(0, 1), (1, 2), (2, 3), (3, 0)]),
            regions: vec![Region { loops: vec![[0, 1, 2, 3].map(forward).to_vec()], material }],
            gravity: [0.0, -1.0],
            datum: 0.0,
            surcharge: 0.0,
            objective,
            width: None,
            members: Vec::new(),
            boundaries: conditions.into_iter().enumerate().map(|(l, c)| on(forward(l), c)).collect(),
        }
    }

    /// A mesh of `n[0]` by `n[1]` cells.
    pub(crate) fn mesh(self, n: [usize; 2]) -> Mesh {
        let Self { width, height } = self;
        let vertex = |i: usize, j: usize| {
            let [s, t] = [i as f64 / n[0] as f64, j as f64 / n[1] as f64];
            let line = |line, s| Place::OnLine { line, s };
            let place = match (i, j) {
                (0, 0) => Place::Corner { point: 0 },
                (0, j) if j == n[1] => Place::Corner { point: 1 },
                (i, j) if i == n[0] && j == n[1] => Place::Corner { point: 2 },
                (i, 0) if i == n[0] => Place::Corner { point: 3 },
                (0, _) => line(0, t),
                (_, j) if j == n[1] => line(1, s),
                (i, _) if i == n[0] => line(2, 1.0 - t),
                (_, 0) => line(3, 1.0 - s),
                _ => Place::Inside,
            };
            ([width * s, -height * t], place)
        };
        grid(n[0], n[1], vertex, |i| i % 2 == 1)
    }
}

/// The flow of a stream function, from its value and slopes, on a mesh without boundaries inside, with one copy for each
/// vertex. Says for each line of the statement to which wall it belongs, and for each wall what its value is.
pub(crate) fn stream_field(
    statement: &Statement,
    mesh: &Mesh,
    wall_of: &[Option<usize>],
    walls: &[f64],
    stream: impl Fn([f64; 2]) -> [f64; 3],
) -> UpperField {
    let normal = |line: usize| {
        let l = statement.lines[line];
        let [p, q] = [l.from, l.to].map(|i| statement.points[i]);
        [p[1] - q[1], q[0] - p[0]]
    };
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let copies = mesh.vertices.iter().enumerate().map(|(vertex, v)| {
        let [s, sx, sy] = stream(v.position);
        let on: Vec<usize> = match v.place {
            Place::Inside => Vec::new(),
            Place::OnLine { line, .. } => vec![line],
            Place::Corner { point } => (0..statement.lines.len())
                .filter(|l| statement.lines[*l].from == point || statement.lines[*l].to == point)
                .collect(),
        };
        let on: Vec<(usize, usize)> = on.iter().filter_map(|l| Some((*l, wall_of[*l]?))).collect();
        let jet = match on.as_slice() {
            [] => StreamJet::Free { s, sx, sy },
            [(line, wall)] => {
                let n = normal(*line);
                StreamJet::Wall { wall: *wall, line: *line, across: dot([sx, sy], n) / dot(n, n) }
            }
            [(_, wall), ..] => StreamJet::Corner { wall: *wall },
        };
        StreamCopy { vertex, jet }
    });
    let slope = |t: &Triangle, k: usize| {
        let [a, b] = [1, 2].map(|i| mesh.vertices[t.corners[(k + i) % 3]].position);
        let [_, sx, sy] = stream([(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]);
        sy * (b[0] - a[0]) - sx * (b[1] - a[1])
    };
    let flow = |t: &Triangle| Flow::Stream { corners: t.corners, slopes: [0, 1, 2].map(|k| slope(t, k)) };
    UpperField {
        mesh: mesh.clone(),
        flows: mesh.triangles.iter().map(flow).collect(),
        velocities: Vec::new(),
        stream: copies.collect(),
        walls: walls.to_vec(),
        members: Vec::new(),
    }
}

/// A block between smooth plates that is pressed from above: twice the cohesion is the greatest mean pressure, which
/// level stress-free soil beside it shows from below and [`pressed_field`] from above.
pub(crate) fn pressed() -> (Block, Statement) {
    let block = Block { width: 2.0, height: 1.0 };
    let load = Condition::Loaded { pressure: [1.0; 2], shear: [0.0; 2], live: true };
    let conditions = [Condition::Smooth, Condition::Smooth, Condition::Free, load];
    (block, block.statement(conditions, Objective::Loads))
}

/// Uniform stretching along x and shortening along y, with smooth sides on the left and below.
pub(crate) fn pressed_field(block: Block, statement: &Statement, n: [usize; 2]) -> UpperField {
    let stream = |[x, y]: [f64; 2]| [x * (y + block.height), y + block.height, x];
    stream_field(statement, &block.mesh(n), &[Some(0), Some(0), None, None], &[0.0], stream)
}
