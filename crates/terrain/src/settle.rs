use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use crate::error::{TerrainError, within};
use crate::field::HeightField;

/// The steepest slope that a soil keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Repose {
    slope: f64,
}

impl Repose {
    /// From the angle of repose in rad, 0 to 1.5.
    ///
    /// # Errors
    /// [`TerrainError::OutOfRange`].
    pub fn from_radians(angle_rad: f64) -> Result<Self, TerrainError> {
        within("angle of repose", angle_rad, "rad", [0.0, 1.5], "0 to 1.5 rad (86 deg)")?;
        Ok(Self { slope: libm::tan(angle_rad) })
    }

    /// The slope: height over length.
    #[must_use]
    pub const fn slope(&self) -> f64 {
        self.slope
    }
}

/// What settling did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settled {
    /// Steps that were made.
    pub steps: usize,
    /// Volume that went from one cell to another in the last step, in m3.
    pub moved_m3: f64,
    /// By how much the steepest face exceeded the slope of repose in the last step, before it; 0 if nothing moved.
    pub excess_slope: f64,
}

/// Share of the height above the allowed one that runs off through a face in a step. A quarter is the limit of stability
/// for diffusion on a square grid; the gradient along a face is a mean over four others, which needs some room.
const SHARE: f64 = 0.2;
/// The same over a corner.
const CORNER_SHARE: f64 = 0.05;

impl HeightField {
    /// One step of run-off. Through each face between two cells flows, down the gradient `g`, what exceeds the slope
    /// of repose `t`: `q = SHARE (|g| - t) g/|g|`. Where two slopes meet, the gradient at the corner between four
    /// cells can be steeper than either; what exceeds `t` there flows over the corner. Walls let nothing through.
    pub fn settle_step(&mut self, repose: &Repose) -> Settled {
        let (n, rows, cell_m) = (self.columns(), self.rows(), self.cell_m());
        // Heights over one cell, instead of slopes.
        let allowed = repose.slope * cell_m;
        let over_corner = allowed * SQRT_2;
        let mut most = 0.0_f64;
        let mut moved = 0.0;
        let (faces, corners) = self.flux_m.split_at_mut(2 * n * rows);
        let (along_x, along_y) = faces.split_at_mut(n * rows);
        let (rising, falling) = corners.split_at_mut(n * rows);
        let h = &self.heights_m;
        for j in 0..rows {
            // At a wall the surface goes on level.
            let (below, above) = (if j > 0 { n } else { 0 }, if j + 1 < rows { n } else { 0 });
            for i in 0..n {
                let k = j * n + i;
                let (left, right) = (usize::from(i > 0), usize::from(i + 1 < n));
                if right > 0 {
                    let across = h[k + 1] - h[k];
                    let beside =
                        0.25 * ((h[k + above] - h[k - below]) + (h[k + 1 + above] - h[k + 1 - below]));
                    along_x[k] = flow(across, beside, allowed, &mut most);
                    moved += along_x[k].abs();
                }
                if above > 0 {
                    let across = h[k + n] - h[k];
                    let beside = 0.25 * ((h[k + right] - h[k - left]) + (h[k + n + right] - h[k + n - left]));
                    along_y[k] = flow(across, beside, allowed, &mut most);
                    moved += along_y[k].abs();
                }
                if right > 0 && above > 0 {
                    let (rise, fall) = (h[k + n + 1] - h[k], h[k + n] - h[k + 1]);
                    [rising[k], falling[k]] = corner_flow([rise, fall], over_corner, &mut most);
                    moved += rising[k].abs() + falling[k].abs();
                }
            }
        }
        if most > 0.0 {
            for j in 0..rows {
                for i in 0..n {
                    let k = j * n + i;
                    let (left, below) = (i > 0, j > 0);
                    let in_x = along_x[k] - if left { along_x[k - 1] } else { 0.0 };
                    let in_y = along_y[k] - if below { along_y[k - n] } else { 0.0 };
                    let in_rising = rising[k] - if left && below { rising[k - n - 1] } else { 0.0 };
                    // Of the corner that cell k is at the lower right of; it lies one cell to the left.
                    let up_left = if left { falling[k - 1] } else { 0.0 };
                    let in_falling = up_left - if below { falling[k - n] } else { 0.0 };
                    self.heights_m[k] += (in_x + in_y) + (in_rising + in_falling);
                }
            }
        }
        Settled { steps: 1, moved_m3: moved * cell_m * cell_m, excess_slope: most / cell_m }
    }

    /// Steps until no face is steeper than repose by more than `tolerance` (a slope), or `most_steps` are made.
    pub fn settle(&mut self, repose: &Repose, most_steps: usize, tolerance: f64) -> Settled {
        let mut last = Settled { steps: 0, moved_m3: 0.0, excess_slope: 0.0 };
        while last.steps < most_steps {
            last = Settled { steps: last.steps + 1, ..self.settle_step(repose) };
            if last.excess_slope <= tolerance {
                break;
            }
        }
        last
    }
}

/// What comes into the lower-numbered cell of a face with a height difference `across` it and `beside` along it, all in m.
#[inline]
fn flow(across: f64, beside: f64, allowed: f64, most: &mut f64) -> f64 {
    let square = across * across + beside * beside;
    if square <= allowed * allowed {
        return 0.0;
    }
    let size = square.sqrt();
    let excess = size - allowed;
    *most = most.max(excess);
    SHARE * excess * (across / size)
}

/// The same over a corner, both ways, with the height differences over it.
#[inline]
fn corner_flow([rise, fall]: [f64; 2], allowed: f64, most: &mut f64) -> [f64; 2] {
    let square = rise * rise + fall * fall;
    if square <= allowed * allowed {
        return [0.0; 2];
    }
    let size = square.sqrt();
    let excess = size - allowed;
    *most = most.max(excess * FRAC_1_SQRT_2);
    [rise, fall].map(|across| CORNER_SHARE * excess * (across / size))
}
