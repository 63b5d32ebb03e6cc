use serde::Serialize;
use soilctl_soil::{Angle, SoilError, Stroke};

use crate::error::{DirectShearError, check};

/// Where beside the plate the stresses are taken.
///
/// Hong (2001), table 6.14, uses 1/2 in and 2/3 in below the surface for 1 in of plate, whatever its angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum PointDepth {
    /// Vertical depth below the surface in m, above 0 and at most the depth of the plate.
    Metres(f64),
    /// Fraction of the plate's vertical depth, above 0 and at most 1.
    FractionOfPlate(f64),
}

/// A plate's stroke as the Mohr circle sees it: cohesionless soil, level surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct StrokeLoad {
    overburden_pa: f64,
    plate_pressure_pa: f64,
    #[serde(rename = "interface_friction_deg", serialize_with = "crate::degrees::one")]
    interface_friction: Angle,
    point_depth_m: f64,
    surface_slope_deg: f64,
}

/// The normal stresses on the failure surface between which a stroke acts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct EquivalentStress {
    /// `sigma_L` in Pa: far from the plate, without interface friction.
    pub low_pa: f64,
    /// `sigma_U` in Pa: beside the plate, from its pressure.
    pub high_pa: f64,
}

impl StrokeLoad {
    /// A load from a stroke (its force F is the resultant at delta to the plate's normal), unit weight gamma
    /// (above 0 N/m3), interface friction delta (at least 0, below 90 deg) and the point considered.
    ///
    /// The pressure on the plate is taken to grow linearly with depth: at depth z it is
    /// `p = 2 F z / (w L H)` with width w, slant length L and vertical depth H (Hong 2001, section 6.6.1).
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] for unit weight, delta or a point that is not beside the plate.
    pub fn new(
        stroke: &Stroke,
        unit_weight_n_m3: f64,
        interface_friction: Angle,
        point: PointDepth,
    ) -> Result<Self, DirectShearError> {
        check("unit_weight_n_m3", unit_weight_n_m3, "N/m3", "above 0 and below 1e9 N/m3", |g| {
            g > 0.0 && g < 1e9
        })?;
        check("delta", interface_friction.degrees(), "deg", "at least 0 and below 90 deg", |d| {
            (0.0..90.0).contains(&d)
        })?;
        let plate = stroke.plate();
        let fraction = match point {
            PointDepth::FractionOfPlate(fraction) => fraction,
            PointDepth::Metres(depth) => {
                check("point_depth_m", depth, "m", "above 0 m and at most the depth of the plate", |z| {
                    z > 0.0 && z <= plate.depth_m()
                })?;
                depth / plate.depth_m()
            }
        };
        check("depth fraction", fraction, "", "above 0 and at most 1", |f| f > 0.0 && f <= 1.0)?;
        let point_depth_m = fraction * plate.depth_m();
        let pressure = 2.0 * stroke.force_n() * fraction / (plate.width_m() * plate.slant_length_m());
        Ok(Self {
            overburden_pa: check("overburden", unit_weight_n_m3 * point_depth_m, "Pa", "finite", |_| true)?,
            plate_pressure_pa: check("plate pressure", pressure, "Pa", "finite", |_| true)?,
            interface_friction,
            point_depth_m,
            surface_slope_deg: plate.surface_slope().degrees(),
        })
    }

    /// Depth z of the point considered in m.
    #[must_use]
    pub const fn point_depth_m(&self) -> f64 {
        self.point_depth_m
    }

    /// Pressure of the plate p at the point, along the resultant, in Pa.
    #[must_use]
    pub const fn plate_pressure_pa(&self) -> f64 {
        self.plate_pressure_pa
    }

    /// Slope of the surface in degrees, which the stresses here leave out of account.
    pub(crate) const fn surface_slope_deg(&self) -> f64 {
        self.surface_slope_deg
    }

    /// Both equivalent stresses for a given friction angle phi.
    ///
    /// # Errors
    /// As [`StrokeLoad::low_stress_pa`] and [`StrokeLoad::high_stress_pa`].
    pub fn equivalent_stress(&self, friction: Angle) -> Result<EquivalentStress, DirectShearError> {
        Ok(EquivalentStress {
            low_pa: self.low_stress_pa(friction)?,
            high_pa: self.high_stress_pa(friction)?,
        })
    }

    /// `sigma_L = gamma z (1 + sin phi) cos phi` in Pa, as in the printed table 6.14 of Hong (2001).
    ///
    /// The normal stress at the point where the circle touches the failure line is larger by `1 / cos phi`; see
    /// [`StrokeLoad::low_tangent_stress_pa`].
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] unless phi is above 0 and below 90 degrees.
    pub fn low_stress_pa(&self, friction: Angle) -> Result<f64, DirectShearError> {
        Ok(self.low_tangent_stress_pa(friction)? * friction.cos())
    }

    /// `gamma z (1 + sin phi)` in Pa: the normal stress on the failure plane of the Rankine passive zone.
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] unless phi is above 0 and below 90 degrees.
    pub fn low_tangent_stress_pa(&self, friction: Angle) -> Result<f64, DirectShearError> {
        check_friction(friction)?;
        Ok(self.overburden_pa * (1.0 + friction.sin()))
    }

    /// `sigma_U` in Pa: the normal stress on the failure plane of the smaller Mohr circle that passes through the
    /// stresses on the plate and touches the failure line.
    ///
    /// With `s_h = (1 - sin phi) gamma z + p cos delta` and `t = p sin delta` it is
    /// `s_h - sqrt(s_h^2 - cos^2 phi (s_h^2 + t^2))`. The first term is the earth pressure at rest.
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] unless phi is above 0 and below 90 degrees, and
    /// [`SoilError::InterfaceRougherThanSoil`] if delta exceeds phi: then no circle touches the failure line.
    pub fn high_stress_pa(&self, friction: Angle) -> Result<f64, DirectShearError> {
        check_friction(friction)?;
        let (delta_deg, phi_deg) = (self.interface_friction.degrees(), friction.degrees());
        if delta_deg > phi_deg + 1e-9 {
            return Err(SoilError::InterfaceRougherThanSoil { delta_deg, phi_deg }.into());
        }
        let at_rest = (1.0 - friction.sin()) * self.overburden_pa;
        let normal = at_rest + self.plate_pressure_pa * self.interface_friction.cos();
        let shear = self.plate_pressure_pa * self.interface_friction.sin();
        // sqrt(s^2 sin^2 - t^2 cos^2) as a product, which keeps its sign and its digits near delta = phi.
        let (sine, cosine) = (friction.sin(), friction.cos());
        let root = ((normal * sine - shear * cosine) * (normal * sine + shear * cosine)).max(0.0).sqrt();
        check("sigma_U", normal - root, "Pa", "finite and above 0 Pa", |stress| stress > 0.0)
    }
}

fn check_friction(friction: Angle) -> Result<(), DirectShearError> {
    check("phi", friction.degrees(), "deg", "above 0 and below 90 deg", |phi| phi > 0.0 && phi < 90.0)?;
    Ok(())
}
