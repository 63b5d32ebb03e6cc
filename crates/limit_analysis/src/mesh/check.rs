//! What can be wrong with an outline, checked from the plain to the subtle. Time grows as n log n.

use std::collections::BTreeMap;

use super::MeshError;
use super::domain::Domain;
use super::outline::{LineUse, Outline, RegionOutline};
use super::vector::{between, cross, distance};

/// Most points, lines, or uses of lines in an outline.
const LIMIT: usize = 100_000;

/// Shortest line and least distance of things that are not joined, as a fraction of the outline's extent (or of the
/// largest coordinate, if that is larger): a thousand million such lines would span the outline.
const LEAST: f64 = 1e-9;

impl Outline {
    /// Checks that the outline can be meshed: every index valid, every coordinate finite, every loop closed, lines
    /// that meet only at common points, and regions that do not overlap.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong, with the indices and values concerned.
    pub fn check(&self) -> Result<(), MeshError> {
        Domain::new(self).map(|_| ())
    }

    /// The checks that need no triangulation. Returns the least distance of things that are not joined.
    pub(super) fn check_plain(&self) -> Result<f64, MeshError> {
        self.check_amount()?;
        let least = LEAST * self.magnitude()?;
        self.check_lines(least)?;
        self.check_coincidence(least)?;
        for (region, outline) in self.regions.iter().enumerate() {
            self.check_loops(region, outline)?;
        }
        Ok(least)
    }

    fn check_amount(&self) -> Result<(), MeshError> {
        let rings = || self.regions.iter().flat_map(|r| &r.loops);
        let uses = rings().map(Vec::len).sum();
        let rings = rings().count();
        let counts = [
            ("points", self.points.len()),
            ("lines", self.lines.len()),
            ("regions", self.regions.len()),
            ("loops", rings),
            ("uses of lines in loops", uses),
        ];
        for (what, count) in counts {
            if count == 0 {
                return Err(MeshError::Empty { what });
            }
            // Every line can be used twice.
            let limit = if what.starts_with("uses") { 2 * LIMIT } else { LIMIT };
            if count > limit {
                return Err(MeshError::TooMuch { what, count, limit });
            }
        }
        Ok(())
    }

    /// Largest of the absolute coordinates: rounding errors are relative to it.
    fn magnitude(&self) -> Result<f64, MeshError> {
        let mut magnitude = 0f64;
        for (point, &[x, y]) in self.points.iter().enumerate() {
            if !(x.is_finite() && y.is_finite()) {
                return Err(MeshError::NotFinite { point, x, y });
            }
            magnitude = magnitude.max(x.abs()).max(y.abs());
        }
        if (1e-30..=1e30).contains(&magnitude) {
            Ok(magnitude)
        } else {
            Err(MeshError::Magnitude { magnitude })
        }
    }

    fn check_lines(&self, least: f64) -> Result<(), MeshError> {
        let count = self.points.len();
        for (line, ends) in self.lines.iter().enumerate() {
            for point in [ends.from, ends.to] {
                if point >= count {
                    return Err(MeshError::NoSuchPoint { line, point, count });
                }
            }
            let length = distance(self.points[ends.from], self.points[ends.to]);
            if length <= least {
                return Err(MeshError::ShortLine { line, length, least });
            }
        }
        Ok(())
    }

    /// Points that lines use must be apart; looked up in a grid so fine that a cell has room for one point only.
    fn check_coincidence(&self, least: f64) -> Result<(), MeshError> {
        let mut used = vec![false; self.points.len()];
        for line in &self.lines {
            used[line.from] = true;
            used[line.to] = true;
        }
        let mut cells: BTreeMap<[i64; 2], usize> = BTreeMap::new();
        for (second, &at) in self.points.iter().enumerate().filter(|&(i, _)| used[i]) {
            // Some 1e9 cells a side, so the conversion is exact.
            let cell = at.map(|c| (1.5 * c / least).floor() as i64);
            let around = (-2..=2).flat_map(|i| (-2..=2).map(move |j| [cell[0] + i, cell[1] + j]));
            for first in around.filter_map(|c| cells.get(&c).copied()) {
                if distance(self.points[first], at) <= least {
                    return Err(MeshError::CoincidentPoints { first, second, x: at[0], y: at[1], least });
                }
            }
            cells.insert(cell, second);
        }
        Ok(())
    }

    /// Start and end of a line as a loop runs along it.
    pub(super) fn ends(&self, used: LineUse) -> [usize; 2] {
        let line = self.lines[used.line];
        if used.forward { [line.from, line.to] } else { [line.to, line.from] }
    }

    fn check_loops(&self, region: usize, outline: &RegionOutline) -> Result<(), MeshError> {
        if outline.loops.iter().all(Vec::is_empty) {
            return Err(MeshError::Empty { what: "loops in one of its regions" });
        }
        let mut twice_area = 0.0;
        let origin = self.points[0];
        for (ring, uses) in outline.loops.iter().enumerate() {
            if let Some(bad) = uses.iter().find(|u| u.line >= self.lines.len()) {
                let count = self.lines.len();
                return Err(MeshError::NoSuchLine { region, ring, line: bad.line, count });
            }
            for (i, &used) in uses.iter().enumerate() {
                let following = uses[(i + 1) % uses.len()];
                let ([begin, end], [start, _]) = (self.ends(used), self.ends(following));
                if end != start {
                    let (line, next) = (used.line, following.line);
                    return Err(MeshError::OpenLoop { region, ring, line, end, next, start });
                }
                let (a, b) = (between(origin, self.points[begin]), between(origin, self.points[end]));
                twice_area += cross(a, b);
            }
        }
        if twice_area > 0.0 { Ok(()) } else { Err(MeshError::Orientation { region, area: 0.5 * twice_area }) }
    }
}
