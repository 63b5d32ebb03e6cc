use serde::Serialize;

use crate::curve::Sample;

/// How far a curve passes from its points, in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Misfit {
    /// Number of points.
    pub points: usize,
    /// Root mean square of the residuals, every point counted once.
    pub rms_deg: f64,
    /// The same with the weights of the fit: `sqrt(sum(w r^2) / sum(w))`.
    pub weighted_rms_deg: f64,
    /// The residual of largest size, measured minus fitted.
    pub worst_residual_deg: f64,
    /// Normal stress of the worst residual in Pa.
    pub worst_stress_pa: f64,
}

impl Misfit {
    pub(crate) fn of(samples: &[Sample], fitted_deg: impl Fn(&Sample) -> f64) -> Self {
        let mut total = Totals::default();
        let mut worst = (0.0, samples.first().map_or(0.0, |sample| sample.stress_pa));
        for sample in samples {
            let residual = sample.angle_deg - fitted_deg(sample);
            total.points += 1.0;
            total.squares += residual * residual;
            total.weights += sample.weight;
            total.weighted_squares += sample.weight * residual * residual;
            if residual.abs() > f64::abs(worst.0) {
                worst = (residual, sample.stress_pa);
            }
        }
        Self {
            points: samples.len(),
            rms_deg: (total.squares / total.points.max(1.0)).sqrt(),
            weighted_rms_deg: if total.weights > 0.0 {
                (total.weighted_squares / total.weights).sqrt()
            } else {
                0.0
            },
            worst_residual_deg: worst.0,
            worst_stress_pa: worst.1,
        }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.rms_deg.is_finite() && self.weighted_rms_deg.is_finite() && self.worst_residual_deg.is_finite()
    }
}

#[derive(Default)]
struct Totals {
    points: f64,
    squares: f64,
    weights: f64,
    weighted_squares: f64,
}
