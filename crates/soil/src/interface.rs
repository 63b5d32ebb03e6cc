use serde::{Deserialize, Serialize};

use crate::error::check;
use crate::{Angle, Soil, SoilError};

/// The contact between soil and plate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Interface {
    friction: Angle,
    adhesion_pa: f64,
}

impl Interface {
    /// An interface of friction angle delta (0 <= delta < 90 deg) and adhesion (>= 0 Pa).
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if a value is outside its range or not finite.
    pub fn new(friction: Angle, adhesion_pa: f64) -> Result<Self, SoilError> {
        check("delta", friction.degrees(), "deg", "at least 0 and below 90 deg", |d| {
            (0.0..90.0).contains(&d)
        })?;
        check("adhesion", adhesion_pa, "Pa", "at least 0 Pa", |a| a >= 0.0)?;
        Ok(Self { friction, adhesion_pa })
    }

    /// Interface friction angle delta.
    #[must_use]
    pub const fn friction(&self) -> Angle {
        self.friction
    }

    /// Adhesion in Pa.
    #[must_use]
    pub const fn adhesion_pa(&self) -> f64 {
        self.adhesion_pa
    }

    /// Refuses an interface that is rougher than the soil.
    ///
    /// A billionth of a degree is forgiven, so that `delta = phi` survives a unit conversion.
    ///
    /// # Errors
    /// [`SoilError::InterfaceRougherThanSoil`] if delta exceeds phi.
    pub fn check_against(&self, soil: &Soil) -> Result<(), SoilError> {
        let (delta_deg, phi_deg) = (self.friction.degrees(), soil.friction().degrees());
        if delta_deg > phi_deg + 1e-9 {
            return Err(SoilError::InterfaceRougherThanSoil { delta_deg, phi_deg });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_do_not_show_the_way_through_radians() {
        let angle = Angle::from_degrees(30.0);
        assert_ne!(angle.degrees(), 30.0);
        let soil = Soil::new(angle, 1500.0).unwrap();
        let rough = Interface::new(Angle::from_degrees(35.0), 0.0).unwrap();
        let error = rough.check_against(&soil).unwrap_err();
        assert!(error.to_string().contains("phi of 30 deg"), "{error}");
        let SoilError::InterfaceRougherThanSoil { phi_deg, .. } = error else { panic!("{error}") };
        assert_eq!(phi_deg, angle.degrees());
    }
}
