//! Densities of the ground at its top and its bottom that strokes leave: a convex polygon, cut by one line after the other.

/// A convex polygon of (density at the top, density at the bottom) in kg/m3; two corners where both are one density.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Densities(Vec<[f64; 2]>);

impl Densities {
    /// All densities of an interval at top and bottom.
    pub(super) fn all([low, high]: [f64; 2]) -> Self {
        Self(vec![[low, low], [high, low], [high, high], [low, high]])
    }

    /// One density at top and bottom.
    pub(super) fn same([low, high]: [f64; 2]) -> Self {
        Self(vec![[low, low], [high, high]])
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// What is left where `a . density <= most`.
    pub(super) fn cut(&mut self, a: [f64; 2], most: f64) {
        let over = |p: &[f64; 2]| a[0] * p[0] + a[1] * p[1] - most;
        if self.0.iter().all(|p| over(p) <= 0.0) {
            return;
        }
        let mut left = Vec::with_capacity(self.0.len() + 1);
        for (i, p) in self.0.iter().enumerate() {
            let q = &self.0[(i + 1) % self.0.len()];
            let (at_p, at_q) = (over(p), over(q));
            if at_p <= 0.0 {
                left.push(*p);
            }
            if (at_p < 0.0 && at_q > 0.0) || (at_p > 0.0 && at_q < 0.0) {
                let t = at_p / (at_p - at_q);
                left.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
            }
        }
        self.0 = left;
    }

    /// Least and greatest value of `a . density`.
    pub(super) fn range(&self, a: [f64; 2]) -> [f64; 2] {
        let values = self.0.iter().map(|p| a[0] * p[0] + a[1] * p[1]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_and_a_segment_are_cut() {
        let mut square = Densities::all([1000.0, 2000.0]);
        // Above the diagonal, then with a mean of at most 1250.
        square.cut([1.0, -1.0], 0.0);
        square.cut([0.5, 0.5], 1250.0);
        assert_eq!(square.range([1.0, 0.0]), [1000.0, 1250.0]);
        assert_eq!(square.range([0.0, 1.0]), [1000.0, 1500.0]);
        square.cut([1.0, 0.0], 900.0);
        assert!(square.is_empty());
        let mut same = Densities::same([1000.0, 2000.0]);
        same.cut([-0.3, -0.7], -1200.0);
        same.cut([0.3, 0.7], 1300.0);
        let [low, high] = same.range([1.0, 0.0]);
        assert!((low - 1200.0).abs() < 1e-9 && (high - 1300.0).abs() < 1e-9);
        assert_eq!(same.range([1.0, -1.0]), [0.0, 0.0]);
    }
}
