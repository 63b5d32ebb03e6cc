//! Moves free vertices to better places, with the triangles kept.

use spade::Triangulation;

use super::triangulation::FRAME;
use super::work::{Kind, Work};
use crate::vector::{Point, between, circumcentre, distance, shape, twice_area};

/// A move may lower the worst shape around a vertex as long as it stays above this.
const GOOD: f64 = 0.8;

/// Triangles around each node.
struct Stars {
    start: Vec<usize>,
    triangles: Vec<[usize; 3]>,
}

impl Stars {
    fn of(&self, node: usize) -> &[[usize; 3]] {
        &self.triangles[self.start[node]..self.start[node + 1]]
    }
}

impl Work<'_> {
    /// Smooths in a number of passes. Vertices on lines and guides stay; no triangle is turned over, and the worst
    /// triangle around a vertex does not get worse unless it stays good. Triangulate anew afterwards.
    pub(super) fn smooth(&mut self, passes: usize) {
        let stars = self.stars();
        for _ in 0..passes {
            for node in FRAME..self.nodes.len() {
                if matches!(self.nodes[node].kind, Kind::Free(_)) {
                    self.improve(node, stars.of(node));
                }
            }
        }
    }

    /// The triangles around each node, each with that node first.
    fn stars(&self) -> Stars {
        let mut start = vec![0; self.nodes.len() + 1];
        let faces = || self.cdt.inner_faces().map(|f| f.vertices().map(|v| v.index()));
        faces().flatten().for_each(|v| start[v + 1] += 1);
        for i in 1..start.len() {
            start[i] += start[i - 1];
        }
        let mut end = start.clone();
        let mut triangles = vec![[0; 3]; start[self.nodes.len()]];
        for t in faces() {
            for i in 0..3 {
                triangles[end[t[i]]] = [t[i], t[(i + 1) % 3], t[(i + 2) % 3]];
                end[t[i]] += 1;
            }
        }
        Stars { start, triangles }
    }

    fn improve(&mut self, node: usize, star: &[[usize; 3]]) {
        let old = self.nodes[node].at;
        let before = self.worst(star, old);
        let centre = self.spring_centre(node, star);
        let candidates = [centre, self.weighted_centre(star), [0, 1].map(|d| 0.5 * (old[d] + centre[d]))];
        for (i, p) in candidates.into_iter().enumerate() {
            let after = self.worst(star, p);
            if after > before || (i == 0 && after > GOOD) {
                self.nodes[node].at = p;
                return;
            }
        }
    }

    /// The worst shape of the triangles around a vertex if it were at `p`.
    fn worst(&self, star: &[[usize; 3]], p: Point) -> f64 {
        star.iter().map(|t| shape([p, self.nodes[t[1]].at, self.nodes[t[2]].at])).fold(1.0, f64::min)
    }

    /// Where springs from the neighbours, as long as the wanted size, would push the vertex: the mean of the places
    /// that each neighbour would have it at.
    fn spring_centre(&self, node: usize, star: &[[usize; 3]]) -> Point {
        let here = self.nodes[node];
        let mut sum = [0.0; 2];
        for t in star {
            let neighbour = self.nodes[t[1]];
            let way = between(neighbour.at, here.at);
            let pull = 0.5 * (here.size + neighbour.size) / distance(neighbour.at, here.at);
            for d in 0..2 {
                sum[d] += neighbour.at[d] + way[d] * pull;
            }
        }
        sum.map(|s| s / star.len() as f64)
    }

    /// Mean of the circumcentres of the triangles around a vertex, weighted with area over the square of the wanted
    /// size ("optimal Delaunay triangulation", L. Chen, 2004).
    fn weighted_centre(&self, star: &[[usize; 3]]) -> Point {
        let (mut sum, mut weights) = ([0.0; 2], 0.0);
        for t in star {
            let at = t.map(|n| self.nodes[n].at);
            let size = t.iter().map(|&n| self.nodes[n].size).sum::<f64>();
            let weight = twice_area(at) / (size * size);
            let centre = circumcentre(at);
            for d in 0..2 {
                sum[d] += weight * centre[d];
            }
            weights += weight;
        }
        sum.map(|s| s / weights)
    }
}
