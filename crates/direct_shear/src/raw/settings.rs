use serde::Serialize;
use soilctl_soil::{STANDARD_GRAVITY_M_S2, units};

use crate::error::{DirectShearError, check};
use crate::loglog::LogLogFit;

/// Geometry of the shear box.
///
/// The contact area is taken as constant during a run. The sliding halves reduce it, but normal and shear stress
/// by the same factor, so the friction angle does not see it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShearBox {
    /// Area of the shear plane in m2, above 0.
    pub area_m2: f64,
    /// Gravity in m/s2, above 0: it turns the load into a force.
    pub gravity_m_s2: f64,
}

impl ShearBox {
    /// Area in m2 with which the loads of Hong (2001), appendix D, give the stresses of table 6.13: 5.57 in2 (section
    /// 6.6). The appendix prints 35.6 cm2, which makes every stress 1 % larger.
    pub const TABLE_6_13_AREA_M2: f64 = 5.57 * 0.0254 * 0.0254;

    /// Normal stress in Pa under a load in kg.
    #[must_use]
    pub fn normal_stress_pa(&self, load_kg: f64) -> f64 {
        load_kg * self.gravity_m_s2 / self.area_m2
    }
}

impl Default for ShearBox {
    /// 35.6 cm2 (Hong 2001, appendix D) under standard gravity.
    fn default() -> Self {
        Self { area_m2: 35.6e-4, gravity_m_s2: STANDARD_GRAVITY_M_S2 }
    }
}

/// How raw records are evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RawSettings {
    /// The box.
    pub shear_box: ShearBox,
    /// Reading of the load cell without load, in N (between -1e9 and 1e9); subtracted from every shear force.
    pub bias_n: f64,
    /// Below this normal stress in Pa (at least 0) the force is smoothed by a three-point moving average.
    pub low_stress_limit_pa: f64,
    /// Of more runs than this (at least 2) at a load, this many closest ones are kept.
    pub runs_kept: usize,
    /// Samples on each side of the peak (1 to 1000) from which the dilation angle is taken.
    pub dilation_half_window: usize,
}

impl Default for RawSettings {
    /// The thesis's procedure: 2.5 psi, three runs, no bias; five samples on each side for the dilation.
    fn default() -> Self {
        Self {
            shear_box: ShearBox::default(),
            bias_n: 0.0,
            low_stress_limit_pa: units::psi_to_pa(LogLogFit::DEFAULT_LIMIT_PSI),
            runs_kept: 3,
            dilation_half_window: 5,
        }
    }
}

impl RawSettings {
    /// Refuses settings outside the ranges given at the fields.
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] that names the setting.
    #[allow(clippy::cast_precision_loss)]
    pub fn check(&self) -> Result<(), DirectShearError> {
        check("area_m2", self.shear_box.area_m2, "m2", "above 0 m2", |area| area > 0.0)?;
        check("gravity_m_s2", self.shear_box.gravity_m_s2, "m/s2", "above 0 m/s2", |g| g > 0.0)?;
        check("bias_n", self.bias_n, "N", "between -1e9 and 1e9 N", |bias| bias.abs() <= 1e9)?;
        check("low_stress_limit_pa", self.low_stress_limit_pa, "Pa", "at least 0 Pa", |p| p >= 0.0)?;
        check("runs_kept", self.runs_kept as f64, "runs", "at least 2", |n| n >= 2.0)?;
        check("dilation_half_window", self.dilation_half_window as f64, "samples", "from 1 to 1000", |n| {
            (1.0..=1000.0).contains(&n)
        })?;
        Ok(())
    }
}
