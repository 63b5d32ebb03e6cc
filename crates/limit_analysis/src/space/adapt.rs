//! Where the next mesh is finer: where the soil yields most.

use super::program::Assembled;
use super::region::from_face;
use super::shake::volume;
use super::simplices::Simplices;

/// Bisects tetrahedra until there are so many, those first that yield most for their size.
pub(super) fn refine(mesh: &mut Simplices<3, 4>, assembled: &Assembled, multipliers: &[f64], most: usize) {
    let old = mesh.cells.clone();
    let share = |cell| assembled.yielding(0, cell, multipliers) * volume(mesh, cell).abs().sqrt();
    for cell in ranked((0..old.len()).map(share)) {
        if mesh.cells.len() >= most {
            return;
        }
        // Not those that were bisected on the way of another.
        if mesh.cells[cell] == old[cell] {
            mesh.cut(cell);
        }
    }
}

/// Numbers of what has these shares, the largest first.
fn ranked(shares: impl Iterator<Item = f64>) -> Vec<usize> {
    let shares: Vec<f64> = shares.collect();
    let mut order: Vec<usize> = (0..shares.len()).collect();
    order.sort_by(|&a, &b| shares[b].total_cmp(&shares[a]).then(a.cmp(&b)));
    order
}

/// How long edges of the section may be.
#[derive(Debug, Default)]
pub(super) struct Lengths {
    /// Triangles of the section before, and how long edges may be in each.
    triangles: Vec<([[f64; 2]; 3], f64)>,
}

impl Lengths {
    /// The share of triangles that are made smaller in one step.
    const SHARE: f64 = 0.3;
    /// How much shorter their edges become: most are bisected, some twice.
    const SHORTER: f64 = 0.6;
    /// About how many triangles are asked for; faces of tetrahedra that are cut add to them. With twice as many the force of a plate
    /// without ends grows by less than 0.5 %.
    const MOST: usize = 700;

    /// Shorter where a section yielded most for its size.
    pub(super) fn new(section: &Simplices<2, 3>, assembled: &Assembled, multipliers: &[f64]) -> Self {
        let count = section.cells.len();
        let volume = |cell: usize| assembled.section.0.cells[cell].volume;
        let share = |cell| assembled.yielding(1, cell, multipliers) * volume(cell).sqrt();
        // Each becomes three or so, with those that are cut beside it.
        let chosen = (Self::SHARE * count as f64).min(Self::MOST.saturating_sub(count) as f64 / 2.0) as usize;
        // A little longer, so that rounding does not decide.
        let now = |cell| 1.000_001 * section.length(cell);
        let mut triangles: Vec<_> = (0..count)
            .map(|cell| (section.cells[cell].map(|corner| section.vertices[corner]), now(cell)))
            .collect();
        for cell in ranked((0..count).map(share)).into_iter().take(chosen) {
            triangles[cell].1 *= Self::SHORTER;
        }
        Self { triangles }
    }

    /// At a place; at first by the distance from the plate.
    pub(super) fn at(&self, place: [f64; 2]) -> f64 {
        let within = |[a, b, c]: &[[f64; 2]; 3]| {
            let side = |a: &[f64; 2], b: &[f64; 2]| {
                (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0])
            };
            let sides = [side(a, b), side(b, c), side(c, a)];
            sides.iter().all(|&x| x >= 0.0) || sides.iter().all(|&x| x <= 0.0)
        };
        let found = self.triangles.iter().find(|(corners, _)| within(corners));
        found.map_or_else(|| 0.5 + 0.3 * from_face([place[0], -1.0, place[1]]), |(_, length)| *length)
    }
}
