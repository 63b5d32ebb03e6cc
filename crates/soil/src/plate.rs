use serde::{Deserialize, Serialize};

use crate::error::check;
use crate::{Angle, SlantCoefficient, Soil, SoilError, WidthRatio};

/// At and above this sum of tool angle and interface friction (degrees) the plate's force on the soil is
/// nearly vertical and no horizontal failure load exists.
pub const MAX_ANGLE_SUM_DEG: f64 = 175.0;

/// A flat plate held in the soil at an angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Plate {
    tool_angle: Angle,
    surface_slope: Angle,
    depth_m: f64,
    width_m: f64,
}

impl Plate {
    /// A plate with tool angle alpha (0 < alpha < 180 deg), surface slope beta (-90 < beta < 90 deg),
    /// vertical depth of the lower edge (> 0 m) and width (> 0 m).
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if a value is outside its range or not finite.
    pub fn new(
        tool_angle: Angle,
        surface_slope: Angle,
        depth_m: f64,
        width_m: f64,
    ) -> Result<Self, SoilError> {
        check("alpha", tool_angle.degrees(), "deg", "above 0 and below 180 deg", |a| a > 0.0 && a < 180.0)?;
        check("beta", surface_slope.degrees(), "deg", "above -90 and below 90 deg", |b| b.abs() < 90.0)?;
        check("depth", depth_m, "m", "above 0 m", |d| d > 0.0)?;
        check("width", width_m, "m", "above 0 m", |w| w > 0.0)?;
        Ok(Self { tool_angle, surface_slope, depth_m, width_m })
    }

    /// Tool angle alpha.
    #[must_use]
    pub const fn tool_angle(&self) -> Angle {
        self.tool_angle
    }

    /// Surface slope beta, positive when the ground rises ahead of the plate.
    #[must_use]
    pub const fn surface_slope(&self) -> Angle {
        self.surface_slope
    }

    /// Vertical depth of the lower edge in m.
    #[must_use]
    pub const fn depth_m(&self) -> f64 {
        self.depth_m
    }

    /// Width in m.
    #[must_use]
    pub const fn width_m(&self) -> f64 {
        self.width_m
    }

    /// Width over vertical depth.
    #[must_use]
    pub fn width_ratio(&self) -> WidthRatio {
        // Both are above 0; a quotient that is too large for a number is infinite, which is plane strain.
        WidthRatio::new(self.width_m / self.depth_m).unwrap_or(WidthRatio::PLANE_STRAIN)
    }

    /// Slant length `L = H / sin(alpha)` in m.
    #[must_use]
    pub fn slant_length_m(&self) -> f64 {
        self.depth_m / self.tool_angle.sin()
    }

    /// `1/2 gamma L^2 w` in N: multiply a [`SlantCoefficient`] by it to get a force.
    #[must_use]
    pub fn weight_scale_n(&self, soil: &Soil) -> f64 {
        0.5 * soil.unit_weight_n_m3() * self.slant_length_m().powi(2) * self.width_m
    }

    /// Force in N of a coefficient in a soil.
    #[must_use]
    pub fn force_n(&self, soil: &Soil, coefficient: SlantCoefficient) -> f64 {
        self.weight_scale_n(soil) * coefficient.0
    }
}

/// One measured failure of the soil by a plate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Stroke {
    plate: Plate,
    force_n: f64,
}

impl Stroke {
    /// A stroke from its plate and failure force (> 0 N).
    ///
    /// # Errors
    /// [`SoilError::OutOfRange`] if the force is not positive and finite.
    pub fn new(plate: Plate, force_n: f64) -> Result<Self, SoilError> {
        check("force_n", force_n, "N", "above 0 N", |f| f > 0.0)?;
        Ok(Self { plate, force_n })
    }

    /// The plate.
    #[must_use]
    pub const fn plate(&self) -> &Plate {
        &self.plate
    }

    /// Failure force in N.
    #[must_use]
    pub const fn force_n(&self) -> f64 {
        self.force_n
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units;

    #[test]
    fn thesis_force_scale() {
        // Hong (2001), chapter 6: F[lbf] = 0.09032 * density[g/cc] * K_L for a 5 in plate and 1 in of slant length.
        let alpha = Angle::from_degrees(80.0);
        let depth = units::inches_to_m(1.0) * alpha.sin();
        let plate = Plate::new(alpha, Angle::ZERO, depth, units::inches_to_m(5.0)).unwrap();
        let soil = Soil::new(Angle::from_degrees(40.0), units::g_cc_to_kg_m3(1.0)).unwrap();
        let force_lbf = units::n_to_lbf(plate.force_n(&soil, SlantCoefficient(1.0)));
        assert!((force_lbf - 0.09032).abs() < 5e-6, "{force_lbf}");
    }
}
