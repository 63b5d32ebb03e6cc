//! Weighted least-squares line through centred sums.

/// `y = mean_y + slope (x - mean_x)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Line {
    pub(crate) mean_x: f64,
    pub(crate) mean_y: f64,
    pub(crate) slope: f64,
    /// Sum of weights.
    pub(crate) weight: f64,
    /// Weighted sum of squares of x about its mean.
    pub(crate) sxx: f64,
    /// Weighted sum of squared residuals.
    pub(crate) sse: f64,
}

impl Line {
    /// The line through `(x, y, weight)`; a horizontal one if all x are equal.
    pub(crate) fn fit(data: &[(f64, f64, f64)]) -> Self {
        let weight: f64 = data.iter().map(|d| d.2).sum();
        let mean_x = data.iter().map(|d| d.2 * d.0).sum::<f64>() / weight;
        let mean_y = data.iter().map(|d| d.2 * d.1).sum::<f64>() / weight;
        let sxx: f64 = data.iter().map(|d| d.2 * (d.0 - mean_x).powi(2)).sum();
        let sxy: f64 = data.iter().map(|d| d.2 * (d.0 - mean_x) * (d.1 - mean_y)).sum();
        let slope = if sxx > 0.0 { sxy / sxx } else { 0.0 };
        let sse = data.iter().map(|d| d.2 * (d.1 - mean_y - slope * (d.0 - mean_x)).powi(2)).sum();
        Self { mean_x, mean_y, slope, weight, sxx, sse }
    }

    pub(crate) fn at(&self, x: f64) -> f64 {
        self.mean_y + self.slope * (x - self.mean_x)
    }
}
