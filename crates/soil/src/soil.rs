use serde::{Deserialize, Serialize};

use crate::error::check;
use crate::{Angle, SoilError};

/// Standard gravity in m/s2, the default everywhere.
pub const STANDARD_GRAVITY_M_S2: f64 = 9.806_65;

/// A homogeneous Mohr-Coulomb soil under gravity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Soil {
    friction: Angle,
    cohesion_pa: f64,
    density_kg_m3: f64,
    gravity_m_s2: f64,
}

impl Soil {
    /// A cohesionless soil under standard gravity.
    ///
    /// Friction angle 0 <= phi < 90 deg, bulk density above 0 kg/m3.
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if a value is outside its range or not finite.
    pub fn new(friction: Angle, density_kg_m3: f64) -> Result<Self, SoilError> {
        check("phi", friction.degrees(), "deg", "at least 0 and below 90 deg", |p| (0.0..90.0).contains(&p))?;
        check("density", density_kg_m3, "kg/m3", "above 0 kg/m3", |d| d > 0.0)?;
        Ok(Self { friction, cohesion_pa: 0.0, density_kg_m3, gravity_m_s2: STANDARD_GRAVITY_M_S2 })
    }

    /// The same soil with a cohesion (>= 0 Pa).
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if it is negative or not finite.
    pub fn with_cohesion(mut self, cohesion_pa: f64) -> Result<Self, SoilError> {
        self.cohesion_pa = check("cohesion", cohesion_pa, "Pa", "at least 0 Pa", |c| c >= 0.0)?;
        Ok(self)
    }

    /// The same soil under another gravity (> 0 m/s2), for example 3.71 on Mars.
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if it is not positive and finite.
    pub fn with_gravity(mut self, gravity_m_s2: f64) -> Result<Self, SoilError> {
        self.gravity_m_s2 = check("gravity", gravity_m_s2, "m/s2", "above 0 m/s2", |g| g > 0.0)?;
        Ok(self)
    }

    /// Internal friction angle phi.
    #[must_use]
    pub const fn friction(&self) -> Angle {
        self.friction
    }

    /// Cohesion in Pa.
    #[must_use]
    pub const fn cohesion_pa(&self) -> f64 {
        self.cohesion_pa
    }

    /// Bulk density in kg/m3.
    #[must_use]
    pub const fn density_kg_m3(&self) -> f64 {
        self.density_kg_m3
    }

    /// Gravity in m/s2.
    #[must_use]
    pub const fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }

    /// Unit weight gamma in N/m3.
    #[must_use]
    pub fn unit_weight_n_m3(&self) -> f64 {
        self.density_kg_m3 * self.gravity_m_s2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_weight_follows_gravity() {
        let soil = Soil::new(Angle::from_degrees(35.0), 1500.0).unwrap().with_gravity(3.71).unwrap();
        assert!((soil.unit_weight_n_m3() - 5565.0).abs() < 1e-9);
    }

    #[test]
    fn nonsense_is_refused_with_value_and_range() {
        let error = Soil::new(Angle::from_degrees(95.0), 1500.0).unwrap_err().to_string();
        assert!(error.contains("95") && error.contains("below 90 deg"), "{error}");
        assert!(Soil::new(Angle::from_degrees(35.0), f64::NAN).is_err());
        assert!(Soil::new(Angle::from_degrees(35.0), 1500.0).unwrap().with_cohesion(-1.0).is_err());
    }
}
