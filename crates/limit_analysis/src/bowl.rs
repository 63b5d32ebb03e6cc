//! The part of the soil that may move in an upper bound.
//!
//! A proof needs flows that dilate a little more than friction demands, everywhere. Soil can only do that where it has a
//! way out, so what is free to move must be a bowl: with walls no steeper than `90 deg - phi`, all of it could be lifted
//! out along any path between the walls. Below the bowl nothing moves; along it velocities may jump.

use crate::mesh::{Guide, Mesh};

/// Walls are flatter than the limit by this angle in radians.
const SPARE: f64 = 0.1;

/// Distance of the points that describe the bowl.
const STEP: f64 = 0.1;

/// The least set of points above V-shaped walls under each slip line point.
#[derive(Debug, Clone)]
pub(crate) struct Bowl {
    /// Lowest points of the Vs.
    bottoms: Vec<[f64; 2]>,
    slope: f64,
    datum: f64,
}

impl Bowl {
    /// A bowl that clears the given lines by `margin`, for soil with friction angle `phi` in radians.
    pub(crate) fn around(guides: &[Guide], margin: f64, phi: f64, datum: f64) -> Self {
        let bottoms = guides.iter().flat_map(|g| &g.points).map(|p| [p[0], p[1] - margin]).collect();
        Self { bottoms, slope: (std::f64::consts::FRAC_PI_2 - phi - SPARE).max(0.1).tan(), datum }
    }

    /// Height of the wall at `x`; above the datum where the bowl has ended.
    fn wall(&self, x: f64) -> f64 {
        self.bottoms.iter().map(|b| b[1] + self.slope * (x - b[0]).abs()).fold(f64::INFINITY, f64::min)
    }

    /// The wall as a guide, from surface to surface.
    pub(crate) fn guide(&self) -> Option<Guide> {
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
        mesh.triangles
            .iter()
            .map(|t| {
                let v = t.corners.map(|c| mesh.vertices[c].position);
                let mean = |i: usize| (v[0][i] + v[1][i] + v[2][i]) / 3.0;
                !self.bottoms.is_empty() && mean(1) < self.wall(mean(0))
            })
            .collect()
    }
}
