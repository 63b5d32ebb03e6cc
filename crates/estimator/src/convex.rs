//! Convex polygons in the plane, as small as they come.

/// A point of the plane.
pub(crate) type Point = [f64; 2];

/// Part of a convex polygon where a linear function, given at its vertices by `value`, is not negative.
pub(crate) fn clip(polygon: &[Point], value: impl Fn(Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let (fa, fb) = (value(a), value(b));
        if fa >= 0.0 {
            kept.push(a);
        }
        if (fa > 0.0 && fb < 0.0) || (fa < 0.0 && fb > 0.0) {
            let t = fa / (fa - fb);
            kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
        }
    }
    kept
}

/// Convex hull, counter-clockwise (Andrew's monotone chain).
pub(crate) fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let turn = |o: Point, a: Point, b: Point| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    let mut chain: Vec<Point> = Vec::with_capacity(points.len() + 1);
    let mut half = |points: &mut dyn Iterator<Item = Point>| {
        let start = chain.len();
        for p in points {
            while chain.len() >= start + 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0.0 {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
    };
    half(&mut points.iter().copied());
    half(&mut points.iter().rev().copied());
    chain
}

/// Signed area (counter-clockwise positive) and centroid; the centroid of a degenerate polygon is its mean.
pub(crate) fn area_centroid(polygon: &[Point]) -> (f64, Point) {
    let origin = polygon.first().copied().unwrap_or_default();
    let (mut twice, mut cx, mut cy) = (0.0, 0.0, 0.0);
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let (ax, ay, bx, by) = (a[0] - origin[0], a[1] - origin[1], b[0] - origin[0], b[1] - origin[1]);
        let cross = ax * by - ay * bx;
        twice += cross;
        cx += cross * (ax + bx);
        cy += cross * (ay + by);
    }
    if twice.abs() < 1e-300 {
        let n = polygon.len().max(1) as f64;
        let mean = |d: usize| polygon.iter().map(|p| p[d]).sum::<f64>() / n;
        return (0.0, [mean(0), mean(1)]);
    }
    (0.5 * twice, [origin[0] + cx / (3.0 * twice), origin[1] + cy / (3.0 * twice)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clip_and_hull_of_a_square() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let half = clip(&square, |p| 1.0 - p[0] - p[1]);
        assert!((area_centroid(&half).0 - 0.5).abs() < 1e-15);
        let mut points = square.to_vec();
        points.push([0.5, 0.5]);
        assert_eq!(hull(points).len(), 4);
        assert_eq!(area_centroid(&square).1, [0.5, 0.5]);
    }
}
