//! Arcs as chords.

use std::f64::consts::TAU;

use crate::Point;

/// Most chords of an arc.
const MOST: usize = 512;
/// Fewest chords of a whole circle.
const FEWEST: f64 = 24.0;

/// Points on an arc after its start, the last at its end: about a centre, from an angle on, over an angle that may be negative. Chords are as near
/// to the arc as told.
pub(super) fn chords(centre: Point, radius: f64, from: f64, over: f64, near: f64) -> Vec<Point> {
    let step = 2.0 * libm::acos((1.0 - near / radius).clamp(-1.0, 1.0));
    let step = if step.is_finite() && step > 0.0 { step.min(TAU / FEWEST) } else { TAU / FEWEST };
    let count = ((over.abs() / step).ceil()).clamp(1.0, MOST as f64) as usize;
    (1..=count)
        .map(|i| {
            let angle = from + over * i as f64 / count as f64;
            [centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle)]
        })
        .collect()
}

/// The same for a bulge between two corners: the tangent of a quarter of the angle of an arc, positive to the left of the way. The last point is the second
/// corner itself.
pub(super) fn bulged(a: Point, b: Point, bulge: f64, near: f64) -> Vec<Point> {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let chord = dx.hypot(dy);
    let over = 4.0 * libm::atan(bulge);
    let radius = chord / (2.0 * libm::sin(0.5 * over).abs());
    if bulge == 0.0 || chord == 0.0 || !radius.is_finite() {
        return vec![b];
    }
    // From the middle of the chord to the left of the way.
    let off = chord * (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = [0.5 * (a[0] + b[0]) - off * dy / chord, 0.5 * (a[1] + b[1]) + off * dx / chord];
    let from = libm::atan2(a[1] - centre[1], a[0] - centre[0]);
    let mut points = chords(centre, radius, from, over, near);
    if let Some(last) = points.last_mut() {
        *last = b;
    }
    points
}
