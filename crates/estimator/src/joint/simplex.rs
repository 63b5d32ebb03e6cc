//! The consistent set over a simplex of angles, enclosed in a polytope.
//!
//! Over the simplex with barycentric coordinates `l`, what a measurement says is `density + sum x_k r_k(l) >= f(l)` (or `<=`), with the
//! loads x. Smooth functions f and r are bounded by planes, as in the cover without such loads: with deviations `m_ij` at the midpoints of edges from the
//! plane through the corners, a quadratic function differs from that plane by `4 sum m_ij l_i l_j`, at most `2 d / (d + 1)` times the largest in d
//! dimensions. A product is bounded by its value at either end of the load (McCormick 1976): for r in `[r_1, r_2]`
//!
//! ```text
//! x r(l)  <=  x_1 r(l) + (x - x_1) r_2      and      x r(l)  <=  x_2 r(l) + (x - x_2) r_1 .
//! ```

use super::factors::{Bounds, Factors, LOADS, Node, Told, deg};
use super::linear::{Coefficients, MOST_DIMENSIONS, Polytope};
use super::unknowns::Quantity;
use crate::EstimatorError;

/// Reserve for what is not quadratic, on top of `2 d / (d + 1)`.
const RESERVE: f64 = 1.5;
/// The same where a function turns from one curvature to the other, relative, for an edge of a degree; it goes with its cube.
const CUBIC: f64 = 1e-4;
/// Relative noise of the models: they search a mechanism to 1e-7, which loads beside the weight see to first order.
const NOISE: f64 = 1e-6;

/// What is left of density, cohesion, adhesion and surcharge.
pub(super) type Box4 = [[f64; 2]; 4];

/// A simplex of the lattice: its corners, of which the first has the least angles. An angle that is known is 0 in all of them.
pub(super) struct Simplex {
    pub(super) corners: Vec<Node>,
    /// Length of the edges of its cell, in lattice units.
    pub(super) size: i32,
}

/// The polytope over a simplex. Its coordinates are barycentric ones of all corners but the first, then those linear quantities that are not known, each
/// from 0 to 1 in its interval.
pub(super) struct Over<'c> {
    simplex: &'c Simplex,
    linear: Box4,
    polytope: Polytope,
}

/// Knowledge that holds everywhere: intervals of the angles in degrees, and adhesion as a share of cohesion.
pub(super) struct Known {
    pub(super) angles_deg: [(f64, f64); 3],
    pub(super) share: Option<(f64, f64)>,
}

impl<'c> Over<'c> {
    /// The polytope of a simplex, for linear quantities in a box; `None` where no soil is consistent.
    pub(super) fn new(
        factors: &mut Factors<'_, '_>,
        known: &Known,
        simplex: &'c Simplex,
        linear: Box4,
    ) -> Result<Option<Self>, EstimatorError> {
        let d = simplex.corners.len() - 1;
        let free = linear.iter().filter(|[low, high]| low < high).count();
        let mut over = Self { simplex, linear, polytope: Polytope::new(d + free) };
        over.domain(known);
        let corners =
            simplex.corners.iter().map(|&node| factors.place(node)).collect::<Result<Vec<_>, _>>()?;
        let mut edges = Vec::with_capacity(d * (d + 1) / 2);
        for (i, a) in simplex.corners.iter().enumerate() {
            for (j, b) in simplex.corners.iter().enumerate().skip(i + 1) {
                let middle = [0, 1, 2].map(|axis| i32::midpoint(a[axis], b[axis]));
                edges.push(([i, j], factors.place(middle)?));
            }
        }
        for measurement in 0..factors.count() {
            let told = |place: usize| factors.told(place, measurement);
            let bounds = |told: Told| match told {
                Told::Bounds(bounds) => Some(bounds),
                Told::Singular | Told::Nothing => None,
            };
            let at_corners: Option<Vec<Bounds>> = corners.iter().map(|&place| bounds(told(place))).collect();
            let at_edges: Option<Vec<([usize; 2], Bounds)>> =
                edges.iter().map(|&(ends, place)| Some((ends, bounds(told(place))?))).collect();
            match (at_corners, at_edges) {
                (Some(corners), Some(edges)) => over.measurement(&corners, &edges),
                // Resistance grows with all three angles, so that soils which carry any force have greater ones than all that do not.
                _ => match corners.first().map(|&place| told(place)) {
                    Some(Told::Bounds(least)) => over.at_most(least.force[1]),
                    Some(Told::Singular)
                        if corners.iter().all(|&place| matches!(told(place), Told::Singular)) =>
                    {
                        return Ok(None);
                    }
                    Some(Told::Singular | Told::Nothing) | None => {}
                },
            }
        }
        Ok(Some(over))
    }

    /// Barycentric coordinates add up to at most 1, and angles lie in their intervals.
    fn domain(&mut self, known: &Known) {
        let d = self.simplex.corners.len() - 1;
        let mut sum = [0.0; MOST_DIMENSIONS];
        sum[..d].fill(1.0);
        self.polytope.push(sum, 1.0);
        for (axis, (low, high)) in known.angles_deg.into_iter().enumerate() {
            let (start, steps) = self.angle(axis);
            if steps.iter().any(|step| *step != 0.0) {
                self.polytope.push(steps, high - start);
                self.polytope.push(steps.map(|step| -step), start - low);
            }
        }
        if let Some((low, high)) = known.share {
            // adhesion <= high cohesion, and >= low cohesion.
            let (cohesion, adhesion) = (self.linear(1), self.linear(2));
            for (share, sign) in [(high, 1.0), (low, -1.0)] {
                let mut row = [0.0; MOST_DIMENSIONS];
                for ((_, coefficients), by) in [(&adhesion, sign), (&cohesion, -sign * share)] {
                    for (row, c) in row.iter_mut().zip(coefficients) {
                        *row += by * c;
                    }
                }
                self.polytope.push(row, sign * (share * cohesion.0 - adhesion.0));
            }
        }
    }

    /// An angle in degrees as a function of the coordinates.
    fn angle(&self, axis: usize) -> (f64, Coefficients) {
        let mut steps = [0.0; MOST_DIMENSIONS];
        let Some((first, others)) = self.simplex.corners.split_first() else { return (0.0, steps) };
        for (step, corner) in steps.iter_mut().zip(others) {
            *step = deg(corner[axis] - first[axis]);
        }
        (deg(first[axis]), steps)
    }

    /// A linear quantity as a function of the coordinates.
    fn linear(&self, place: usize) -> (f64, Coefficients) {
        let mut steps = [0.0; MOST_DIMENSIONS];
        let [low, high] = self.linear[place];
        if let Some(coordinate) = self.coordinate(place) {
            steps[coordinate] = high - low;
        }
        (low, steps)
    }

    /// The coordinate of a linear quantity that is not known.
    fn coordinate(&self, place: usize) -> Option<usize> {
        let free = |place: usize| self.linear[place][0] < self.linear[place][1];
        free(place).then(|| self.simplex.corners.len() - 1 + (0..place).filter(|&k| free(k)).count())
    }

    /// Density of at most so much, by the corner of least resistance alone.
    fn at_most(&mut self, density: f64) {
        let (low, row) = self.linear(0);
        // A density that is known leaves a row without coefficients.
        self.polytope.push(row, density * (1.0 + NOISE) - low);
    }

    /// Rows of a measurement whose bounds are known at all corners and midpoints.
    fn measurement(&mut self, corners: &[Bounds], edges: &[([usize; 2], Bounds)]) {
        for side in [0, 1] {
            let outwards = [-1.0, 1.0][side];
            let force = self.plane(corners, edges, outwards, |bounds| bounds.force[side]);
            let shares: [Vec<f64>; LOADS] =
                [0, 1, 2].map(|k| self.plane(corners, edges, -outwards, |bounds| bounds.loads[side][k]));
            let other_side: [Vec<f64>; LOADS] =
                [0, 1, 2].map(|k| self.plane(corners, edges, outwards, |bounds| bounds.loads[side][k]));
            // Ends of the shares over the simplex: on the side of the plane, and on the other.
            let end = |planes: &[Vec<f64>; LOADS], k: usize, sign: f64| {
                sign * planes[k].iter().fold(f64::NEG_INFINITY, |most, share| most.max(sign * share))
            };
            let any_free = (1..=LOADS).any(|place| self.coordinate(place).is_some());
            for reference in [0, 1] {
                if reference == 1 && !any_free {
                    break;
                }
                // From the least loads the share that makes most of the load, from the greatest the one that makes least.
                let share = |k: usize| match reference {
                    0 => end(&shares, k, -outwards),
                    _ => end(&other_side, k, outwards),
                };
                let load = |k: usize| self.linear[k + 1][reference];
                let at = |corner: usize| {
                    force[corner] - (0..LOADS).map(|k| load(k) * shares[k][corner]).sum::<f64>()
                };
                let mut row = [0.0; MOST_DIMENSIONS];
                for (corner, coefficient) in row.iter_mut().enumerate().take(corners.len() - 1) {
                    *coefficient = at(corner + 1) - at(0);
                }
                let mut rest = at(0);
                for place in 0..=LOADS {
                    let share = place.checked_sub(1).map_or(1.0, share);
                    let [low, high] = self.linear[place];
                    let reference = place.checked_sub(1).map_or(0.0, load);
                    rest -= (low - reference) * share;
                    if let Some(coordinate) = self.coordinate(place) {
                        row[coordinate] = -(high - low) * share;
                    }
                }
                // Lower side: force - density - loads <= 0; the upper one the other way round.
                self.polytope.push(row.map(|a| -outwards * a), outwards * rest);
            }
        }
    }

    /// Values at the corners of a plane that is a bound on a function, below it (-1) or above it (1).
    fn plane(
        &self,
        corners: &[Bounds],
        edges: &[([usize; 2], Bounds)],
        sign: f64,
        of: impl Fn(&Bounds) -> f64,
    ) -> Vec<f64> {
        let values: Vec<f64> = corners.iter().map(&of).collect();
        let bend = |&([i, j], ref middle): &([usize; 2], Bounds)| {
            sign * (of(middle) - f64::midpoint(values[i], values[j]))
        };
        let most = edges.iter().map(bend).fold(0.0, f64::max);
        let d = (corners.len() - 1) as f64;
        let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let reserve = CUBIC * deg(self.simplex.size).powi(3) + NOISE;
        let shift = RESERVE * 2.0 * d / (d + 1.0) * most + reserve * size;
        values.iter().map(|value| value + sign * shift).collect()
    }

    /// A quantity as a function of the coordinates.
    pub(super) fn quantity(&self, quantity: Quantity) -> (f64, Coefficients) {
        match quantity {
            Quantity::Friction => self.angle(0),
            Quantity::InterfaceFriction => self.angle(1),
            Quantity::Slope => self.angle(2),
            Quantity::Density => self.linear(0),
            Quantity::Cohesion => self.linear(1),
            Quantity::Adhesion => self.linear(2),
            Quantity::Surcharge => self.linear(3),
        }
    }

    /// Least and greatest value of a function; `None` if no soil is consistent.
    pub(super) fn range(&self, (start, steps): &(f64, Coefficients)) -> Option<[f64; 2]> {
        let low = self.polytope.least(steps)?;
        let high = self.polytope.least(&steps.map(|step| -step))?;
        Some([start + low, start - high])
    }
}
