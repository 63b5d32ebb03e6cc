//! Cover of the consistent set by convex pieces.
//!
//! The (phi, delta) domain is cut into square cells with a diagonal parallel to delta = phi. On each triangle every
//! band boundary, a smooth function of phi and delta, is replaced by the plane through its corner values, moved
//! outwards by what the values at the edge midpoints show of its curvature. For a quadratic function that plane is
//! a strict bound: with deviations m_ij at the midpoints the difference is `4 sum m_ij l_i l_j`, at most 4/3 of the
//! largest. A reserve covers the cubic rest. Cells whose bands cannot meet are dropped, cells whose planes had to
//! move too far are cut into four. So a cell never loses a consistent soil, and the union converges to the
//! consistent set with the square of the cell size.

use rustc_hash::FxHashMap;
use soilctl_earth_pressure::{EarthPressureError, ValidRange};

use crate::constraint::{Band, Constraint, Net};
use crate::end_factor::EndFactors;
use crate::piece::{Piece, Plane};
use crate::{EstimatorError, Setup};

/// Lattice units per degree; the finest cell is two units wide.
const UNITS_PER_DEG: i32 = 256;
/// Cells of the first level, in units: half a degree, so that table nodes fall on cell boundaries.
const FIRST_CELL: i32 = 128;
/// Largest outward move of a band boundary, relative to density: 0.03 %, or about 0.003 deg.
const MOST_MOVE: f64 = 3e-4;
/// Move that is always allowed, relative to density: bands narrower than 1 % cost no more than that.
const LEAST_MOVE: f64 = 1e-5;
/// Largest outward move relative to the height of the narrowest band and what delta sweeps, between these two.
const MOVE_OF_BAND: f64 = 2e-3;
/// Part of the density by which a band shifts when delta grows by a degree: forces grow by 3 to 5 % (Table 4.3).
const SWEEP_PER_DEG: f64 = 0.03;
/// 4/3 for the quadratic part, the rest for what is not quadratic.
const RESERVE: f64 = 4.0 / 3.0 * 1.2;

/// Pieces that together contain every consistent (phi, delta, density).
pub(crate) fn cover(setup: &Setup<'_>, constraints: &[Constraint<'_>]) -> Result<Vec<Piece>, EstimatorError> {
    let (phi, delta) = (setup.phi_range_deg(), setup.delta_deg);
    if delta.0 == delta.1 {
        return cover_section(setup, constraints, delta.0);
    }
    let mut lattice = Lattice::new(setup, constraints, None);
    let mut stack = Vec::new();
    for u in first_cells(phi) {
        stack.extend(first_cells(delta).map(|v| (u, v, FIRST_CELL)));
    }
    stack.reverse();
    let mut pieces = Vec::new();
    while let Some((u, v, size)) = stack.pop() {
        let outside =
            deg(u + size) <= phi.0 || deg(u) >= phi.1 || deg(v + size) <= delta.0 || deg(v) >= delta.1;
        if outside || v > u {
            continue;
        }
        let below = [(u, v), (u + size, v), (u + size, v + size)];
        let above = [(u, v), (u + size, v + size), (u, v + size)];
        let triangles: &[_] = if v == u { &[below] } else { &[below, above] };
        let half = size / 2;
        match lattice.pieces([u, v, size], triangles, phi, delta) {
            Some(found) => pieces.extend(found),
            None => {
                stack.extend([
                    (u + half, v + half, half),
                    (u, v + half, half),
                    (u + half, v, half),
                    (u, v, half),
                ]);
            }
        }
    }
    lattice.finish(pieces)
}

/// Pieces that contain every consistent (phi, density) at one delta. The second coordinate of these pieces means
/// nothing; only their shadow on phi and density does.
pub(crate) fn cover_section(
    setup: &Setup<'_>,
    constraints: &[Constraint<'_>],
    delta_deg: f64,
) -> Result<Vec<Piece>, EstimatorError> {
    let phi = setup.phi_range_deg();
    let phi = (phi.0.max(delta_deg), phi.1);
    let mut lattice = Lattice::new(setup, constraints, Some(delta_deg));
    let mut stack: Vec<_> = first_cells(phi).map(|u| (u, FIRST_CELL)).collect();
    stack.reverse();
    let mut pieces = Vec::new();
    while let Some((u, size)) = stack.pop() {
        if deg(u + size) <= phi.0 || deg(u) >= phi.1 {
            continue;
        }
        let half = size / 2;
        let triangle = [(u, 0), (u + size, 0), (u + size, size)];
        match lattice.pieces([u, 0, size], &[triangle], phi, (f64::NEG_INFINITY, f64::INFINITY)) {
            Some(found) => pieces.extend(found),
            None => stack.extend([(u + half, half), (u, half)]),
        }
    }
    lattice.finish(pieces)
}

/// Lower corners of the first-level cells that an interval in degrees touches, at least one.
fn first_cells((low, high): (f64, f64)) -> impl Iterator<Item = i32> {
    let cell = |x: f64| (x * f64::from(UNITS_PER_DEG) / f64::from(FIRST_CELL)).floor() as i32;
    (cell(low)..=cell(high)).map(|i| i * FIRST_CELL)
}

fn deg(units: i32) -> f64 {
    f64::from(units) / f64::from(UNITS_PER_DEG)
}

enum Enclosure {
    /// No consistent soil over this triangle.
    Empty,
    /// Some corner has no bands (the model is singular there, or its range ends).
    Loose,
    /// Bounding planes, and whether they moved little enough.
    Planes { lower: Vec<Plane>, upper: Vec<Plane>, tight: bool },
}

/// What the model says at lattice points, evaluated once each.
struct Lattice<'a, 'm> {
    constraints: &'a [Constraint<'m>],
    /// Index of a point's first net factors, or `None` where a model has no answer.
    index: FxHashMap<(i32, i32), Option<usize>>,
    nets: Vec<Net>,
    density: Band,
    range: ValidRange,
    /// The only delta, for a section.
    section: Option<f64>,
    /// Part of the density that a band sweeps over the interval of delta.
    sweep: f64,
    /// By how much end factors differ from one that all strokes share; `None` if they share nothing.
    end_tolerance: Option<f64>,
    /// Why the first point without an answer has none.
    refusal: Option<EarthPressureError>,
}

impl<'a, 'm> Lattice<'a, 'm> {
    fn new(setup: &Setup<'_>, constraints: &'a [Constraint<'m>], section: Option<f64>) -> Self {
        let (low, high) = setup.density_range_kg_m3();
        let (index, nets) = (FxHashMap::default(), Vec::new());
        let range = setup.model.valid_range();
        let sweep = SWEEP_PER_DEG * (setup.delta_deg.1 - setup.delta_deg.0);
        let sweep = if section.is_some() { 0.0 } else { sweep };
        Self {
            constraints,
            index,
            nets,
            density: [low, high],
            range,
            section,
            sweep,
            end_tolerance: setup.shares_ends().then_some(setup.end_tolerance),
            refusal: None,
        }
    }

    /// Pieces over the triangles of one cell, one for each interval of a shared end factor, or `None` if it should be cut.
    fn pieces(
        &mut self,
        cell: [i32; 3],
        triangles: &[[(i32, i32); 3]],
        phi: (f64, f64),
        delta: (f64, f64),
    ) -> Option<Vec<Piece>> {
        let finest = cell[2] < 4;
        let mut found = Vec::with_capacity(2);
        for &corners in triangles {
            let mut stack = vec![EndFactors::ANY];
            while let Some(ends) = stack.pop() {
                match self.enclose(corners, ends) {
                    Enclosure::Empty => {}
                    Enclosure::Loose if finest => {}
                    Enclosure::Planes { lower, upper, tight } if tight || finest => {
                        match self.end_tolerance.and_then(|_| ends.halves()) {
                            Some([below, above]) => stack.extend([above, below]),
                            None => {
                                let at = corners.map(|(u, v)| [deg(u), deg(v)]);
                                found.extend(Piece::new(cell, at, ends, lower, upper, phi, delta));
                            }
                        }
                    }
                    Enclosure::Loose | Enclosure::Planes { .. } => return None,
                }
            }
        }
        Some(found)
    }

    /// The pieces, unless the model answered nowhere.
    fn finish(self, pieces: Vec<Piece>) -> Result<Vec<Piece>, EstimatorError> {
        match self.refusal {
            Some(refusal) if self.nets.is_empty() => Err(refusal.into()),
            _ => Ok(pieces),
        }
    }

    fn point(&mut self, (u, v): (i32, i32)) -> Option<usize> {
        if let Some(&known) = self.index.get(&(u, v)) {
            return known;
        }
        let start = self.nets.len();
        let mut place = Some(start);
        // Corners that stick out of the model's range take its value at the edge; the pieces are clipped there.
        let delta = self.section.unwrap_or(deg(v)).clamp(self.range.delta_deg.0, self.range.delta_deg.1);
        let phi = deg(u).clamp(self.range.phi_deg.0, self.range.phi_deg.1).max(delta);
        for constraint in self.constraints {
            match constraint.net(phi, delta) {
                Ok(Some(net)) => self.nets.push(net),
                refused => {
                    self.refusal = self.refusal.take().or(refused.err());
                    self.nets.truncate(start);
                    place = None;
                    break;
                }
            }
        }
        self.index.insert((u, v), place);
        place
    }

    /// The planes that bound densities over a triangle, for end factors in an interval.
    fn enclose(&mut self, corners: [(i32, i32); 3], ends: EndFactors) -> Enclosure {
        let ends = ends.of_strokes(self.end_tolerance.unwrap_or(1.0));
        let middle = |a: (i32, i32), b: (i32, i32)| (i32::midpoint(a.0, b.0), i32::midpoint(a.1, b.1));
        let [a, b, c] = corners;
        let mut places = [0; 6];
        for (place, point) in places.iter_mut().zip([a, b, c, middle(a, b), middle(b, c), middle(c, a)]) {
            match self.point(point) {
                Some(index) => *place = index,
                None => return Enclosure::Loose,
            }
        }
        let n = self.constraints.len();
        let mut lower = Vec::with_capacity(n + 1);
        let mut upper = Vec::with_capacity(n + 1);
        lower.push(Plane([self.density[0]; 3]));
        upper.push(Plane([self.density[1]; 3]));
        let (mut floor, mut ceiling) = (self.density[0], self.density[1]);
        let mut tight = true;
        for i in 0..n {
            let bands: [Band; 6] = places.map(|place| self.constraints[i].band(&self.nets[place + i], ends));
            let at = |point: usize, side: usize| bands[point][side];
            let mut planes = [[0.0; 3]; 2];
            let mut moved = 0.0_f64;
            for (side, plane) in planes.iter_mut().enumerate() {
                let f = [at(0, side), at(1, side), at(2, side)];
                let bend = [
                    at(3, side) - f64::midpoint(f[0], f[1]),
                    at(4, side) - f64::midpoint(f[1], f[2]),
                    at(5, side) - f64::midpoint(f[2], f[0]),
                ];
                let outwards = if side == 0 {
                    bend.into_iter().fold(0.0, f64::min)
                } else {
                    bend.into_iter().fold(0.0, f64::max)
                };
                let shift = RESERVE * outwards;
                moved = moved.max(shift.abs());
                *plane = f.map(|x| x + shift + x.abs() * 1e-12 * if side == 0 { -1.0 } else { 1.0 });
            }
            let height = (0..3).map(|c| planes[1][c] - planes[0][c]).fold(f64::INFINITY, f64::min);
            let density = planes[1].iter().copied().fold(1.0, f64::max);
            let allowed = (MOVE_OF_BAND * (height + self.sweep * density))
                .clamp(LEAST_MOVE * density, MOST_MOVE * density);
            tight &= moved <= allowed;
            floor = floor.max(planes[0].iter().copied().fold(f64::INFINITY, f64::min));
            ceiling = ceiling.min(planes[1].iter().copied().fold(f64::NEG_INFINITY, f64::max));
            lower.push(Plane(planes[0]));
            upper.push(Plane(planes[1]));
        }
        if floor > ceiling {
            return Enclosure::Empty;
        }
        Enclosure::Planes { lower, upper, tight }
    }
}
