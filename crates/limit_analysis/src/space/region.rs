//! The box about the plate's end, and what a place in it is: how long tetrahedra may be there, and where vertices may move.

use super::corners;
use super::shake::shake;
use super::simplices::Simplices;

/// Coordinates of places are multiples of this, so that those halfway between them are exact.
pub(super) const GRAIN: f64 = 1.0 / 65_536.0;

/// A box in units of the plate's depth: planes that cut it.
#[derive(Debug, Clone)]
pub(super) struct Region {
    pub(super) planes: [Vec<f64>; 3],
}

impl Region {
    /// As measured at 30 and 40 degrees, with about a thousand tetrahedra: ahead and beside the end wedges get longer and wider
    /// with friction; along the plate a box that reaches farther could hold more of what the end does, but needs more tetrahedra.
    /// A narrow plate has its middle where the box ends.
    pub(super) fn new(phi_deg: f64, width_ratio: f64) -> Self {
        let more = (phi_deg - 30.0) / 10.0;
        let grain = |x: f64| (x * 64.0).round() / 64.0;
        let ahead = grain((6.0 + more).clamp(5.0, 9.0));
        let beside = grain((1.0 + 0.125 * more).clamp(0.75, 1.5));
        let inwards = (0.5 * width_ratio).min(0.625);
        Self {
            planes: [
                vec![-2.0, -1.0, 0.0, 1.0, 2.0, 3.0, ahead],
                vec![-inwards, 0.0, beside],
                vec![-2.0, -1.0, 0.0],
            ],
        }
    }

    /// The first mesh: coarse, and coarser far from the plate.
    pub(super) fn first(&self) -> Simplices<3, 4> {
        let mut mesh = self.filled();
        mesh.cut_until(|place| 2.4 * (1.0 + from_face(place) - 0.5).clamp(1.0, 5.0));
        corners::cut(&mut mesh, self);
        shake(&mut mesh, self, 0);
        mesh
    }

    /// Tetrahedra that fill it: six in each cell of the planes, about one of its diagonals (Kuhn 1960).
    fn filled(&self) -> Simplices<3, 4> {
        let counts = [0, 1, 2].map(|k| self.planes[k].len());
        let at = |[i, j, k]: [usize; 3]| (i * counts[1] + j) * counts[2] + k;
        let mut vertices = Vec::new();
        for &x in &self.planes[0] {
            for &s in &self.planes[1] {
                vertices.extend(self.planes[2].iter().map(|&z| [x, s, z]));
            }
        }
        let mut cells = Vec::new();
        for i in 0..counts[0] - 1 {
            for j in 0..counts[1] - 1 {
                for k in 0..counts[2] - 1 {
                    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                        let mut way = [i, j, k];
                        let mut cell = [at(way); 4];
                        for (next, axis) in order.into_iter().enumerate() {
                            way[axis] += 1;
                            cell[next + 1] = at(way);
                        }
                        cells.push(cell);
                    }
                }
            }
        }
        let parents = (0..cells.len()).collect();
        Simplices::new(vertices, cells, parents)
    }

    /// Whether a coordinate of a place is that of a plane of the box, of the plate or of its rim.
    pub(super) fn holds(&self, [x, s, z]: [f64; 3], axis: usize) -> bool {
        let value = [x, s, z][axis];
        let planes = &self.planes[axis];
        let on_rim = [true, s == 0.0, z == -1.0][axis];
        value == planes[0] || value == planes[planes.len() - 1] || on_plate([x, s, z]) && on_rim
    }
}

/// Whether a place is on the plate, with its rim.
pub(super) fn on_plate([x, s, z]: [f64; 3]) -> bool {
    x == 0.0 && s <= 0.0 && z >= -1.0
}

/// Distance from the face of the plate.
pub(super) fn from_face([x, s, z]: [f64; 3]) -> f64 {
    let out = |over: f64| over.max(0.0);
    (x * x + out(s).powi(2) + out(-1.0 - z).powi(2)).sqrt()
}
