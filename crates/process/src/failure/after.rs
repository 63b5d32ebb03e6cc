//! What the force does after failure.

use soilctl_stats::{huber, median};

use crate::blocks::Blocks;

/// Slope and rest after failure, scaled by depth and failure force.
pub(super) struct After {
    pub(super) slope_norm: Option<f64>,
    pub(super) residual_ratio: Option<f64>,
}

impl After {
    /// Looks at half a depth from the failure's block on.
    pub(super) fn of(blocks: &Blocks, block: usize, force_n: f64, depth_m: f64) -> Self {
        let Some(&start) = blocks.u_m.get(block) else {
            return Self { slope_norm: None, residual_ratio: None };
        };
        let after: Vec<([f64; 2], f64)> = blocks.u_m[block..]
            .iter()
            .zip(&blocks.f_n[block..])
            .map(|(u, f)| ((u - start) / depth_m, f / force_n))
            .filter(|(x, _)| (0.0..=0.55).contains(x))
            .map(|(x, y)| ([1.0, x], y))
            .collect();
        let travel = after.iter().map(|([_, x], _)| *x).fold(0.0, f64::max);
        let slope_norm = (after.len() >= 8 && travel > 0.05)
            .then(|| huber(&after))
            .flatten()
            .map(|(solved, _)| solved.x[1])
            .filter(|slope| slope.is_finite());
        let mut at_half: Vec<f64> =
            after.iter().filter(|([_, x], _)| (0.45..=0.55).contains(x)).map(|(_, y)| *y).collect();
        let residual_ratio = (!at_half.is_empty()).then(|| median(&mut at_half));
        Self { slope_norm, residual_ratio }
    }
}
