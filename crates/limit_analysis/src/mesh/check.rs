//! What can be wrong with an outline, checked from the plain to the subtle. Time grows as n log n.

use std::collections::BTreeMap;

use soilctl_certificate::{LineUse, Statement};

use super::MeshError;
use crate::vector::{between, cross, distance};

/// Most points, lines, or uses of lines in an outline.
const LIMIT: usize = 100_000;

/// Shortest line and least distance of things that are not joined, as a fraction of the outline's extent (or of the
/// largest coordinate, if that is larger): a thousand million such lines would span the outline.
const LEAST: f64 = 1e-9;

/// The checks that need no triangulation. Returns the least distance of things that are not joined.
pub(super) fn check_plain(s: &Statement) -> Result<f64, MeshError> {
    check_amount(s)?;
    let least = LEAST * magnitude(s)?;
    check_lines(s, least)?;
    check_coincidence(s, least)?;
    for region in 0..s.regions.len() {
        check_loops(s, region)?;
    }
    Ok(least)
}

fn check_amount(s: &Statement) -> Result<(), MeshError> {
    let rings = || s.regions.iter().flat_map(|r| &r.loops);
    let uses = rings().map(Vec::len).sum();
    let rings = rings().count();
    let counts = [
        ("points", s.points.len()),
        ("lines", s.lines.len()),
        ("regions", s.regions.len()),
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
fn magnitude(s: &Statement) -> Result<f64, MeshError> {
    let mut magnitude = 0f64;
    for (point, &[x, y]) in s.points.iter().enumerate() {
        if !(x.is_finite() && y.is_finite()) {
            return Err(MeshError::NotFinite { point, x, y });
        }
        magnitude = magnitude.max(x.abs()).max(y.abs());
    }
    if (1e-30..=1e30).contains(&magnitude) { Ok(magnitude) } else { Err(MeshError::Magnitude { magnitude }) }
}

fn check_lines(s: &Statement, least: f64) -> Result<(), MeshError> {
    let count = s.points.len();
    for (line, ends) in s.lines.iter().enumerate() {
        for point in [ends.from, ends.to] {
            if point >= count {
                return Err(MeshError::NoSuchPoint { line, point, count });
            }
        }
        let length = distance(s.points[ends.from], s.points[ends.to]);
        if length <= least {
            return Err(MeshError::ShortLine { line, length, least });
        }
    }
    Ok(())
}

/// Points that lines use must be apart; looked up in a grid so fine that a cell has room for one point only.
fn check_coincidence(s: &Statement, least: f64) -> Result<(), MeshError> {
    let mut used = vec![false; s.points.len()];
    for line in &s.lines {
        used[line.from] = true;
        used[line.to] = true;
    }
    let mut cells: BTreeMap<[i64; 2], usize> = BTreeMap::new();
    for (second, &at) in s.points.iter().enumerate().filter(|&(i, _)| used[i]) {
        // Some 1e9 cells a side, so the conversion is exact.
        let cell = at.map(|c| (1.5 * c / least).floor() as i64);
        let around = (-2..=2).flat_map(|i| (-2..=2).map(move |j| [cell[0] + i, cell[1] + j]));
        for first in around.filter_map(|c| cells.get(&c).copied()) {
            if distance(s.points[first], at) <= least {
                return Err(MeshError::CoincidentPoints { first, second, x: at[0], y: at[1], least });
            }
        }
        cells.insert(cell, second);
    }
    Ok(())
}

fn check_loops(s: &Statement, region: usize) -> Result<(), MeshError> {
    let loops = &s.regions[region].loops;
    if loops.iter().all(Vec::is_empty) {
        return Err(MeshError::Empty { what: "loops in one of its regions" });
    }
    let mut twice_area = 0.0;
    let origin = s.points[0];
    for (ring, uses) in loops.iter().enumerate() {
        if let Some(bad) = uses.iter().find(|u| u.line >= s.lines.len()) {
            let count = s.lines.len();
            return Err(MeshError::NoSuchLine { region, ring, line: bad.line, count });
        }
        for (i, &used) in uses.iter().enumerate() {
            let following = uses[(i + 1) % uses.len()];
            let walked = |u: LineUse| s.lines[u.line].walked(u.forward);
            let ([begin, end], [start, _]) = (walked(used), walked(following));
            if end != start {
                let (line, next) = (used.line, following.line);
                return Err(MeshError::OpenLoop { region, ring, line, end, next, start });
            }
            let (a, b) = (between(origin, s.points[begin]), between(origin, s.points[end]));
            twice_area += cross(a, b);
        }
    }
    if twice_area > 0.0 { Ok(()) } else { Err(MeshError::Orientation { region, area: 0.5 * twice_area }) }
}
