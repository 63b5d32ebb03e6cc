//! The zone of the soil that may move in an upper bound; the rest is held.
//!
//! A proof needs velocities that dilate a little more than friction demands, everywhere. Soil can only do that where it has
//! a way out. So the mobile zone has walls no steeper than `90 deg - phi`: all of it could be lifted out along any path
//! between the walls. Below, nothing moves; along the walls velocities may jump. Around a structure in the soil the zone
//! follows the slip lines; otherwise its walls start where steep sides that hold the soil end above. On a smooth base soil
//! can move away from a wall only along the base, so only if the wall is no flatter than `phi`: where it cannot be both,
//! above 42 degrees, there is no wall, and the soil slides away from the side itself.
//!
//! Soil without friction keeps its volume in any motion, so nothing of it is held.

use soilctl_certificate::Condition;

use crate::mesh::{Guide, Mesh};
use crate::problem::Problem;
use crate::vector::centroid;

/// Walls are flatter than the limit by this angle in radians.
const SPARE: f64 = 0.1;

/// Distance of the points that describe a wall.
const STEP: f64 = 0.1;

fn slope(phi: f64) -> f64 {
    (std::f64::consts::FRAC_PI_2 - phi - SPARE).max(0.1).tan()
}

fn is_on_smooth_base(problem: &Problem, foot: [f64; 2]) -> bool {
    problem
        .statement()
        .boundaries
        .iter()
        .any(|b| matches!(b.condition, Condition::Smooth) && problem.ends(b.line).contains(&foot))
}

/// The least set of points above V-shaped walls under each slip line point.
#[derive(Debug, Clone)]
pub(crate) struct MobileZone {
    /// Lowest points of the Vs.
    bottoms: Vec<[f64; 2]>,
    /// Upper ends of sides that hold the soil, and the sense along x that leads away from them.
    rims: Vec<([f64; 2], f64)>,
    slope: f64,
    datum: f64,
    /// Height at which the soil ends below.
    bottom: f64,
}

impl MobileZone {
    /// A zone that clears the given lines by `margin`, for soil with friction angle `phi` in radians.
    pub(crate) fn around(guides: &[Guide], margin: f64, phi: f64, datum: f64) -> Self {
        let bottoms = guides.iter().flat_map(|g| &g.points).map(|p| [p[0], p[1] - margin]).collect();
        Self { bottoms, rims: Vec::new(), slope: slope(phi), datum, bottom: datum }
    }

    /// The same, where what holds the soil begins at a tip: it holds it there too.
    pub(crate) fn held_below(mut self, sides: &Self, tips: &[[f64; 2]]) -> Self {
        self.rims = sides.rims.iter().copied().filter(|(top, _)| tips.contains(top)).collect();
        self.bottom = sides.bottom;
        self
    }

    /// A zone between steep sides that hold the soil; with friction angle `phi` in radians.
    pub(crate) fn between_sides(problem: &Problem, phi: f64) -> Self {
        let mut rims: Vec<([f64; 2], f64)> = Vec::new();
        let mut feet = Vec::new();
        for b in &problem.statement().boundaries {
            if phi == 0.0 || !matches!(b.condition, Condition::Fixed | Condition::Far) {
                continue;
            }
            let [p, q] = problem.ends(b.line);
            let (low, high) = if p[1] < q[1] { (p, q) } else { (q, p) };
            let is_steep = (high[1] - low[1]) > slope(phi) * (high[0] - low[0]).abs();
            if is_steep && !(slope(phi) < phi.tan() && is_on_smooth_base(problem, low)) {
                // The soil is on the left of the side as it is walked.
                let up = (q[1] > p[1]) == b.forward;
                rims.push((high, if up { -1.0 } else { 1.0 }));
                feet.push(low);
            }
        }
        rims.retain(|(high, _)| !feet.contains(high));
        let heights = problem.statement().points.iter().map(|p| p[1]);
        let bottom = heights.fold(f64::INFINITY, f64::min);
        Self { bottoms: Vec::new(), rims, slope: slope(phi), datum: problem.statement().datum, bottom }
    }

    /// Height of the wall at `x`; above the datum where the zone has ended.
    fn wall(&self, x: f64) -> f64 {
        self.bottoms.iter().map(|b| b[1] + self.slope * (x - b[0]).abs()).fold(f64::INFINITY, f64::min)
    }

    /// The walls as guides.
    pub(crate) fn guide(&self) -> Vec<Guide> {
        let rim = |(top, inwards): &([f64; 2], f64)| {
            let reach = inwards * (top[1] - self.bottom) / self.slope;
            Guide { points: vec![*top, [top[0] + reach, self.bottom]] }
        };
        self.below_slip_lines().into_iter().chain(self.rims.iter().map(rim)).collect()
    }

    /// The wall below slip lines, from surface to surface.
    fn below_slip_lines(&self) -> Option<Guide> {
        let ends = self.bottoms.iter().map(|b| (self.datum - b[1]) / self.slope);
        let low = self.bottoms.iter().zip(ends.clone()).map(|(b, w)| b[0] - w).fold(f64::INFINITY, f64::min);
        let high = self.bottoms.iter().zip(ends).map(|(b, w)| b[0] + w).fold(f64::NEG_INFINITY, f64::max);
        let pieces = ((high - low) / STEP).ceil();
        if !(1.0..1e5).contains(&pieces) {
            return None;
        }
        let points = (0..=pieces as usize).map(|i| {
            let x = low + (high - low) * i as f64 / pieces;
            [x, self.wall(x).min(self.datum)]
        });
        Some(Guide { points: points.collect() })
    }

    /// Triangles below the wall.
    pub(crate) fn still(&self, mesh: &Mesh) -> Vec<bool> {
        (0..mesh.triangles.len())
            .map(|t| {
                let [x, y] = centroid(&mesh.corners(t));
                let is_outside = |(top, inwards): &([f64; 2], f64)| {
                    let away = inwards * (x - top[0]);
                    away > 0.0 && y < top[1] - self.slope * away
                };
                let is_below = !self.bottoms.is_empty() && y < self.wall(x);
                is_below || self.rims.iter().any(is_outside)
            })
            .collect()
    }
}
