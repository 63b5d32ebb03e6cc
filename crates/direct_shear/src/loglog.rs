use serde::Serialize;
use soilctl_soil::units;
use soilctl_stats::Line;

use crate::curve::{FrictionAt, FrictionCurve, Sample, answer, need_stresses, samples};
use crate::error::{DirectShearError, check};
use crate::misfit::Misfit;
use crate::point::ShearPoint;

const NAME: &str = "power law";

/// The power law `phi = A sigma^b` with phi in degrees and sigma in psi (Hong 2001, section 6.6.2, figure 6-14).
///
/// A straight line in the logarithms, fitted to the points below a stress limit. It has no floor and no
/// ceiling, so it must not be carried far from the tested stresses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LogLogFit {
    /// A: the friction angle in degrees at 1 psi.
    pub friction_at_1_psi_deg: f64,
    /// b: the exponent; negative when friction falls with stress.
    pub exponent: f64,
    /// Standard error of ln A; `None` with only two points.
    pub ln_friction_standard_error: Option<f64>,
    /// Standard error of b; `None` with only two points.
    pub exponent_standard_error: Option<f64>,
    /// Residuals of the points that were fitted.
    pub misfit: Misfit,
    /// Points at or above this stress in Pa were left out; `None` if all were used.
    pub stress_limit_pa: Option<f64>,
    /// Lowest fitted stress in Pa.
    pub lowest_stress_pa: f64,
    /// Highest fitted stress in Pa.
    pub highest_stress_pa: f64,
    #[serde(skip)]
    line: Line,
}

impl LogLogFit {
    /// Below this stress lie the four low loads of Hong (2001), table 6.13: 2.5 psi.
    pub const DEFAULT_LIMIT_PSI: f64 = 2.5;

    /// Fits the points below [`LogLogFit::DEFAULT_LIMIT_PSI`].
    ///
    /// # Errors
    /// As [`LogLogFit::fit_below`].
    pub fn fit(points: &[ShearPoint]) -> Result<Self, DirectShearError> {
        Self::fit_below(points, units::psi_to_pa(Self::DEFAULT_LIMIT_PSI))
    }

    /// Fits the points whose stress is below `stress_limit_pa` (above 0 Pa); all others are ignored.
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] for the limit, [`DirectShearError::TooFewStresses`] with fewer than two
    /// different stresses below it, [`DirectShearError::Overflow`] if A or b is not a number.
    pub fn fit_below(points: &[ShearPoint], stress_limit_pa: f64) -> Result<Self, DirectShearError> {
        check("stress_limit_pa", stress_limit_pa, "Pa", "above 0 Pa", |limit| limit > 0.0)?;
        let mut chosen = samples(points, None)?;
        chosen.retain(|sample| sample.stress_pa < stress_limit_pa);
        let selection = format!("those below {stress_limit_pa} Pa");
        Self::fit_samples(&chosen, Some(stress_limit_pa), &selection)
    }

    /// Fits all points, each squared residual of ln phi multiplied by its weight (1 if not given).
    ///
    /// # Errors
    /// As [`LogLogFit::fit_below`], and if the weights do not fit the points.
    pub fn fit_all(points: &[ShearPoint], weights: Option<&[f64]>) -> Result<Self, DirectShearError> {
        Self::fit_samples(&samples(points, weights)?, None, "all points")
    }

    fn fit_samples(
        samples: &[Sample],
        stress_limit_pa: Option<f64>,
        selection: &str,
    ) -> Result<Self, DirectShearError> {
        need_stresses(NAME, samples, 2, selection)?;
        let logs: Vec<(f64, f64, f64)> =
            samples.iter().map(|s| (s.stress_psi.ln(), s.angle_deg.ln(), s.weight)).collect();
        let line = Line::fit(&logs);
        let (ln_error, exponent_error) = match residual_variance(&line, samples.len()) {
            Some(s2) => (
                Some((s2 * (1.0 / line.weight + line.mean_x.powi(2) / line.sxx)).sqrt()),
                Some((s2 / line.sxx).sqrt()),
            ),
            None => (None, None),
        };
        let fit = Self {
            friction_at_1_psi_deg: line.at(0.0).exp(),
            exponent: line.slope,
            ln_friction_standard_error: ln_error,
            exponent_standard_error: exponent_error,
            misfit: Misfit::of(samples, |sample| line.at(sample.stress_psi.ln()).exp()),
            stress_limit_pa,
            lowest_stress_pa: samples.first().map_or(0.0, |sample| sample.stress_pa),
            highest_stress_pa: samples.last().map_or(0.0, |sample| sample.stress_pa),
            line,
        };
        let numbers = [fit.friction_at_1_psi_deg, ln_error.unwrap_or(0.0), exponent_error.unwrap_or(0.0)];
        if numbers.iter().all(|n| n.is_finite()) && fit.exponent.is_finite() && fit.misfit.is_finite() {
            Ok(fit)
        } else {
            Err(DirectShearError::Overflow { curve: NAME })
        }
    }
}

/// Variance of a residual of unit weight; two parameters are spent on the line.
#[allow(clippy::cast_precision_loss)]
fn residual_variance(line: &Line, points: usize) -> Option<f64> {
    (points > 2).then(|| line.sse / (points - 2) as f64)
}

impl FrictionCurve for LogLogFit {
    fn name(&self) -> &'static str {
        NAME
    }

    fn stress_range_pa(&self) -> (f64, f64) {
        (self.lowest_stress_pa, self.highest_stress_pa)
    }

    fn friction_at(&self, normal_stress_pa: f64) -> Result<FrictionAt, DirectShearError> {
        let ln_psi = |stress_pa: f64| units::pa_to_psi(stress_pa).ln();
        let degrees = |stress_pa: f64| self.line.at(ln_psi(stress_pa)).exp();
        answer(self, normal_stress_pa, degrees, |stress_pa| {
            let s2 = residual_variance(&self.line, self.misfit.points)?;
            let from_mean = ln_psi(stress_pa) - self.line.mean_x;
            let spread = 1.0 + 1.0 / self.line.weight + from_mean.powi(2) / self.line.sxx;
            // d phi = phi d(ln phi) takes the error out of the logarithm.
            Some(degrees(stress_pa) * (s2 * spread).sqrt())
        })
    }
}
