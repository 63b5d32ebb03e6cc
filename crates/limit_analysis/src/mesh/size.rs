//! A size field from samples.

use super::MeshError;
use crate::vector::{Point, distance};

/// Most samples in a leaf of the tree.
const LEAF: usize = 8;

/// A wanted size everywhere, from samples at scattered points such as the triangles of a mesh that was: the least, over
/// all samples, of the sample's size plus `growth` times the distance from it. So it is graded from the start, and a
/// small size is never missed.
#[derive(Debug, Clone)]
pub struct SizeField {
    /// Points and sizes, in the order of the tree.
    samples: Vec<(Point, f64)>,
    /// A complete binary tree of halves; a node's children are at `2 i + 1` and `2 i + 2`.
    nodes: Vec<Node>,
    range: [f64; 2],
    growth: f64,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    low: Point,
    high: Point,
    /// Least size of the samples below.
    least: f64,
}

impl Node {
    /// No sample below makes the size at `p` smaller than this.
    fn bound(&self, p: Point, growth: f64) -> f64 {
        let d = [0, 1].map(|d| (self.low[d] - p[d]).max(p[d] - self.high[d]).max(0.0));
        self.least + growth * d[0].hypot(d[1])
    }
}

impl SizeField {
    /// The field through `sizes` (m, positive) at `points`, kept between `min` and `max` (m). `growth` is the
    /// growth of the size per unit of distance, from 0 (the least size everywhere); 0.3 suits [`super::generate`].
    ///
    /// # Errors
    ///
    /// [`MeshError::BadField`] without samples, with different numbers of points and sizes, with values that are not
    /// finite, with sizes that are not positive, unless 0 < `min` <= `max`,
    /// and for a negative growth.
    pub fn new(
        points: &[[f64; 2]],
        sizes: &[f64],
        min: f64,
        max: f64,
        growth: f64,
    ) -> Result<Self, MeshError> {
        let bad = |what, value, allowed| Err(MeshError::BadField { what, value, allowed });
        if points.is_empty() || points.len() != sizes.len() {
            return bad("the number of sizes", sizes.len() as f64, "the number of points, and at least 1");
        }
        if !(min > 0.0 && min.is_finite()) {
            return bad("the smallest size", min, "positive and finite");
        }
        if !(max >= min && max.is_finite()) {
            return bad("the largest size", max, "finite and at least the smallest");
        }
        if !(growth >= 0.0 && growth.is_finite()) {
            return bad("the growth", growth, "finite and not negative");
        }
        if let Some(&size) = sizes.iter().find(|s| s.is_nan() || **s <= 0.0) {
            return bad("a size", size, "positive");
        }
        if let Some(&c) = points.iter().flatten().find(|c| !c.is_finite()) {
            return bad("a coordinate", c, "finite");
        }
        let sizes = sizes.iter().map(|s| s.clamp(min, max));
        let mut samples: Vec<(Point, f64)> = points.iter().copied().zip(sizes).collect();
        let mut count = 1;
        while samples.len() > LEAF * count {
            count *= 2;
        }
        let mut nodes = vec![Node { low: [0.0; 2], high: [0.0; 2], least: 0.0 }; 2 * count - 1];
        build(&mut samples, &mut nodes, 0);
        Ok(Self { samples, nodes, range: [min, max], growth })
    }

    /// The wanted size (m) at a point.
    pub fn size(&self, p: [f64; 2]) -> f64 {
        let mut best = self.range[1];
        self.search(p, 0, 0..self.samples.len(), &mut best);
        best.max(self.range[0])
    }

    fn search(&self, p: Point, node: usize, range: std::ops::Range<usize>, best: &mut f64) {
        let children = [2 * node + 1, 2 * node + 2];
        if children[0] >= self.nodes.len() {
            for &(at, size) in &self.samples[range] {
                *best = best.min(size + self.growth * distance(at, p));
            }
            return;
        }
        let middle = range.start + range.len() / 2;
        let halves = [range.start..middle, middle..range.end];
        let bounds = children.map(|c| self.nodes[c].bound(p, self.growth));
        let order = if bounds[0] <= bounds[1] { [0, 1] } else { [1, 0] };
        for i in order {
            if bounds[i] < *best {
                self.search(p, children[i], halves[i].clone(), best);
            }
        }
    }
}

/// Sorts the samples into halves, across the longer side each time.
fn build(samples: &mut [(Point, f64)], nodes: &mut [Node], node: usize) {
    let (mut low, mut high, mut least) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], f64::INFINITY);
    for &(p, size) in samples.iter() {
        for d in 0..2 {
            low[d] = low[d].min(p[d]);
            high[d] = high[d].max(p[d]);
        }
        least = least.min(size);
    }
    nodes[node] = Node { low, high, least };
    if 2 * node + 2 >= nodes.len() {
        return;
    }
    let d = usize::from(high[1] - low[1] > high[0] - low[0]);
    let middle = samples.len() / 2;
    samples.select_nth_unstable_by(middle, |a, b| a.0[d].total_cmp(&b.0[d]));
    let (left, right) = samples.split_at_mut(middle);
    build(left, nodes, 2 * node + 1);
    build(right, nodes, 2 * node + 2);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tree_agrees_with_a_search_through_all_samples() {
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let points: Vec<Point> = (0..1000).map(|_| [random(), random()]).collect();
        let sizes: Vec<f64> = (0..1000).map(|_| 0.001 + random().powi(8)).collect();
        let field = SizeField::new(&points, &sizes, 0.002, 0.1, 0.3).unwrap();
        for _ in 0..1000 {
            let p = [2.0 * random() - 0.5, 2.0 * random() - 0.5];
            let least = points.iter().zip(&sizes).map(|(&q, s)| s.clamp(0.002, 0.1) + 0.3 * distance(p, q));
            assert_eq!(field.size(p), least.fold(0.1, f64::min));
        }
        assert_eq!(SizeField::new(&points[..1], &[0.01], 0.002, 0.1, 0.3).unwrap().size(points[0]), 0.01);
    }

    #[test]
    fn refuses_what_is_no_field() {
        let fails = |points: &[Point], sizes: &[f64], min, max| {
            matches!(SizeField::new(points, sizes, min, max, 0.3), Err(MeshError::BadField { .. }))
        };
        assert!(fails(&[], &[], 1.0, 2.0));
        assert!(fails(&[[0.0, 0.0]], &[1.0, 1.0], 1.0, 2.0));
        assert!(fails(&[[0.0, 0.0]], &[f64::NAN], 1.0, 2.0));
        assert!(fails(&[[0.0, f64::NAN]], &[1.0], 1.0, 2.0));
        assert!(fails(&[[0.0, 0.0]], &[1.0], 2.0, 1.0));
        assert!(fails(&[[0.0, 0.0]], &[1.0], 0.0, 1.0));
    }
}
