//! The outline with what can be told from its corners alone: what is on either side of each line, and a triangulation
//! of the corners. Building it is the second half of the check.

use std::collections::BTreeMap;

use spade::Triangulation;
use spade::handles::FixedDirectedEdgeHandle;

use super::MeshError;
use super::check::check_plain;
use super::flood::{Conflict, flood};
use super::triangulation::{Cdt, FRAME, VertexId, frame, triangulate};
use crate::vector::{Point, along, angle, between, distance, distance_to_segment};
use soilctl_certificate::Statement;

/// Lines that meet at less than this angle (60 degrees) would refine one another for ever.
const SHARP: f64 = std::f64::consts::FRAC_PI_3;

/// Checks that a statement's geometry can be meshed: every index valid, every coordinate finite, every loop closed, lines
/// that meet only at common points, and regions that do not overlap.
///
/// # Errors
///
/// The first thing that is wrong, with the indices and values concerned.
pub fn check(statement: &Statement) -> Result<(), MeshError> {
    Domain::new(statement).map(|_| ())
}

/// A checked outline.
pub(super) struct Domain<'a> {
    pub(super) statement: &'a Statement,
    /// Corners of the frame.
    pub(super) frame: [Point; FRAME],
    /// Least distance of things that are not joined.
    pub(super) least: f64,
    /// Triangulation of frame and corners, with whole lines as constraints.
    pub(super) base: Cdt,
    /// Region on the left and on the right of each line.
    sides: Vec<[Option<usize>; 2]>,
    /// Outline point of each vertex of `base` from [`FRAME`] on.
    pub(super) corners: Vec<usize>,
    /// Line between two outline points, lower index first.
    between: BTreeMap<[usize; 2], usize>,
}

impl<'a> Domain<'a> {
    pub(super) fn new(statement: &'a Statement) -> Result<Self, MeshError> {
        let least = check_plain(statement)?;
        let sides = sides(statement)?;
        let mut corners: Vec<usize> = statement.lines.iter().flat_map(|l| [l.from, l.to]).collect();
        corners.sort_unstable();
        corners.dedup();
        let at: Vec<Point> = corners.iter().map(|&c| statement.points[c]).collect();
        let frame = frame(&at);
        let mut points = frame.to_vec();
        points.extend(at);
        let base = triangulate(&points, &[])?;
        let mut domain = Self { statement, frame, least, base, sides, corners, between: BTreeMap::new() };
        domain.add_lines()?;
        domain.check_touching()?;
        domain.check_overlap()?;
        Ok(domain)
    }

    /// Lowest and highest corner of a box a little larger than the outline.
    pub(super) fn bounds(&self) -> [Point; 2] {
        // The frame is as far from the outline as that is wide: three times as wide, or high, in all.
        let [low, high] = [self.frame[0], self.frame[2]];
        let by = 0.98 / 3.0 * (high[0] - low[0]).max(high[1] - low[1]);
        [low.map(|c| c + by), high.map(|c| c - by)]
    }

    /// Makes every line a constraint; a line that cannot be one crosses another or runs through a point.
    fn add_lines(&mut self) -> Result<(), MeshError> {
        let mut vertex = vec![0; self.statement.points.len()];
        for (i, &c) in self.corners.iter().enumerate() {
            vertex[c] = FRAME + i;
        }
        for (line, ends) in self.statement.lines.iter().enumerate() {
            if let Some(first) = self.between.insert(pair(ends.from, ends.to), line) {
                return Err(MeshError::DoubleLine { first, second: line });
            }
            let [from, to] = [ends.from, ends.to].map(|p| VertexId::from_index(vertex[p]));
            let crossed = self.base.get_conflicting_edges_between_vertices(from, to).next().map(|e| e.fix());
            if let Some(first) = crossed.and_then(|e| self.base_line(e)) {
                return Err(MeshError::Crossing { first: first.0, second: line });
            }
            let edges = self.base.try_add_constraint(from, to);
            if edges.len() != 1 {
                let through = edges.iter().map(|&e| self.base.directed_edge(e).to().index());
                let through = through.filter(|&v| v >= FRAME).map(|v| self.corners[v - FRAME]);
                let point = through.into_iter().find(|&p| p != ends.to && p != ends.from);
                return Err(self.touching(line, point.unwrap_or(ends.to)));
            }
        }
        Ok(())
    }

    fn touching(&self, line: usize, point: usize) -> MeshError {
        let [x, y] = self.statement.points[point];
        MeshError::Touching { line, point, x, y, least: self.least }
    }

    /// A point next to a line shows as a flat triangle on the line.
    fn check_touching(&self) -> Result<(), MeshError> {
        for edge in self.base.directed_edges().filter(|e| e.is_constraint_edge()) {
            let (Some(apex), Some((line, _))) = (edge.opposite_vertex(), self.base_line(edge.fix())) else {
                continue;
            };
            let [a, b] = self.ends(line);
            let p = apex.position();
            if apex.index() >= FRAME && distance_to_segment([p.x, p.y], [a, b]) <= self.least {
                return Err(self.touching(line, self.corners[apex.index() - FRAME]));
            }
        }
        Ok(())
    }

    fn check_overlap(&self) -> Result<(), MeshError> {
        let claim = |e| self.base_line(e).map(|(line, forward)| self.left_of(line, forward));
        let Err(Conflict { edges, regions }) = flood(&self.base, claim) else { return Ok(()) };
        let name = |r: Option<usize>| r.map_or("the outside".to_owned(), |r| format!("region {r}"));
        let lines = edges.map(|e| self.base_line(e).map(|l| l.0));
        let [first, second] = regions.map(name);
        // An edge of the hull is on no line: then the other is what is wrong.
        let line = |i: usize| lines[i].or(lines[1 - i]).unwrap_or_default();
        Err(MeshError::Overlap { first, second, first_line: line(0), second_line: line(1) })
    }

    /// The line on which an edge of `base` lies, and whether the edge runs along it forwards.
    pub(super) fn base_line(&self, edge: FixedDirectedEdgeHandle) -> Option<(usize, bool)> {
        let edge = self.base.directed_edge(edge);
        let [a, b] = [edge.from().index(), edge.to().index()];
        if !edge.is_constraint_edge() || a < FRAME || b < FRAME {
            return None;
        }
        self.line_between(self.corners[a - FRAME], self.corners[b - FRAME])
    }

    /// The line between two outline points, and whether it runs from the first to the second.
    pub(super) fn line_between(&self, a: usize, b: usize) -> Option<(usize, bool)> {
        self.between.get(&pair(a, b)).map(|&line| (line, self.statement.lines[line].from == a))
    }

    /// What is on the left of a line followed forwards or backwards.
    pub(super) fn left_of(&self, line: usize, forward: bool) -> Option<usize> {
        self.sides[line][usize::from(!forward)]
    }

    /// First and last point of a line.
    pub(super) fn ends(&self, line: usize) -> [Point; 2] {
        self.statement.lines[line].walked(true).map(|p| self.statement.points[p])
    }

    /// Length of a line.
    pub(super) fn length(&self, line: usize) -> f64 {
        let [a, b] = self.ends(line);
        distance(a, b)
    }

    /// The point of a line at the fraction `s`.
    pub(super) fn on_line(&self, line: usize, s: f64) -> Point {
        let [a, b] = self.ends(line);
        along(a, b, s)
    }

    /// Whether two lines meet at a sharp angle.
    pub(super) fn meet_sharply(&self, first: usize, second: usize) -> bool {
        let (a, b) = (self.statement.lines[first], self.statement.lines[second]);
        let points = &self.statement.points;
        let spread = |common: usize, p: usize, q: usize| {
            angle(between(points[common], points[p]), between(points[common], points[q])) < SHARP
        };
        first != second
            && [(a.from, a.to), (a.to, a.from)].into_iter().any(|(common, p)| {
                (common == b.from && spread(common, p, b.to)) || (common == b.to && spread(common, p, b.from))
            })
    }
}

fn pair(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// The region on the left and on the right of each line.
fn sides(statement: &Statement) -> Result<Vec<[Option<usize>; 2]>, MeshError> {
    let mut sides = vec![[None; 2]; statement.lines.len()];
    for (region, r) in statement.regions.iter().enumerate() {
        for used in r.loops.iter().flatten() {
            let side: &mut Option<usize> = &mut sides[used.line][usize::from(!used.forward)];
            if let Some(first) = side.replace(region) {
                let direction = if used.forward { "forwards" } else { "backwards" };
                return Err(MeshError::UsedTwice { line: used.line, direction, first, second: region });
            }
        }
    }
    match sides.iter().position(|s| s == &[None, None]) {
        Some(line) => Err(MeshError::UnusedLine { line }),
        None => Ok(sides),
    }
}
