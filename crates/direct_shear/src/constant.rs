use serde::Serialize;
use soilctl_soil::Angle;

use crate::curve::{FrictionAt, FrictionCurve, answer, need_stresses, samples};
use crate::degrees;
use crate::error::DirectShearError;
use crate::misfit::Misfit;
use crate::point::ShearPoint;

const NAME: &str = "constant angle";

/// One friction angle for every stress: the Mohr-Coulomb law, for comparison.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ConstantFit {
    /// The weighted mean angle.
    #[serde(rename = "friction_angle_deg", serialize_with = "degrees::one")]
    pub friction: Angle,
    /// Residuals of the points.
    pub misfit: Misfit,
    /// Lowest fitted stress in Pa.
    pub lowest_stress_pa: f64,
    /// Highest fitted stress in Pa.
    pub highest_stress_pa: f64,
    #[serde(skip)]
    weight_sum: f64,
}

impl ConstantFit {
    /// Weighted mean of the points; weights multiply the squared residuals and are 1 if not given.
    ///
    /// # Errors
    /// [`DirectShearError::TooFewStresses`] with fewer than two different stresses, and errors of the weights.
    pub fn fit(points: &[ShearPoint], weights: Option<&[f64]>) -> Result<Self, DirectShearError> {
        let samples = samples(points, weights)?;
        need_stresses(NAME, &samples, 2, "all points")?;
        let weight_sum: f64 = samples.iter().map(|sample| sample.weight).sum();
        let mean = samples.iter().map(|sample| sample.weight * sample.angle_deg).sum::<f64>() / weight_sum;
        Ok(Self {
            friction: Angle::from_degrees(mean),
            misfit: Misfit::of(&samples, |_| mean),
            lowest_stress_pa: samples.first().map_or(0.0, |sample| sample.stress_pa),
            highest_stress_pa: samples.last().map_or(0.0, |sample| sample.stress_pa),
            weight_sum,
        })
    }
}

impl FrictionCurve for ConstantFit {
    fn name(&self) -> &'static str {
        NAME
    }

    fn stress_range_pa(&self) -> (f64, f64) {
        (self.lowest_stress_pa, self.highest_stress_pa)
    }

    #[allow(clippy::cast_precision_loss)]
    fn friction_at(&self, normal_stress_pa: f64) -> Result<FrictionAt, DirectShearError> {
        let spare = self.misfit.points as f64 - 1.0;
        let s2 = self.misfit.weighted_rms_deg.powi(2) * self.weight_sum / spare;
        let error = (s2 * (1.0 + 1.0 / self.weight_sum)).sqrt();
        answer(self, normal_stress_pa, |_| self.friction.degrees(), |_| Some(error))
    }
}
