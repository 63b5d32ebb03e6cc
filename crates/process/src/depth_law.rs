use soilctl_stats::{least_squares, t_quantile};

use crate::error::{ProcessError, positive};

/// A failure force at a depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthPoint {
    /// Vertical depth of the plate's lower edge in m.
    pub depth_m: f64,
    /// Failure force in N.
    pub force_n: f64,
}

/// Force as a power of depth, `F = C H^n`; theory says `n = 2` for soil without cohesion (section 5.6).
#[derive(Debug, Clone, PartialEq)]
pub struct DepthLaw {
    /// The power.
    pub exponent: f64,
    /// Its standard error.
    pub exponent_se: f64,
    /// Ends of its 95 % confidence interval.
    pub exponent_95: [f64; 2],
    /// Force at 1 m by the fit, in N: `C`.
    pub coefficient_n: f64,
    /// `F/H^2` of the fit through zero, `F = a H^2`, in N/m^2.
    pub quadratic_n_per_m2: f64,
    /// `F/H^2` of each point in N/m^2, in the order given: what is plotted against depth.
    pub normalised_n_per_m2: Vec<f64>,
    /// Relative scatter of a force about the power law, as a standard deviation.
    pub scatter_rel: f64,
    /// Whether the interval holds 2.
    pub agrees_with_square: bool,
}

/// Fits forces at three or more points and two or more depths, by least squares in the logarithms.
///
/// An uncertainty of the depths, `depth_sd_m` (0 if they are exact), adds `(n sd / H)^2` to the variance of a
/// logarithm, so that shallow points count less.
///
/// # Errors
/// [`ProcessError::TooFew`], [`ProcessError::OutOfRange`] of a depth or force that is not above 0, or of a negative
/// standard deviation.
pub fn depth_law(points: &[DepthPoint], depth_sd_m: f64) -> Result<DepthLaw, ProcessError> {
    for point in points {
        positive("depth", point.depth_m, "m")?;
        positive("failure force", point.force_n, "N")?;
    }
    if !(depth_sd_m.is_finite() && depth_sd_m >= 0.0) {
        return Err(ProcessError::OutOfRange {
            what: "standard deviation of the depth",
            value: depth_sd_m,
            unit: "m",
            allowed: "0 or a finite number above",
        });
    }
    if points.len() < 3 {
        return Err(ProcessError::TooFew { what: "points for the depth law", found: points.len(), least: 3 });
    }
    let mean_ln = points.iter().map(|p| p.depth_m.ln()).sum::<f64>() / points.len() as f64;
    let freedom = points.len() as f64 - 2.0;
    let no_depths = ProcessError::TooFew { what: "different depth for the depth law", found: 1, least: 2 };
    // The depth's share of the variance depends on the power, the scatter on both: a few rounds settle them.
    let (mut exponent, mut scatter) = (2.0, 0.0);
    let mut fitted = None;
    for _ in 0..20 {
        let variance = |point: &DepthPoint| {
            (scatter * scatter + (exponent * depth_sd_m / point.depth_m).powi(2)).max(1e-12)
        };
        let rows =
            points.iter().map(|p| ([1.0, p.depth_m.ln() - mean_ln], p.force_n.ln(), 1.0 / variance(p)));
        let solved = least_squares(rows).ok_or_else(|| no_depths.clone())?;
        let square = points
            .iter()
            .map(|p| (p.force_n.ln() - solved.x[0] - solved.x[1] * (p.depth_m.ln() - mean_ln)).powi(2))
            .sum::<f64>()
            / freedom;
        let by_depth = points.iter().map(|p| (exponent * depth_sd_m / p.depth_m).powi(2)).sum::<f64>()
            / points.len() as f64;
        exponent = solved.x[1];
        scatter = (square - by_depth).max(0.0).sqrt();
        fitted = Some(solved);
    }
    let solved = fitted.ok_or(no_depths)?;
    // The weights are inverse variances, so the standard error follows from them.
    let exponent_se = solved.inverse[1][1].sqrt();
    let half = t_quantile(0.025, freedom).unwrap_or(f64::MAX.sqrt()) * exponent_se;
    let fourth: f64 = points.iter().map(|p| p.depth_m.powi(4)).sum();
    let quadratic = points.iter().map(|p| p.force_n * p.depth_m * p.depth_m).sum::<f64>() / fourth;
    Ok(DepthLaw {
        exponent,
        exponent_se,
        exponent_95: [exponent - half, exponent + half],
        coefficient_n: (solved.x[0] - exponent * mean_ln).exp(),
        quadratic_n_per_m2: quadratic,
        normalised_n_per_m2: points.iter().map(|p| p.force_n / (p.depth_m * p.depth_m)).collect(),
        scatter_rel: scatter,
        agrees_with_square: (exponent - 2.0).abs() <= half.max(1e-9),
    })
}
