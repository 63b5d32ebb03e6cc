/// The convex hull of points, counter-clockwise, by Andrew's monotone chain; the points themselves, sorted, if they are on a line.
#[must_use]
pub fn convex_hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup();
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if turn(a, b, point) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter().copied());
    hull.extend(half(&mut sorted.iter().rev().copied()));
    if hull.len() < 3 { sorted } else { hull }
}

/// Whether a point is in a convex polygon, counter-clockwise, or on its edge.
#[must_use]
pub fn contains(hull: &[[f64; 2]], point: [f64; 2]) -> bool {
    let size = hull.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let slack = 1e-12 * size * size;
    hull.len() >= 3 && (0..hull.len()).all(|i| turn(hull[i], hull[(i + 1) % hull.len()], point) >= -slack)
}

/// Twice the area of a triangle, above 0 if it runs counter-clockwise.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn of_a_square_with_points_inside_and_on_its_edges_the_corners_are_left() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5], [0.5, 0.0]];
        let hull = convex_hull(&square);
        assert_eq!(hull, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert!(contains(&hull, [0.2, 0.9]) && contains(&hull, [1.0, 0.3]) && !contains(&hull, [1.1, 0.5]));
    }

    #[test]
    fn points_on_a_line_have_no_inside() {
        let hull = convex_hull(&[[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]]);
        assert_eq!(hull.len(), 3);
        assert!(!contains(&convex_hull(&[[0.0, 0.0], [1.0, 1.0]]), [0.5, 0.5]));
    }

    proptest! {
        #[test]
        fn every_point_is_inside(points in proptest::collection::vec((0.0..1.0, 0.0..1.0), 3..30)) {
            let points: Vec<[f64; 2]> = points.into_iter().map(|(x, y)| [x, y]).collect();
            let hull = convex_hull(&points);
            prop_assume!(hull.len() >= 3);
            prop_assert!(points.iter().all(|p| contains(&hull, *p)));
        }
    }
}
