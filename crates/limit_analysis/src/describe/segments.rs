//! All lines of a description as segments, with coordinates that were meant to be equal made equal.

use super::error::DescriptionError;
use super::input::{Description, Water};
use crate::vector::Point;

/// Coordinates this close, as a fraction of the extent, are one.
const SNAP: f64 = 1e-9;

/// What is closer than this and not joined is a mistake.
const NEAR: f64 = 1e-6;

/// Whose segment it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    Region(usize),
    Structure(usize),
    /// Edge of a structure given as a line on the outline.
    Edge(usize),
    Plate(usize),
    Boundary(usize),
    Member(usize),
    Head(usize),
    Water,
    Cut(Cut),
}

/// Why a region is cut by a vertical line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cut {
    /// The water table bends above.
    Water,
    /// The weight of the soil above changes its slope.
    Ratio,
    /// The tops of a region of other unit weight must be straight.
    Weight,
    /// The pressure of flowing water changes its gradient.
    Flow,
}

/// A segment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    pub(super) ends: [Point; 2],
    pub(super) owner: Owner,
    /// Number of the segment among those of its owner.
    pub(super) number: usize,
}

/// The drawing: snapped polygons and lines.
#[derive(Debug, Clone)]
pub(super) struct Drawing {
    pub(super) regions: Vec<Vec<Point>>,
    pub(super) structures: Vec<Vec<Point>>,
    edges: Vec<Vec<Point>>,
    pub(super) plates: Vec<Vec<Point>>,
    pub(super) lines: Vec<Vec<Point>>,
    pub(super) members: Vec<Vec<Point>>,
    /// Where heads are given, with points at the level of the open water.
    pub(super) heads: Vec<Vec<Point>>,
    pub(super) water: Vec<Point>,
    /// Least and greatest coordinates of all soil.
    pub(super) low: Point,
    pub(super) high: Point,
    /// Lengths below which things are one, and too close.
    pub(super) snap: f64,
    pub(super) near: f64,
}

impl Drawing {
    pub(super) fn new(description: &Description) -> Self {
        let corners = || description.regions.iter().flat_map(|r| &r.polygon);
        let extreme =
            |axis: usize, sign: f64| sign * corners().map(|p| sign * p[axis]).fold(f64::INFINITY, f64::min);
        let (mut low, mut high) = ([0, 1].map(|a| extreme(a, 1.0)), [0, 1].map(|a| extreme(a, -1.0)));
        // Rounding errors are relative to the coordinates.
        let largest = low.iter().chain(&high).fold(0.0, |m: f64, c| m.max(c.abs()));
        let size = (high[0] - low[0]).max(high[1] - low[1]).max(1e-3 * largest).max(f64::MIN_POSITIVE);
        let mut drawing = Self {
            regions: description.regions.iter().map(|r| r.polygon.clone()).collect(),
            structures: description.structures.iter().map(|s| s.polygon.clone()).collect(),
            edges: description.structures.iter().map(|s| s.edge.clone()).collect(),
            plates: description.plates.iter().map(|p| p.line.clone()).collect(),
            lines: description.boundaries.iter().map(|b| b.line.clone()).collect(),
            members: description.members.iter().map(|m| m.line.clone()).collect(),
            heads: description.heads.iter().map(|h| h.line.clone()).collect(),
            water: description.water.iter().flat_map(Water::levels).collect(),
            low,
            high,
            snap: SNAP * size,
            near: NEAR * size,
        };
        for axis in [0, 1] {
            let snap = drawing.snap;
            let mut values: Vec<f64> = drawing.points().map(|p| p[axis]).collect();
            values.sort_by(f64::total_cmp);
            let mut kept: Vec<f64> = Vec::new();
            for value in values {
                if kept.last().is_none_or(|last| value - last > snap) {
                    kept.push(value);
                }
            }
            // The greatest of those kept that is not above.
            let snapped = |value: f64| kept[kept.partition_point(|k| *k <= value).max(1) - 1];
            drawing.points().for_each(|p| p[axis] = snapped(p[axis]));
            (low[axis], high[axis]) = (snapped(low[axis]), snapped(high[axis]));
        }
        (drawing.low, drawing.high) = (low, high);
        for (line, entry) in drawing.heads.iter_mut().zip(&description.heads) {
            *line = with_level(line, entry.head_m, drawing.snap);
        }
        drawing
    }

    fn points(&mut self) -> impl Iterator<Item = &mut Point> {
        let lines = [
            &mut self.regions,
            &mut self.structures,
            &mut self.edges,
            &mut self.plates,
            &mut self.lines,
            &mut self.members,
            &mut self.heads,
        ];
        lines.into_iter().flatten().flatten().chain(&mut self.water)
    }

    /// All segments that the description names; the water table goes on to the sides.
    pub(super) fn segments(&self, description: &Description) -> Result<Vec<Segment>, DescriptionError> {
        let mut all = Vec::new();
        for (i, polygon) in self.regions.iter().enumerate() {
            add(&mut all, polygon, true, Owner::Region(i), || description.region_title(i))?;
        }
        for (i, polygon) in self.structures.iter().enumerate() {
            add(&mut all, polygon, true, Owner::Structure(i), || description.structure_title(i))?;
        }
        for (i, line) in self.edges.iter().enumerate() {
            add(&mut all, line, false, Owner::Edge(i), || description.structure_title(i))?;
        }
        for (i, line) in self.plates.iter().enumerate() {
            add(&mut all, line, false, Owner::Plate(i), || description.plate_title(i))?;
        }
        for (i, line) in self.lines.iter().enumerate() {
            add(&mut all, line, false, Owner::Boundary(i), || description.boundary_title(i))?;
        }
        for (i, line) in self.members.iter().enumerate() {
            add(&mut all, line, false, Owner::Member(i), || description.member_title(i))?;
        }
        for (i, line) in self.heads.iter().enumerate() {
            add(&mut all, line, false, Owner::Head(i), || description.head_title(i))?;
        }
        if let (Some(first), Some(last)) = (self.water.first(), self.water.last()) {
            let mut table = self.water.clone();
            if self.low[0] < first[0] {
                table.insert(0, [self.low[0], first[1]]);
            }
            if self.high[0] > last[0] {
                table.push([self.high[0], last[1]]);
            }
            add(&mut all, &table, false, Owner::Water, || "water".into())?;
            for p in table.iter().filter(|p| p[1] > self.low[1] && p[0] > self.low[0] && p[0] < self.high[0])
            {
                all.push(self.cut(*p, self.low[1], Cut::Water));
            }
        }
        Ok(all)
    }

    /// A vertical cut.
    pub(super) fn cut(&self, from: Point, to: f64, why: Cut) -> Segment {
        Segment { ends: [from, [from[0], to]], owner: Owner::Cut(why), number: 0 }
    }

    /// The y of the water table; none without water.
    pub(super) fn table(&self, x: f64) -> Option<f64> {
        let (first, last) = (self.water.first()?, self.water.last()?);
        if x <= first[0] {
            return Some(first[1]);
        }
        let after = self.water.iter().position(|p| p[0] >= x);
        Some(match after {
            Some(i) => {
                let [a, b] = [self.water[i - 1], self.water[i]];
                if a[1] == b[1] { a[1] } else { a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) }
            }
            None => last[1],
        })
    }

    /// Straight line of the water table around `x`: a point on it and its slope.
    pub(super) fn table_line(&self, x: f64) -> Option<(Point, f64)> {
        let (first, last) = (*self.water.first()?, *self.water.last()?);
        let piece = self.water.windows(2).find(|w| (w[0][0]..=w[1][0]).contains(&x));
        Some(match piece {
            Some(w) => (w[0], (w[1][1] - w[0][1]) / (w[1][0] - w[0][0])),
            None if x < first[0] => (first, 0.0),
            None => (last, 0.0),
        })
    }
}

/// A line with further points where it crosses a level.
fn with_level(line: &[Point], level: f64, snap: f64) -> Vec<Point> {
    let mut points = Vec::with_capacity(line.len());
    for (i, b) in line.iter().enumerate() {
        let before = i.checked_sub(1).map(|before| line[before]);
        if let Some(a) = before.filter(|a| (a[1] - level).min(b[1] - level) < -snap)
            && (a[1] - level).max(b[1] - level) > snap
        {
            points.push([a[0] + (b[0] - a[0]) * (level - a[1]) / (b[1] - a[1]), level]);
        }
        points.push(*b);
    }
    points
}

fn add(
    all: &mut Vec<Segment>,
    points: &[Point],
    closed: bool,
    owner: Owner,
    entry: impl Fn() -> String,
) -> Result<(), DescriptionError> {
    let last = if closed { points.first() } else { None };
    let next = points.iter().skip(1).chain(last);
    for (number, (a, b)) in points.iter().zip(next).enumerate() {
        if a == b {
            let problem =
                format!("two points that follow each other are both at ({}, {}); leave one out", a[0], a[1]);
            return Err(DescriptionError::entry(entry(), problem));
        }
        all.push(Segment { ends: [*a, *b], owner, number });
    }
    // Only the line of a boundary may end where it starts.
    let again = |(i, p): (usize, &Point)| points[..i].contains(p).then_some(*p);
    match points.iter().enumerate().find_map(again).filter(|_| !matches!(owner, Owner::Boundary(_))) {
        Some([x, y]) => {
            Err(DescriptionError::entry(entry(), format!("it crosses or touches itself at ({x}, {y})")))
        }
        None => Ok(()),
    }
}
