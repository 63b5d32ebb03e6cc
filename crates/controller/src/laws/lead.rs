use serde::{Deserialize, Serialize};

use crate::TICK_S;

/// Smallest and largest inclination of the lead below the horizontal in rad.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct LeadBounds {
    /// `theta_plate - delta + margin`: less would lift the plate.
    pub lower_rad: f64,
    /// More would drive the plate into the soil.
    pub upper_rad: f64,
}

impl LeadBounds {
    /// The bounds of section 5.3.2.2 for a plate at `plate_rad` from the vertical (alpha - 90 deg).
    #[must_use]
    pub fn new(plate_rad: f64, delta_rad: f64, margin_rad: f64, upper_rad: f64) -> Self {
        Self { lower_rad: (plate_rad - delta_rad + margin_rad).min(upper_rad), upper_rad }
    }
}

/// The proportional-integral law of eqs 5.11 and 5.26 for the inclination of the lead, bounded, without wind-up.
///
/// The error is the inclination wanted minus measured (rad; force feedback), or the plate's height now minus at the start
/// (m; position feedback). Inclinations are positive downwards, so a risen plate must be pushed down more; eq. 5.11 is
/// printed with the other sign.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct LeadAngle {
    /// Integral of the error in rad s or m s.
    pub integral: f64,
}

impl LeadAngle {
    /// One tick; gains in rad and rad/s per unit of the error, of which the integral gets the share `pace` (0 to 1). The
    /// answer lies within `bounds`.
    pub fn update(
        &mut self,
        wanted_rad: f64,
        error: f64,
        [p, i]: [f64; 2],
        pace: f64,
        bounds: LeadBounds,
    ) -> f64 {
        let integral = self.integral + pace * error * TICK_S;
        let free = wanted_rad + p * error + i * integral;
        let winds_up = (free > bounds.upper_rad && error > 0.0) || (free < bounds.lower_rad && error < 0.0);
        if !winds_up {
            self.integral = integral;
        }
        (wanted_rad + p * error + i * self.integral).max(bounds.lower_rad).min(bounds.upper_rad)
    }
}
