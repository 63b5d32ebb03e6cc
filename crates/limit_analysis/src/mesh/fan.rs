//! Fans of triangles around corners of the outline.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::MeshError;
use super::domain::Domain;
use crate::vector::{Point, between, distance, distance_to_segment};

/// Most fans.
const MOST: usize = 1000;

/// Least sector angle that can be asked for, radians.
const FINE: f64 = 0.01;

/// A fan of equal narrow triangles around a corner of the outline where the stress is singular, such as the tip of a
/// plate or the edge of a footing. Every sector between lines that meet at the corner is filled, where it is in a
/// region. The apexes are at the corner; the other vertices are at one distance from it.
///
/// A guide that leads to the corner runs along a spoke for the last piece. The size of the elements around the fan is
/// that of the fan's outer edges, whatever size is wanted, and grows or falls from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fan {
    /// Index of the corner, a point of the outline that a line ends at.
    pub point: usize,
    /// Length of the spokes (m), positive. It is reduced to half the distance of the nearest other corner or line, and
    /// to a third of the distance of the nearest other fan's corner.
    pub radius: f64,
    /// Largest angle of a triangle at the corner, radians, from 0.01 to half of pi.
    pub angle: f64,
}

/// A fan fitted into the outline.
pub(super) struct Disc {
    /// Its corner, a point of the outline.
    pub(super) corner: usize,
    pub(super) centre: Point,
    pub(super) radius: f64,
    /// Largest angle of a triangle.
    pub(super) angle: f64,
    pub(super) sectors: Vec<Sector>,
}

/// The part of a fan between two lines, or all round a slit's end.
pub(super) struct Sector {
    pub(super) region: usize,
    /// The line where it starts and, counter-clockwise, the line where it ends; and whether they start at the corner.
    pub(super) lines: [(usize, bool); 2],
    /// Direction of the first line, radians.
    start: f64,
    width: f64,
    /// Where guides leave: angles from the start, ascending, neither 0 nor `width`.
    leaves: Vec<f64>,
}

/// A line from the corner to the far side of a fan's triangles.
pub(super) struct Spoke {
    /// Angle from the start of the sector.
    pub(super) turn: f64,
    /// Whether a guide runs along it.
    pub(super) guide: bool,
}

impl Sector {
    /// The spokes from the first line to the last, both included.
    pub(super) fn spokes(&self, angle: f64) -> Vec<Spoke> {
        let mut spokes = vec![Spoke { turn: 0.0, guide: false }];
        let mut from = 0.0;
        for (i, &to) in self.leaves.iter().chain([&self.width]).enumerate() {
            // A whole number of triangles must not become one more by a rounding error.
            let count = ((to - from) / angle - 1e-9).ceil().max(1.0);
            let inner = (1..count as usize).map(|k| from + (to - from) * k as f64 / count);
            spokes.extend(inner.map(|turn| Spoke { turn, guide: false }));
            spokes.push(Spoke { turn: to, guide: i < self.leaves.len() });
            from = to;
        }
        spokes
    }
}

impl Disc {
    /// The far end of a spoke.
    pub(super) fn end(&self, sector: &Sector, turn: f64) -> Point {
        let (sin, cos) = (sector.start + turn).sin_cos();
        [self.centre[0] + self.radius * cos, self.centre[1] + self.radius * sin]
    }

    /// Asks for a spoke towards `p`, for a guide. The result is the far end of that spoke, or of one less than half a
    /// triangle away that is there already; `None` if `p` is in no sector.
    pub(super) fn spoke(&mut self, p: Point) -> Option<Point> {
        let way = between(self.centre, p);
        let direction = way[1].atan2(way[0]);
        let turn_in = |s: &Sector| (direction - s.start).rem_euclid(TAU);
        let index = self.sectors.iter().position(|s| turn_in(s) <= s.width)?;
        let sector = &mut self.sectors[index];
        let turn = turn_in(sector);
        let there = [0.0, sector.width].into_iter().chain(sector.leaves.iter().copied());
        let nearest = there.min_by(|a, b| (a - turn).abs().total_cmp(&(b - turn).abs()))?;
        let turn = if (nearest - turn).abs() < 0.5 * self.angle {
            nearest
        } else {
            sector.leaves.push(turn);
            sector.leaves.sort_by(f64::total_cmp);
            turn
        };
        Some(self.end(&self.sectors[index], turn))
    }

    /// How many triangles there are, and the length of the longest of their outer edges.
    pub(super) fn extent(&self) -> (usize, f64) {
        let turns = |s: &Sector| s.spokes(self.angle).into_iter().map(|s| s.turn).collect::<Vec<f64>>();
        let mut count = 0;
        let mut widest = 0f64;
        for turns in self.sectors.iter().map(turns) {
            count += turns.len() - 1;
            widest = turns.windows(2).map(|t| t[1] - t[0]).fold(widest, f64::max);
        }
        (count, 2.0 * self.radius * (0.5 * widest).sin())
    }
}

/// Fits the fans into the outline.
pub(super) fn discs(domain: &Domain, fans: &[Fan]) -> Result<Vec<Disc>, MeshError> {
    if fans.len() > MOST {
        return Err(MeshError::TooMuch { what: "fans", count: fans.len(), limit: MOST });
    }
    let mut discs = Vec::with_capacity(fans.len());
    for (index, fan) in fans.iter().enumerate() {
        let bad = |what, value, allowed| MeshError::BadFan { fan: index, what, value, allowed };
        if domain.corners.binary_search(&fan.point).is_err() {
            return Err(bad("the point", fan.point as f64, "a point of the outline that a line ends at"));
        }
        if fans[..index].iter().any(|other| other.point == fan.point) {
            return Err(bad("the point", fan.point as f64, "no other fan's"));
        }
        if !(fan.radius > 0.0 && fan.radius.is_finite()) {
            return Err(bad("the radius", fan.radius, "positive and finite"));
        }
        if !(FINE..=FRAC_PI_2).contains(&fan.angle) {
            return Err(bad("the angle", fan.angle, "from 0.01 to half of pi, in radians"));
        }
        let radius = fan.radius.min(room(domain, fans, fan.point));
        let centre = domain.statement.points[fan.point];
        let sectors = sectors(domain, fan.point);
        discs.push(Disc { corner: fan.point, centre, radius, angle: fan.angle, sectors });
    }
    Ok(discs)
}

/// Largest radius of a fan at a corner.
fn room(domain: &Domain, fans: &[Fan], corner: usize) -> f64 {
    let statement = domain.statement;
    let centre = statement.points[corner];
    let mut room = f64::INFINITY;
    for (index, line) in statement.lines.iter().enumerate() {
        let [a, b] = domain.ends(index);
        let away = match corner {
            c if line.touches(c) => distance(a, b),
            _ => distance_to_segment(centre, [a, b]),
        };
        room = room.min(0.5 * away);
    }
    for other in fans.iter().filter(|f| f.point != corner) {
        // A wrong index is refused elsewhere.
        let away = statement.points.get(other.point).map_or(f64::INFINITY, |&p| distance(centre, p));
        room = room.min(away / 3.0);
    }
    room
}

/// The sectors around a corner that are in regions, counter-clockwise.
fn sectors(domain: &Domain, corner: usize) -> Vec<Sector> {
    let mut lines = Vec::new();
    for (line, ends) in domain.statement.lines.iter().enumerate() {
        if ends.touches(corner) {
            let [a, b] = domain.ends(line);
            let starts = ends.from == corner;
            let way = if starts { between(a, b) } else { between(b, a) };
            lines.push((way[1].atan2(way[0]), line, starts));
        }
    }
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut sectors = Vec::new();
    for (i, &(start, line, starts)) in lines.iter().enumerate() {
        let (end, next, next_starts) = lines[(i + 1) % lines.len()];
        let width = if lines.len() == 1 { TAU } else { (end - start).rem_euclid(TAU) };
        if let Some(region) = domain.left_of(line, starts) {
            let lines = [(line, starts), (next, next_starts)];
            sectors.push(Sector { region, lines, start, width, leaves: Vec::new() });
        }
    }
    sectors
}
