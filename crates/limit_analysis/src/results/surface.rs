//! Where moving soil ends.

use std::collections::BTreeMap;

use soilctl_certificate::{Adjoins, LineUse, Side};

use super::Point;
use super::boundary::{edges_by_side, face_sides};
use super::flow::FlowResults;
use crate::vector::along;

/// The fraction of the structure's speed from which on soil is said to move, if nothing else is asked for. Flows of
/// upper bounds have corners and fringes of a few per cent that carry next to no power.
pub const MOVING: f64 = 0.05;

/// A stretch of ground that moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Its end at lesser x (length).
    pub from: Point,
    /// Its end at greater x (length).
    pub to: Point,
}

type Segment = [Point; 2];

impl FlowResults {
    /// The boundary of the soil that moves at least at `level` times [`speed`](Self::speed), inside the soil: lines, each
    /// from point to point (length), along contours of the speed and along jumps.
    #[must_use]
    pub fn failure_surface(&self, level: f64) -> Vec<Vec<Point>> {
        let level = level * self.speed();
        let mut segments = Vec::new();
        for piece in self.pieces().iter().flatten() {
            let v = &piece.corners;
            let node = |i: usize| {
                if i < 3 {
                    return (v[i], speed(piece.control[i]));
                }
                let (a, b) = ((i + 1) % 3, (i + 2) % 3);
                let c = &piece.control;
                (along(v[a], v[b], 0.5), speed(middle([c[a], c[i], c[b]])))
            };
            for part in [[0, 5, 4], [1, 3, 5], [2, 4, 3], [3, 4, 5]] {
                segments.extend(contour(part.map(node), level));
            }
        }
        for (triangle, adjoins) in self.shown.adjoins.iter().enumerate() {
            for (corner, adjoins) in adjoins.iter().enumerate() {
                let Adjoins::Soil(Side { triangle: other, corner: there }) = *adjoins else { continue };
                if (triangle, corner) < (other, there) {
                    let ends = self.ends(triangle, corner);
                    let [c, b, a] = self.on_edge(other, there);
                    let sides = [self.on_edge(triangle, corner), [a, b, c]];
                    segments.extend(one_moves(ends, sides, level));
                }
            }
        }
        chains(segments)
    }

    /// The stretches of free and loaded ground that move at least at `level` times [`speed`](Self::speed), by ascending x.
    /// Those on both sides of a structure are two.
    #[must_use]
    pub fn moving_ground(&self, level: f64) -> Vec<Stretch> {
        let level = level * self.speed();
        let ends = |s: LineUse| self.statement.lines[s.line].walked(s.forward);
        let at_structure: Vec<Point> = face_sides(&self.statement)
            .into_iter()
            .flat_map(ends)
            .map(|p| self.statement.points[p])
            .collect();
        let mut walks: Vec<Segment> = Vec::new();
        for edges in edges_by_side(&self.shown.adjoins).values() {
            for &(triangle, corner) in edges {
                let Adjoins::Boundary { condition, .. } = self.shown.adjoins[triangle][corner] else {
                    continue;
                };
                if !condition.traction_is_given() {
                    continue;
                }
                let at_rest = [[0.0; 2]; 3];
                let ends = self.ends(triangle, corner);
                for [a, b] in one_moves(ends, [self.on_edge(triangle, corner), at_rest], level) {
                    match walks.iter_mut().find(|w| near(w[1], a) && !at_structure.contains(&a)) {
                        Some(walk) => walk[1] = b,
                        None => walks.push([a, b]),
                    }
                }
            }
        }
        // Lines come by their index, so a walk may start where a later one ends.
        let mut joined: Vec<Segment> = Vec::new();
        while let Some(mut walk) = walks.pop() {
            while let Some(i) = walks
                .iter()
                .chain(&joined)
                .position(|w| near(w[1], walk[0]) && !at_structure.contains(&walk[0]) && !near(w[0], walk[1]))
            {
                let before = if i < walks.len() { walks.remove(i) } else { joined.remove(i - walks.len()) };
                walk[0] = before[0];
            }
            joined.push(walk);
        }
        let ordered = |[a, b]: Segment| {
            if a[0] <= b[0] { Stretch { from: a, to: b } } else { Stretch { from: b, to: a } }
        };
        let mut stretches: Vec<Stretch> = joined.into_iter().map(ordered).collect();
        stretches.sort_by(|a, b| a.from[0].total_cmp(&b.from[0]));
        stretches
    }
}

fn speed(v: Point) -> f64 {
    v[0].hypot(v[1])
}

fn near(a: Point, b: Point) -> bool {
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) < 1e-9
}

/// Value in the middle of an edge, from its control points.
fn middle([a, b, c]: [Point; 3]) -> Point {
    [0, 1].map(|axis| 0.25 * a[axis] + 0.5 * b[axis] + 0.25 * c[axis])
}

/// Where a function that is linear on a triangle crosses a level.
fn contour(nodes: [(Point, f64); 3], level: f64) -> Option<Segment> {
    let mut ends = Vec::new();
    for k in 0..3 {
        let ((p, f), (q, g)) = (nodes[k], nodes[(k + 1) % 3]);
        if (f < level) != (g < level) {
            // From the lower end, so that both sides of an edge find the same point.
            let ((p, f), (q, g)) = if f < g { ((p, f), (q, g)) } else { ((q, g), (p, f)) };
            ends.push(along(p, q, (level - f) / (g - f)));
        }
    }
    <[Point; 2]>::try_from(ends).ok()
}

/// The parts of an edge along which just one of two flows moves, walked from the first end.
fn one_moves([a, b]: Segment, sides: [[Point; 3]; 2], level: f64) -> Vec<Segment> {
    let speeds = sides.map(|s| [s[0], middle(s), s[2]].map(speed));
    let mut parts: Vec<Segment> = Vec::new();
    for half in 0..2 {
        let ends = speeds.map(|s| [s[half], s[half + 1]]);
        let mut cuts = vec![0.0, 1.0];
        for [f, g] in ends {
            if (f < level) != (g < level) {
                cuts.push((level - f) / (g - f));
            }
        }
        cuts.sort_by(f64::total_cmp);
        for cut in cuts.windows(2).filter(|c| c[0] < c[1]) {
            let at = 0.5 * (cut[0] + cut[1]);
            let [first, second] = ends.map(|[f, g]| f + at * (g - f) >= level);
            if first != second {
                let [from, to] = [cut[0], cut[1]].map(|s| along(a, b, 0.5 * (half as f64 + s)));
                match parts.last_mut() {
                    Some(last) if last[1] == from => last[1] = to,
                    _ => parts.push([from, to]),
                }
            }
        }
    }
    parts
}

/// Joins segments with common ends into lines.
fn chains(segments: Vec<Segment>) -> Vec<Vec<Point>> {
    // Points that differ by rounding are one.
    let key = |p: Point| p.map(|x| (x * 1e8).round() as i64);
    let mut at: BTreeMap<[i64; 2], Vec<usize>> = BTreeMap::new();
    for (i, ends) in segments.iter().enumerate().filter(|(_, [a, b])| key(*a) != key(*b)) {
        ends.iter().for_each(|p| at.entry(key(*p)).or_default().push(i));
    }
    let mut used: Vec<bool> = segments.iter().map(|[a, b]| key(*a) == key(*b)).collect();
    let mut lines = Vec::new();
    // First from where lines end or meet, then what is left: closed ones.
    let ends = at.iter().filter(|(_, s)| s.len() != 2).chain(&at).map(|(k, s)| (*k, s.clone()));
    for (start, starts) in ends {
        for first in starts {
            let mut line: Vec<Point> = Vec::new();
            let (mut here, mut next) = (start, Some(first));
            while let Some(segment) = next.filter(|s| !used[*s]) {
                used[segment] = true;
                let [a, b] = segments[segment];
                let (from, to) = if key(a) == here { (a, b) } else { (b, a) };
                if line.is_empty() {
                    line.push(from);
                }
                line.push(to);
                here = key(to);
                let met = at.get(&here).map_or(&[][..], Vec::as_slice);
                next = if met.len() == 2 { met.iter().copied().find(|s| !used[*s]) } else { None };
            }
            if !line.is_empty() {
                lines.push(line);
            }
        }
    }
    lines
}
