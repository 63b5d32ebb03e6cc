//! Weighted least-squares line through centred sums.

/// `y = mean_y + slope (x - mean_x)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Weighted mean of x.
    pub mean_x: f64,
    /// Weighted mean of y.
    pub mean_y: f64,
    /// Change of y with x; 0 if all x are equal.
    pub slope: f64,
    /// Sum of weights.
    pub weight: f64,
    /// Weighted sum of squares of x about its mean.
    pub sxx: f64,
    /// Weighted sum of squared residuals.
    pub sse: f64,
}

impl Line {
    /// The line through `(x, y, weight)`; a horizontal one if all x are equal.
    #[must_use]
    pub fn fit(data: &[(f64, f64, f64)]) -> Self {
        let weight: f64 = data.iter().map(|d| d.2).sum();
        let mean_x = data.iter().map(|d| d.2 * d.0).sum::<f64>() / weight;
        let mean_y = data.iter().map(|d| d.2 * d.1).sum::<f64>() / weight;
        let sxx: f64 = data.iter().map(|d| d.2 * (d.0 - mean_x).powi(2)).sum();
        let sxy: f64 = data.iter().map(|d| d.2 * (d.0 - mean_x) * (d.1 - mean_y)).sum();
        let slope = if sxx > 0.0 { sxy / sxx } else { 0.0 };
        let sse = data.iter().map(|d| d.2 * (d.1 - mean_y - slope * (d.0 - mean_x)).powi(2)).sum();
        Self { mean_x, mean_y, slope, weight, sxx, sse }
    }

    /// y of the line at an x.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        self.mean_y + self.slope * (x - self.mean_x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A weight of two counts a point twice.
    #[test]
    fn weights_repeat_points() {
        let once = Line::fit(&[(0.0, 1.0, 1.0), (1.0, 2.5, 2.0), (3.0, 4.0, 1.0)]);
        let twice = Line::fit(&[(0.0, 1.0, 1.0), (1.0, 2.5, 1.0), (1.0, 2.5, 1.0), (3.0, 4.0, 1.0)]);
        assert!((once.slope - twice.slope).abs() < 1e-14 && (once.sse - twice.sse).abs() < 1e-14);
        assert!((once.at(2.0) - twice.at(2.0)).abs() < 1e-14);
        assert_eq!(Line::fit(&[(1.0, 2.0, 1.0), (1.0, 4.0, 1.0)]).slope, 0.0);
    }
}
