//! Guides at fans: one that comes to the corner becomes a spoke, others end before the fan.

use super::fan::Disc;
use crate::vector::{Point, along, between, distance, dot};

/// Guides that pass the corner at less than this many radii lead to it.
const CORE: f64 = 0.1;

/// Guides that do not lead to the corner end at this many radii from it.
const CLEAR: f64 = 1.3;

/// A guide that ends inside the fan becomes a spoke if it ends farther out than this many radii.
const STUB: f64 = 0.5;

/// A part of a guide that is near the corner, or one that is not.
struct Run {
    near: bool,
    points: Vec<Point>,
}

/// What the fans leave of a guide. Spokes that it shall follow are noted in the discs.
pub(super) fn trim(part: Vec<Point>, discs: &mut [Disc]) -> Vec<Vec<Point>> {
    let mut parts = vec![part];
    for disc in discs {
        parts = parts.into_iter().flat_map(|part| disc.trim(part)).collect();
    }
    parts
}

impl Disc {
    fn trim(&mut self, part: Vec<Point>) -> Vec<Vec<Point>> {
        let runs = self.runs(&part);
        let mut parts: Vec<Vec<Point>> = Vec::new();
        let mut start: Vec<Point> = Vec::new();
        for run in runs {
            if !run.near {
                start.extend(run.points);
                start.dedup();
                parts.push(std::mem::take(&mut start));
                continue;
            }
            let is_core = |pair: &[Point]| self.away(along(pair[0], pair[1], 0.5)) < CORE * self.radius;
            let first = run.points.windows(2).position(is_core);
            let last = run.points.windows(2).rposition(is_core);
            let (Some(first), Some(last)) = (first, last) else { continue };
            let mut inwards = run.points[..=first].to_vec();
            inwards.reverse();
            let mut end = self.leave(&inwards);
            end.reverse();
            if let Some(before) = parts.last_mut() {
                before.extend(end);
                before.dedup();
            }
            start = self.leave(&run.points[last + 1..]);
        }
        parts.retain(|p| p.len() > 1);
        parts
    }

    fn away(&self, p: Point) -> f64 {
        distance(self.centre, p)
    }

    /// From a piece of a guide that leads out from the core: a spoke, and the piece from the spoke's end on.
    fn leave(&mut self, points: &[Point]) -> Vec<Point> {
        let beyond = self.radius * (1.0 + 1e-9);
        let Some(last) = points.iter().rposition(|&p| self.away(p) <= beyond) else { return Vec::new() };
        if self.away(points[last]) < STUB * self.radius {
            return Vec::new();
        }
        let Some(end) = self.spoke(points[last]) else { return Vec::new() };
        [end].into_iter().chain(points[last + 1..].iter().copied()).collect()
    }

    /// The guide in runs that are near and runs that are not, with additional points where it comes to the core,
    /// the spokes' ends, and the border.
    fn runs(&self, part: &[Point]) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for pair in part.windows(2) {
            let mut from = pair[0];
            for to in self.crossings(pair[0], pair[1]).into_iter().chain([pair[1]]) {
                let near = self.away(along(from, to, 0.5)) < CLEAR * self.radius;
                match runs.last_mut() {
                    Some(run) if run.near == near => run.points.push(to),
                    _ => runs.push(Run { near, points: vec![from, to] }),
                }
                from = to;
            }
        }
        runs
    }

    /// Where a segment crosses the circles, from `a` to `b`.
    fn crossings(&self, a: Point, b: Point) -> Vec<Point> {
        let (way, out) = (between(a, b), between(self.centre, a));
        let (square, half) = (dot(way, way), dot(way, out));
        let mut places = Vec::new();
        for radii in [CORE, 1.0, CLEAR] {
            let radius = radii * self.radius;
            let root = half * half - square * (dot(out, out) - radius * radius);
            if root > 0.0 && square > 0.0 {
                places.extend([-1.0, 1.0].map(|sign| (sign * root.sqrt() - half) / square));
            }
        }
        places.retain(|&s| s > 0.0 && s < 1.0);
        places.sort_by(f64::total_cmp);
        places.into_iter().map(|s| along(a, b, s)).collect()
    }
}
