//! The failure mechanism in motion: the mesh moved by the flow of the upper bound.

use soilctl_app::limits::Fields;
use soilctl_figure::{Motion, MovingPoint};
use soilctl_limit_analysis::results::Point;

use super::frame::{INK, Window, face_lines};
use super::trails::{bits, trails};
use crate::PageError;

/// How far the fastest point goes in the end, over the greater side of what is shown.
const FARTHEST: f64 = 0.09;
/// Squares, every other one in a tone, over the greater side of what is shown. Layers in a tone would look like strata.
const SQUARES: f64 = 26.0;
/// Velocities are rounded to this part of the greatest one, so that neighbours that move alike do so to the last digit,
/// and a jump that cannot be seen is none.
const ROUNDED: f64 = 1.0 / 512.0;

type Triangle = [MovingPoint; 3];

/// The mesh, soil in squares like those of coloured sand behind glass, slip lines and structures. All velocities are the same
/// number of times what they are.
pub(super) fn mechanism(fields: &Fields, window: &Window) -> Result<Option<Motion>, PageError> {
    let Some(flow) = &fields.flow else { return Ok(None) };
    let top =
        flow.corner_velocities().into_iter().flatten().map(|[x, y]| x.hypot(y)).fold(flow.speed(), f64::max);
    let [wide, high] = [0, 1].map(|i| window.high[i] - window.low[i]);
    let scale = if top > 0.0 { FARTHEST * wide.max(high) / top } else { 0.0 };
    let step = ROUNDED * top.max(f64::MIN_POSITIVE);
    let moving = |at: Point, v: Point| {
        let [x, y] = v.map(|v| scale * step * (v / step).round());
        let length = fields.units.length;
        MovingPoint { at: fields.units.point(at).into(), by: (length * x, length * y) }
    };
    // Ground that heaves stays in view.
    let window = window.with_room_above(scale * top);
    let all = || flow.triangles().iter().zip(flow.corner_velocities());
    let triangle = |(t, v): (&[Point; 3], [Point; 3])| [0, 1, 2].map(|k| moving(t[k], v[k]));
    let triangles: Vec<Triangle> = all().filter(|(t, _)| window.shows(t)).map(triangle).collect();
    // Also those out of view, so that no outline is where the view ends.
    let rings: Vec<Vec<MovingPoint>> = all().map(|t| triangle(t).to_vec()).collect();

    let mut motion = Motion::new(window.figure(fields, "Upper bound, how the soil fails")?);
    let corner = fields.units.point([window.low[0], window.high[1]]);
    motion.areas(&squares(&triangles, corner.into(), fields.units.length * wide.max(high) / SQUARES));
    let faces = face_lines(fields.statement()?);
    let velocity = flow.statement().objective.velocity();
    let at_rest = |line: &[Point; 2]| line.map(|p| moving(p, [0.0; 2])).to_vec();
    motion.lines(faces.iter().map(at_rest).collect(), 1.0, None);
    motion.lines(
        trails(triangles.iter(), |p: MovingPoint| bits([p.at.0, p.at.1, p.by.0, p.by.1])),
        0.4,
        None,
    );
    motion.outline(&rings, 1.2);
    let moved = |line: &[Point; 2]| line.map(|p| moving(p, velocity)).to_vec();
    motion.lines(faces.iter().map(moved).collect(), 3.5, Some(INK));
    Ok(Some(motion))
}

/// What of the triangles lies in every other square of a grid with this corner and spacing.
fn squares(triangles: &[Triangle], corner: (f64, f64), side: f64) -> Vec<Vec<MovingPoint>> {
    let mut parts = Vec::new();
    for triangle in triangles {
        for (row, strip) in strips(triangle, Axis::Y, corner.1, side) {
            let cells = strips(&strip, Axis::X, corner.0, side);
            parts.extend(cells.into_iter().filter(|(column, _)| (row + column) % 2 == 0).map(|cell| cell.1));
        }
    }
    parts
}

/// Along which a strip is counted.
#[derive(Debug, Clone, Copy)]
enum Axis {
    X,
    Y,
}

impl Axis {
    fn of(self, p: &MovingPoint) -> f64 {
        match self {
            Self::X => p.at.0,
            Self::Y => p.at.1,
        }
    }
}

/// A convex polygon cut into strips of equal width, counted from `start`.
fn strips(ring: &[MovingPoint], axis: Axis, start: f64, width: f64) -> Vec<(i64, Vec<MovingPoint>)> {
    let values = || ring.iter().map(|p| axis.of(p));
    let ends = [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
    let [first, last] = ends.map(|end| ((end - start) / width).floor() as i64);
    let strip = |number: i64| {
        let [from, to] = [number, number + 1].map(|n| start + width * n as f64);
        (number, below(&below(ring, axis, to, 1.0), axis, from, -1.0))
    };
    (first..=last).map(strip).filter(|(_, part)| part.len() > 2).collect()
}

/// What of a convex polygon lies below a limit, or, with `sign` -1, above it.
fn below(ring: &[MovingPoint], axis: Axis, limit: f64, sign: f64) -> Vec<MovingPoint> {
    let over = |p: &MovingPoint| sign * (axis.of(p) - limit);
    let mut kept = Vec::with_capacity(ring.len() + 1);
    for (i, a) in ring.iter().enumerate() {
        let b = &ring[(i + 1) % ring.len()];
        if over(a) <= 0.0 {
            kept.push(*a);
        }
        if (over(a) < 0.0 && over(b) > 0.0) || (over(a) > 0.0 && over(b) < 0.0) {
            kept.push(cut(a, b, axis, limit));
        }
    }
    kept
}

/// The point of an edge at a limit: the same to the last digit from both sides of the edge.
fn cut(a: &MovingPoint, b: &MovingPoint, axis: Axis, limit: f64) -> MovingPoint {
    let (a, b) = if axis.of(a) < axis.of(b) { (a, b) } else { (b, a) };
    let part = (limit - axis.of(a)) / (axis.of(b) - axis.of(a));
    let between = |from: f64, to: f64| from + part * (to - from);
    let at = match axis {
        Axis::X => (limit, between(a.at.1, b.at.1)),
        Axis::Y => (between(a.at.0, b.at.0), limit),
    };
    MovingPoint { at, by: (between(a.by.0, b.by.0), between(a.by.1, b.by.1)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(ring: &[MovingPoint]) -> f64 {
        let twice = |i: usize| {
            let (a, b) = (ring[i].at, ring[(i + 1) % ring.len()].at);
            a.0 * b.1 - b.0 * a.1
        };
        0.5 * (0..ring.len()).map(twice).sum::<f64>()
    }

    fn square() -> Vec<Triangle> {
        let p = |x: f64, y: f64| MovingPoint { at: (x, y), by: (y, 2.0 * x) };
        let (a, b, c, d) = (p(0.0, 0.0), p(1.0, 0.0), p(1.0, 1.0), p(0.0, 1.0));
        vec![[a, b, c], [a, c, d]]
    }

    #[test]
    fn every_other_square_is_half_of_the_soil() {
        for count in [2.0, 4.0, 10.0] {
            let parts = squares(&square(), (0.0, 1.0), 1.0 / count);
            let sum: f64 = parts.iter().map(|p| area(p)).sum();
            assert!((sum - 0.5).abs() < 1e-12, "{count}: {sum}");
        }
    }

    #[test]
    fn cuts_move_like_what_they_lie_on() {
        // The displacement is linear over the square, so it is the same function at every cut.
        for part in squares(&square(), (0.0, 1.0), 0.3) {
            for p in part {
                assert!((p.by.0 - p.at.1).abs() < 1e-12 && (p.by.1 - 2.0 * p.at.0).abs() < 1e-12, "{p:?}");
            }
        }
    }
}
