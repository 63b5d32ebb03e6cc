//! Plane geometry, as little as is needed.

/// A point or a vector of the plane.
pub(crate) type Point = [f64; 2];

/// From `a` to `b`.
pub(crate) fn between(a: Point, b: Point) -> Point {
    [b[0] - a[0], b[1] - a[1]]
}

/// Cross product; positive if `b` is to the left of `a`.
pub(crate) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Scalar product.
pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Length of a vector.
pub(crate) fn length(a: Point) -> f64 {
    a[0].hypot(a[1])
}

/// A vector, a quarter turn to the left.
pub(crate) fn turned(a: Point) -> Point {
    [-a[1], a[0]]
}

/// Distance of two points.
pub(crate) fn distance(a: Point, b: Point) -> f64 {
    length(between(a, b))
}

/// The point halfway between two others.
pub(crate) fn midpoint(a: Point, b: Point) -> Point {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}

/// Centroid of a triangle.
pub(crate) fn centroid(t: &[Point; 3]) -> Point {
    [(t[0][0] + t[1][0] + t[2][0]) / 3.0, (t[0][1] + t[1][1] + t[2][1]) / 3.0]
}

/// The point at the fraction `s` of the way from `a` to `b`. Every vertex on a line is computed by this formula.
pub(crate) fn along(a: Point, b: Point, s: f64) -> Point {
    [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]
}

/// Angle between two vectors, 0 to pi.
pub(crate) fn angle(a: Point, b: Point) -> f64 {
    cross(a, b).abs().atan2(dot(a, b))
}

/// Twice the signed area of a triangle.
pub(crate) fn twice_area(t: [Point; 3]) -> f64 {
    cross(between(t[0], t[1]), between(t[0], t[2]))
}

/// Distance of `p` from the segment `a` to `b`.
pub(crate) fn distance_to_segment(p: Point, [a, b]: [Point; 2]) -> f64 {
    let (ab, ap) = (between(a, b), between(a, p));
    let s = (dot(ap, ab) / dot(ab, ab)).clamp(0.0, 1.0);
    distance(p, along(a, b, s))
}

/// Centre of the circle through three points, which are not in line.
pub(crate) fn circumcentre(t: [Point; 3]) -> Point {
    let (b, c) = (between(t[0], t[1]), between(t[0], t[2]));
    let (bb, cc, d) = (dot(b, b), dot(c, c), 2.0 * cross(b, c));
    [t[0][0] + (c[1] * bb - b[1] * cc) / d, t[0][1] + (b[0] * cc - c[0] * bb) / d]
}

/// Whether `p` is inside the circle through the corners of a counter-clockwise triangle. Rounding may decide ties.
pub(crate) fn in_circle(t: [Point; 3], p: Point) -> bool {
    let [a, b, c] = t.map(|v| between(p, v));
    dot(a, a) * cross(b, c) + dot(b, b) * cross(c, a) + dot(c, c) * cross(a, b) > 0.0
}

/// Shape of a triangle: 1 for an equilateral one, 0 for a degenerate one, negative if turned over.
pub(crate) fn shape(t: [Point; 3]) -> f64 {
    let (a, b, c) = (between(t[0], t[1]), between(t[1], t[2]), between(t[2], t[0]));
    2.0 * 3f64.sqrt() * cross(a, b) / (dot(a, a) + dot(b, b) + dot(c, c))
}

/// The three angles of a triangle, at its corners in order.
pub(crate) fn angles(t: [Point; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| angle(between(t[i], t[(i + 1) % 3]), between(t[i], t[(i + 2) % 3])))
}
