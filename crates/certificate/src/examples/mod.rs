//! Small problems with known answers, for tests.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod around;
mod blocks;
mod clay;
mod fill;
mod fitted;
mod grid;
mod plate;
mod wall;

pub(crate) use blocks::Blocks;
pub(crate) use clay::{Block, pressed, pressed_field, stream_field};
pub(crate) use fill::fill;
pub(crate) use fitted::fitted;
pub(crate) use plate::Plate;
pub(crate) use wall::{pushed_field, rankine_field, wall, wedge_field};

use crate::{Boundary, Condition, Line, LineUse, Linear, Material};

/// Soil of unit weight one that has friction only.
pub(crate) fn soil(phi_deg: f64) -> Material {
    Material {
        phi_deg,
        cohesion: Linear::default(),
        unit_weight: 1.0,
        pore_pressure: Linear::default(),
        tension: None,
        envelope: None,
        anisotropy: None,
    }
}

fn lines(ends: &[(usize, usize)]) -> Vec<Line> {
    ends.iter().map(|&(from, to)| Line { from, to }).collect()
}

fn forward(line: usize) -> LineUse {
    LineUse { line, forward: true }
}

fn backward(line: usize) -> LineUse {
    LineUse { line, forward: false }
}

fn on(side: LineUse, condition: Condition) -> Boundary {
    Boundary { line: side.line, forward: side.forward, condition }
}

/// Pseudo-random numbers from -1 to 1 (xorshift, Marsaglia 2003).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Soil that is the same everywhere, without water.
pub(crate) fn material(phi_deg: f64, cohesion: f64, unit_weight: f64) -> Material {
    Material { cohesion: Linear::uniform(cohesion), unit_weight, ..soil(phi_deg) }
}
