use nalgebra::{Matrix2, Matrix3, SymmetricEigen, Vector2, Vector3};

/// An ellipse in a parameter plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Ellipse {
    /// Centre.
    pub centre: [f64; 2],
    /// Semi-axes as vectors, the longer first.
    pub semi_axes: [[f64; 2]; 2],
}

impl Ellipse {
    /// Area in the product of the axes' units.
    #[must_use]
    pub fn area(&self) -> f64 {
        let [[ax, ay], [bx, by]] = self.semi_axes;
        std::f64::consts::PI * (ax * by - ay * bx).abs()
    }

    /// Points on the ellipse.
    #[must_use]
    pub fn outline(&self, points: usize) -> Vec<[f64; 2]> {
        let [a, b] = self.semi_axes;
        (0..points)
            .map(|i| {
                let (s, c) = (std::f64::consts::TAU * i as f64 / points as f64).sin_cos();
                [self.centre[0] + c * a[0] + s * b[0], self.centre[1] + c * a[1] + s * b[1]]
            })
            .collect()
    }
}

/// Ellipse of least area that encloses all points (Khachiyan's algorithm, to 0.1 % in area). One point or
/// points on a line give a degenerate ellipse. `None` without points.
pub(crate) fn smallest_ellipse(points: &[[f64; 2]]) -> Option<Ellipse> {
    const TOLERANCE: f64 = 1e-3;
    const ROUNDS: usize = 20_000;
    let n = points.len();
    let first = *points.first()?;
    // Work in units of the points' own spread; a tiny jitter-free floor keeps degenerate sets solvable.
    let spread = [0, 1].map(|d| {
        let (low, high) = points.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p[d]), h.max(p[d])));
        (high - low).max(1e-12 * high.abs()).max(f64::MIN_POSITIVE)
    });
    if n == 1 {
        return Some(Ellipse { centre: first, semi_axes: [[0.0; 2]; 2] });
    }
    let scaled: Vec<Vector2<f64>> = points
        .iter()
        .map(|p| Vector2::new((p[0] - first[0]) / spread[0], (p[1] - first[1]) / spread[1]))
        .collect();
    let mut weights = vec![1.0 / n as f64; n];
    for _ in 0..ROUNDS {
        let moment: Matrix3<f64> = scaled
            .iter()
            .zip(&weights)
            .map(|(p, w)| {
                let q = Vector3::new(p.x, p.y, 1.0);
                q * q.transpose() * *w
            })
            .sum::<Matrix3<f64>>()
            + Matrix3::identity() * 1e-14;
        let inverse = moment.try_inverse()?;
        let reach = |p: &Vector2<f64>| {
            let q = Vector3::new(p.x, p.y, 1.0);
            (q.transpose() * inverse * q)[0]
        };
        let (far, distance) = scaled.iter().map(reach).enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
        if distance <= 3.0 * (1.0 + TOLERANCE) {
            break;
        }
        let step = (distance - 3.0) / (3.0 * (distance - 1.0));
        weights.iter_mut().for_each(|w| *w *= 1.0 - step);
        weights[far] += step;
    }
    let centre: Vector2<f64> = scaled.iter().zip(&weights).map(|(p, w)| p * *w).sum();
    let second: Matrix2<f64> = scaled.iter().zip(&weights).map(|(p, w)| p * p.transpose() * *w).sum();
    let shape = (second - centre * centre.transpose()) * 2.0;
    let eigen = SymmetricEigen::new(shape);
    // Grow until the farthest point lies on the ellipse.
    let axis = |i: usize| {
        let length = eigen.eigenvalues[i].max(0.0).sqrt();
        eigen.eigenvectors.column(i) * length
    };
    let growth = scaled
        .iter()
        .map(|p| {
            let d = p - centre;
            (0..2)
                .map(|i| {
                    let length = eigen.eigenvalues[i].max(1e-24).sqrt();
                    (eigen.eigenvectors.column(i).dot(&d) / length).powi(2)
                })
                .sum::<f64>()
        })
        .fold(1.0, f64::max)
        .sqrt()
        .min(1.0 + TOLERANCE);
    let mut axes = [0, 1].map(|i| {
        let a = axis(i) * growth;
        [a[0] * spread[0], a[1] * spread[1]]
    });
    if axes[0][0].hypot(axes[0][1]) < axes[1][0].hypot(axes[1][1]) {
        axes.swap(0, 1);
    }
    let centre = [first[0] + centre.x * spread[0], first[1] + centre.y * spread[1]];
    Some(Ellipse { centre, semi_axes: axes })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn square_and_triangle_have_known_ellipses() {
        // Smallest circle around the unit square: radius sqrt(2)/2. Around a triangle: 4 pi / (3 sqrt 3) times
        // its area (Steiner's circumellipse).
        let square = smallest_ellipse(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]]).unwrap();
        assert!((square.area() / (std::f64::consts::PI / 2.0) - 1.0).abs() < 3e-3);
        let triangle = smallest_ellipse(&[[0., 0.], [40., 0.], [10., 3000.]]).unwrap();
        let steiner = 4.0 * std::f64::consts::PI / (3.0 * 3f64.sqrt()) * 60_000.0;
        assert!((triangle.area() / steiner - 1.0).abs() < 3e-3, "{}", triangle.area() / steiner);
    }

    proptest! {
        #[test]
        fn every_point_is_inside(points in proptest::collection::vec((25.0..50.0, 1000.0..2000.0), 1..12)) {
            let points: Vec<[f64; 2]> = points.into_iter().map(|(x, y)| [x, y]).collect();
            let e = smallest_ellipse(&points).unwrap();
            let [a, b] = e.semi_axes;
            let det = a[0] * b[1] - a[1] * b[0];
            prop_assume!(det.abs() > 1e-6);
            for p in &points {
                let (x, y) = (p[0] - e.centre[0], p[1] - e.centre[1]);
                let (s, t) = ((x * b[1] - y * b[0]) / det, (a[0] * y - a[1] * x) / det);
                prop_assert!(s * s + t * t <= 1.01, "{}", s * s + t * t);
            }
        }
    }
}
