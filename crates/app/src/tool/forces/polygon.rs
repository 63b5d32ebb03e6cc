//! Convex polygons of forces.

use crate::tool::shape::Point;

/// Convex hull, against the clock; fewer than three corners where all points are on a line.
pub(super) fn hull(points: &[Point]) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let chain = |points: &mut dyn Iterator<Item = &Point>| {
        let mut kept: Vec<Point> = Vec::new();
        for p in points {
            while let [.., a, b] = kept[..] {
                if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0 {
                    break;
                }
                kept.pop();
            }
            kept.push(*p);
        }
        kept.pop();
        kept
    };
    let mut hull = chain(&mut sorted.iter());
    hull.extend(chain(&mut sorted.iter().rev()));
    hull
}

/// What is on the inner side of all lines `normal . p = support`, against the clock; none where that has no end.
pub(super) fn within(lines: &[(Point, f64)]) -> Option<Vec<Point>> {
    let size = lines.iter().map(|(_, support)| support.abs()).fold(0.0, f64::max);
    // Far more than corners of lines that bound something are away.
    let far = 1e6 * size;
    let mut polygon = vec![[-far, -far], [far, -far], [far, far], [-far, far]];
    for (normal, support) in lines {
        let over = |p: &Point| normal[0] * p[0] + normal[1] * p[1] - support;
        let mut cut = Vec::new();
        for (index, a) in polygon.iter().enumerate() {
            let b = &polygon[(index + 1) % polygon.len()];
            let [of_a, of_b] = [over(a), over(b)];
            if of_a <= 0.0 {
                cut.push(*a);
            }
            if (of_a < 0.0 && of_b > 0.0) || (of_a > 0.0 && of_b < 0.0) {
                let part = of_a / (of_a - of_b);
                cut.push([a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]);
            }
        }
        polygon = cut;
    }
    let is_bounded = polygon.iter().flatten().all(|x| x.abs() < 0.5 * far);
    (is_bounded && !polygon.is_empty()).then_some(polygon)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn normals(count: u32) -> impl Iterator<Item = Point> {
        (0..count).map(move |k| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(count)).sin_cos();
            [cos, sin]
        })
    }

    #[test]
    fn a_disc_is_between_its_points_and_its_tangents() {
        let area = |p: &[Point]| {
            let cross = |(k, a): (usize, &Point)| {
                let b = p[(k + 1) % p.len()];
                a[0] * b[1] - a[1] * b[0]
            };
            0.5 * p.iter().enumerate().map(cross).sum::<f64>()
        };
        let inner = hull(&normals(24).collect::<Vec<_>>());
        let outer = within(&normals(24).map(|n| (n, 1.0)).collect::<Vec<_>>()).unwrap();
        let half = std::f64::consts::PI / 24.0;
        assert!((area(&inner) - 24.0 * half.sin() * half.cos()).abs() < 1e-12);
        assert!((area(&outer) - 24.0 * half.tan()).abs() < 1e-6);
    }

    #[test]
    fn half_a_plane_has_no_end() {
        assert_eq!(within(&[([1.0, 0.0], 1.0), ([0.0, 1.0], 1.0)]), None);
    }

    proptest! {
        /// No point is outside any edge of the hull.
        #[test]
        fn hulls_hold_their_points(points in prop::collection::vec(prop::array::uniform2(-1.0..1.0_f64), 3..30)) {
            let hull = hull(&points);
            for (k, a) in hull.iter().enumerate() {
                let b = hull[(k + 1) % hull.len()];
                for p in &points {
                    prop_assert!((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= -1e-12);
                }
            }
        }
    }
}
