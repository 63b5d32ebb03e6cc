//! Friction that falls with the logarithm of stress: one unknown more, its slope.
//!
//! A stroke has the friction `phi_ref - slope log10(sigma / sigma_ref)`, where sigma is the equivalent normal stress on its slip
//! surfaces ([`soilctl_earth_pressure::mean_slip_stress_over_pressure`] times the pressure that was measured). Of sigma only an
//! interval is known, and the slope is cut into slices; so a stroke has an interval of friction angles at each reference angle of a slice, and
//! the band of the stroke reaches from the lower bound at the least angle to the upper bound at the greatest.

use crate::EstimatorError;

/// Most slope in degrees a decade.
pub const MAX_SLOPE_DEG: f64 = 20.0;
/// Widest slices in degrees a decade.
const WIDEST_SLICE_DEG: f64 = 1.0;
/// Narrowest ones: half a decade from the reference, friction angles are known to 0.06 deg in it.
const NARROWEST_SLICE_DEG: f64 = 0.25;
/// What a slice leaves open of the friction angle of a stroke, in degrees, where its width allows.
const OPEN_DEG: f64 = 0.12;
/// Reference stresses taken, in Pa: from a grain of dust to a rock's strength.
pub const REFERENCE_STRESS_PA: (f64, f64) = (1.0, 1e8);

/// Friction as a law of stress, `phi = phi_ref - slope log10(sigma / sigma_ref)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionLaw {
    /// The slope in degrees a decade, known to lie between these; at least 0.
    pub slope_deg_per_decade: (f64, f64),
    /// Normal stress in Pa at which the friction angle is `phi_ref`.
    pub reference_stress_pa: f64,
}

impl FrictionLaw {
    /// Decades of a stress in Pa above the reference.
    pub(crate) fn decades(&self, stress_pa: f64) -> f64 {
        libm::log10(stress_pa / self.reference_stress_pa)
    }

    /// The friction angle in degrees at a stress in Pa.
    #[must_use]
    pub fn friction_deg(&self, phi_ref_deg: f64, slope: f64, stress_pa: f64) -> f64 {
        phi_ref_deg - slope * self.decades(stress_pa)
    }

    /// Least and greatest friction angle at stresses of an interval, for the slopes of the law.
    #[must_use]
    pub fn friction_range_deg(&self, phi_ref_deg: f64, stress_pa: [f64; 2]) -> [f64; 2] {
        let (low, high) = self.slope_deg_per_decade;
        let at = |stress: f64| [low, high].map(|slope| self.friction_deg(phi_ref_deg, slope, stress));
        let (light, heavy) = (at(stress_pa[0]), at(stress_pa[1]));
        [heavy[0].min(heavy[1]), light[0].max(light[1])]
    }

    /// The law in slices whose slopes differ little, for stresses up to so many decades from the reference.
    pub(crate) fn slices(self, decades: f64) -> impl Iterator<Item = Self> {
        let (low, high) = self.slope_deg_per_decade;
        let width = (OPEN_DEG / decades).clamp(NARROWEST_SLICE_DEG, WIDEST_SLICE_DEG);
        let count = ((high - low) / width).ceil().max(1.0) as usize;
        let at = move |i: usize| low + (high - low) * i as f64 / count as f64;
        (0..count).map(move |i| Self { slope_deg_per_decade: (at(i), at(i + 1)), ..self })
    }

    pub(crate) fn check(&self) -> Result<(), EstimatorError> {
        let interval = |quantity, (low, high): (f64, f64), unit, allowed: (f64, f64)| {
            if low <= high && low >= allowed.0 && high <= allowed.1 {
                return Ok(());
            }
            let allowed = format!("an interval within {} to {} {unit}", allowed.0, allowed.1);
            Err(EstimatorError::BadInterval { quantity, low, high, unit, allowed })
        };
        let slope = self.slope_deg_per_decade;
        interval("the fall of friction with stress", slope, "deg/decade", (0.0, MAX_SLOPE_DEG))?;
        let stress = (self.reference_stress_pa, self.reference_stress_pa);
        interval("the reference stress", stress, "Pa", REFERENCE_STRESS_PA)
    }
}

/// What a test in direct shear says: at its normal stress the friction angle lies in an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearBand {
    /// Normal stress in Pa.
    pub stress_pa: f64,
    /// Least and greatest friction angle in degrees.
    pub friction_deg: [f64; 2],
}
