//! Triangles or tetrahedra that are bisected and stay conforming.
//!
//! A simplex is bisected at its longest edge, and all that share this edge with it. Where one of those has a longer edge, that is
//! cut first (Rivara 1991, the longest-edge propagation path). Ties are broken by the numbers of vertices, so that there is one
//! longest edge, and the path, along which edges grow, ends.

use std::cmp::Ordering;
use std::collections::BTreeMap;

/// An edge, its lesser vertex first.
type Edge = [usize; 2];

/// Simplices of `M = N + 1` vertices in `N` dimensions.
#[derive(Debug, Clone)]
pub(super) struct Simplices<const N: usize, const M: usize> {
    pub(super) vertices: Vec<[f64; N]>,
    pub(super) cells: Vec<[usize; M]>,
    /// What each was cut from.
    pub(super) parents: Vec<usize>,
    /// The simplices at each edge.
    around: BTreeMap<Edge, Vec<usize>>,
}

impl<const N: usize, const M: usize> Simplices<N, M> {
    /// Each with the number of its own, or that of what it is a part of.
    pub(super) fn new(vertices: Vec<[f64; N]>, cells: Vec<[usize; M]>, parents: Vec<usize>) -> Self {
        let mut around: BTreeMap<Edge, Vec<usize>> = BTreeMap::new();
        for (i, cell) in cells.iter().enumerate() {
            edges(cell).for_each(|edge| around.entry(edge).or_default().push(i));
        }
        Self { vertices, cells, parents, around }
    }

    /// Bisects all that have an edge longer than allowed at their centroids, until none has.
    pub(super) fn cut_until(&mut self, longest: impl Fn([f64; N]) -> f64) {
        loop {
            let before = self.cells.len();
            let mut next = 0;
            while next < self.cells.len() {
                while self.length(next) > longest(self.centroid(next)) {
                    self.cut(next);
                }
                next += 1;
            }
            // Halves of those that came first may be where shorter ones are wanted.
            if self.cells.len() == before {
                return;
            }
        }
    }

    /// Bisects one, after what must be before it.
    pub(super) fn cut(&mut self, cell: usize) {
        let own = self.longest(&self.cells[cell]);
        loop {
            let mut edge = own;
            while let Some(longer) = self.longer(edge) {
                edge = longer;
            }
            self.bisect(edge);
            if edge == own {
                return;
            }
        }
    }

    /// The length of the longest edge.
    pub(super) fn length(&self, cell: usize) -> f64 {
        self.square(self.longest(&self.cells[cell])).sqrt()
    }

    /// A centroid.
    pub(super) fn centroid(&self, cell: usize) -> [f64; N] {
        std::array::from_fn(|k| self.cells[cell].iter().map(|&c| self.vertices[c][k]).sum::<f64>() / M as f64)
    }

    /// All edges.
    pub(super) fn edges(&self) -> impl Iterator<Item = &Edge> {
        self.around.keys()
    }

    fn square(&self, [a, b]: Edge) -> f64 {
        self.vertices[a].iter().zip(&self.vertices[b]).map(|(x, y)| (x - y) * (x - y)).sum()
    }

    fn order(&self, a: Edge, b: Edge) -> Ordering {
        self.square(a).total_cmp(&self.square(b)).then(a.cmp(&b))
    }

    fn longest(&self, cell: &[usize; M]) -> Edge {
        edges(cell).fold([cell[0].min(cell[1]), cell[0].max(cell[1])], |longest, edge| {
            if self.order(edge, longest) == Ordering::Greater { edge } else { longest }
        })
    }

    /// The longest edge of the simplices at an edge, if that is another.
    fn longer(&self, edge: Edge) -> Option<Edge> {
        let all = self.around.get(&edge)?.iter().map(|&cell| self.longest(&self.cells[cell]));
        all.max_by(|&a, &b| self.order(a, b)).filter(|&longest| longest != edge)
    }

    /// Bisects all simplices at an edge.
    pub(super) fn bisect(&mut self, edge: Edge) {
        let Some(cells) = self.around.remove(&edge) else { return };
        let middle = self.vertices.len();
        let [a, b] = edge.map(|end| self.vertices[end]);
        self.vertices.push(std::array::from_fn(|k| 0.5 * (a[k] + b[k])));
        for cell in cells {
            let old = self.cells[cell];
            let new = self.cells.len();
            let [left, right] = [edge[1], edge[0]].map(|out| old.map(|c| if c == out { middle } else { c }));
            for at in edges(&old) {
                if let Some(list) = self.around.get_mut(&at) {
                    list.retain(|&other| other != cell);
                }
            }
            self.cells[cell] = left;
            self.cells.push(right);
            self.parents.push(self.parents[cell]);
            for (number, half) in [(cell, left), (new, right)] {
                edges(&half).for_each(|at| self.around.entry(at).or_default().push(number));
            }
        }
    }
}

/// The edges of a simplex.
fn edges<const M: usize>(cell: &[usize; M]) -> impl Iterator<Item = Edge> {
    (0..M).flat_map(move |j| (0..j).map(move |i| [cell[i].min(cell[j]), cell[i].max(cell[j])]))
}
