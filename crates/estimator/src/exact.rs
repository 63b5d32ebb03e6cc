//! Exact data: contour lines instead of bands (Hong 2001, section 7.3.1).
//!
//! At the true interface friction all contours meet in one point, the soil. At another they miss each other, and
//! the smallest ellipse around their pairwise intersections grows. So the delta with the smallest ellipse is the
//! estimate.

use crate::constraint::{Constraint, each};
use crate::convex::Point;
use crate::ellipse::{Ellipse, smallest_ellipse};
use crate::end_factor::EndFactors;
use crate::{EstimatorError, Setup};

/// Contours and their intersections at one delta.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactSection {
    /// Interface friction in degrees.
    pub delta_deg: f64,
    /// One polyline of (phi in degrees, density in kg/m3) a measurement.
    pub contours: Vec<Vec<[f64; 2]>>,
    /// Points (phi, density) where two contours cross, with the two measurements.
    pub intersections: Vec<([f64; 2], [usize; 2])>,
    /// Smallest ellipse around the intersections; `None` if fewer than one pair crosses.
    pub ellipse: Option<Ellipse>,
}

/// Contours on a grid of this many intervals of phi; crossings are then refined.
const STEPS: usize = 240;

/// Contours, intersections and ellipse at one delta in degrees.
///
/// # Errors
/// As [`crate::estimate`]; [`EstimatorError::TooLittle`] with fewer than two measurements.
pub fn exact_section(setup: &Setup<'_>, delta_deg: f64) -> Result<ExactSection, EstimatorError> {
    setup.check()?;
    setup.check_one_friction("the estimate from exact forces")?;
    setup.check_known_loads("the estimate from exact forces")?;
    let n = setup.observations.len();
    if n < 2 {
        return Err(EstimatorError::TooLittle {
            task: "an estimate from exact data",
            needed: "at least two measurements at different tool angles",
            found: format!("is {n}"),
        });
    }
    let constraints = each(setup)?;
    let (low, high) = setup.phi_range_deg();
    let low = low.max(delta_deg);
    let phi = |i: usize| low + (high - low) * i as f64 / STEPS as f64;
    let line = |i: usize, phi: f64| density(&constraints[i], setup.observations[i].force_n(), phi, delta_deg);
    let limits = setup.density_range_kg_m3();
    let contours: Vec<Vec<Option<f64>>> =
        (0..n).map(|i| (0..=STEPS).map(|k| line(i, phi(k))).collect()).collect();
    let mut intersections = Vec::new();
    for i in 0..n {
        for j in i + 1..n {
            let gap = |p: f64| Some(line(i, p)?.ln() - line(j, p)?.ln());
            for k in 0..STEPS {
                let at = |k: usize| Some(contours[i][k]?.ln() - contours[j][k]?.ln());
                if let (Some(a), Some(b)) = (at(k), at(k + 1))
                    && (a == 0.0 || a * b < 0.0)
                    && let Some(crossing) = bisect(phi(k), phi(k + 1), a, &gap)
                    && let Some(rho) = line(i, crossing)
                    && rho >= limits.0
                    && rho <= limits.1
                {
                    intersections.push(([crossing, rho], [i, j]));
                }
            }
        }
    }
    let points: Vec<Point> = intersections.iter().map(|(p, _)| *p).collect();
    let contours = contours
        .iter()
        .map(|line| {
            let inside = |rho: &f64| *rho >= limits.0 && *rho <= limits.1;
            (0..=STEPS).filter_map(|k| line[k].filter(inside).map(|rho| [phi(k), rho])).collect()
        })
        .collect();
    Ok(ExactSection { delta_deg, contours, intersections, ellipse: smallest_ellipse(&points) })
}

/// The section with the smallest ellipse among those in which every pair of tool angles crosses, if any does,
/// searched over the setup's interval of delta.
///
/// # Errors
/// As [`exact_section`].
pub fn exact_estimate(setup: &Setup<'_>) -> Result<Option<ExactSection>, EstimatorError> {
    const COARSE: usize = 40;
    let (low, high) = setup.delta_deg;
    let size = |section: &ExactSection| {
        // More crossings first, then a smaller ellipse.
        section.ellipse.as_ref().map(|e| (usize::MAX - section.intersections.len(), e.area()))
    };
    let mut best: Option<ExactSection> = None;
    let consider = |delta: f64, best: &mut Option<ExactSection>| -> Result<(), EstimatorError> {
        let section = exact_section(setup, delta)?;
        let better = match (size(&section), best.as_ref().and_then(size)) {
            (Some(a), Some(b)) => a.0 < b.0 || (a.0 == b.0 && a.1 < b.1),
            (Some(_), None) => true,
            _ => false,
        };
        if better {
            *best = Some(section);
        }
        Ok(())
    };
    for i in 0..=COARSE {
        consider(low + (high - low) * i as f64 / COARSE as f64, &mut best)?;
    }
    let mut step = (high - low) / COARSE as f64;
    while step > 1e-4 {
        let Some(centre) = best.as_ref().map(|b| b.delta_deg) else { break };
        for delta in [centre - 0.5 * step, centre + 0.5 * step] {
            if delta >= low && delta <= high {
                consider(delta, &mut best)?;
            }
        }
        step *= 0.5;
    }
    Ok(best)
}

fn density(constraint: &Constraint<'_>, force_n: f64, phi_deg: f64, delta_deg: f64) -> Option<f64> {
    let net = constraint.net(phi_deg, delta_deg).ok().flatten()?;
    let (per_density, rest) = constraint.force_parts(&net, EndFactors::ANY);
    let density = (force_n - rest) / per_density;
    (density > 0.0 && density.is_finite()).then_some(density)
}

fn bisect(mut low: f64, mut high: f64, at_low: f64, f: &dyn Fn(f64) -> Option<f64>) -> Option<f64> {
    for _ in 0..50 {
        let middle = f64::midpoint(low, high);
        if (f(middle)? > 0.0) == (at_low > 0.0) { low = middle } else { high = middle }
    }
    Some(f64::midpoint(low, high))
}
