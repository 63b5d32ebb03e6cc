use super::grid::grid;
use super::{Random, backward, forward, lines, on, soil};
use crate::{Condition, Mesh, Objective, Place, Region, Statement};

/// A thin plate from the surface of a half-space downwards, two deep, `lean` to the right for each unit of depth.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plate {
    pub(crate) lean: f64,
    pub(crate) delta_deg: f64,
    pub(crate) surcharge: f64,
    pub(crate) gravity: [f64; 2],
}

/// Index of the plate's line.
pub(crate) const PLATE: usize = 4;

impl Plate {
    pub(crate) fn statement(self) -> Statement {
        let face = Condition::Face { delta_deg: self.delta_deg, adhesion: 0.0 };
        let far = Condition::Far;
        Statement {
            points: vec![
                [-4.0, 0.0],
                [-4.0, -3.0],
                [4.0, -3.0],
                [4.0, 0.0],
                [0.0, 0.0],
                [2.0 * self.lean, -2.0],
            ],
            lines: lines(&[(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (4, 0)]),
            regions: vec![Region {
                loops: vec![vec![
                    forward(0),
                    forward(1),
                    forward(2),
                    forward(3),
                    forward(PLATE),
                    backward(PLATE),
                    forward(5),
                ]],
                material: soil(35.0),
            }],
            gravity: self.gravity,
            datum: 0.0,
            surcharge: self.surcharge,
            objective: Objective::Structure { velocity: [1.0, 0.0] },
            width: None,
            members: Vec::new(),
            boundaries: vec![
                on(forward(0), far),
                on(forward(1), far),
                on(forward(2), far),
                on(forward(3), Condition::Free),
                on(forward(PLATE), face),
                on(backward(PLATE), face),
                on(forward(5), Condition::Free),
            ],
        }
    }

    /// A mesh whose inner vertices are moved by up to `shake`.
    pub(crate) fn mesh(self, shake: f64, seed: u64) -> Mesh {
        let vertex = |i: usize, j: usize| {
            let (x, depth) = (i as f64 - 4.0, j as f64);
            let position = [x + self.lean * depth * (1.0 - x.abs() / 4.0), -depth];
            let place = match (i, j) {
                (0, 0) => Place::Corner { point: 0 },
                (0, 3) => Place::Corner { point: 1 },
                (8, 3) => Place::Corner { point: 2 },
                (8, 0) => Place::Corner { point: 3 },
                (4, 0) => Place::Corner { point: 4 },
                (4, 2) => Place::Corner { point: 5 },
                (4, 1) => Place::OnLine { line: PLATE, s: 0.5 },
                (0, _) => Place::OnLine { line: 0, s: depth / 3.0 },
                (8, _) => Place::OnLine { line: 2, s: 1.0 - depth / 3.0 },
                (_, 0) if i > 4 => Place::OnLine { line: 3, s: 1.0 - x / 4.0 },
                (_, 0) => Place::OnLine { line: 5, s: -x / 4.0 },
                (_, 3) => Place::OnLine { line: 1, s: (i as f64 + self.lean * 0.25) / 8.0 },
                _ => Place::Inside,
            };
            (position, place)
        };
        // Cells are cut away from the plate, so that it is next to one vertex of the surface only.
        let mut mesh = grid(8, 3, vertex, |i| i < 4);
        let mut random = Random::new(seed);
        for v in mesh.vertices.iter_mut().filter(|v| v.place == Place::Inside) {
            v.position = v.position.map(|x| x + shake * random.next());
        }
        mesh
    }
}
