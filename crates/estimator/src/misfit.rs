//! The weighted sum of squared errors and the best soil inside the consistent region.

use crate::constraint::{Constraint, Net, each};
use crate::end_factor::EndFactors;
use crate::estimate::Estimate;
use crate::{EstimatorError, FrictionLaw, Setup};

/// A soil with its misfit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Friction angle in degrees.
    pub phi_deg: f64,
    /// Bulk density in kg/m3.
    pub density_kg_m3: f64,
    /// Interface friction in degrees.
    pub delta_deg: f64,
    /// Fall of the friction angle in degrees a decade of stress; `None` without a law of stress.
    pub slope_deg_per_decade: Option<f64>,
    /// `sum ((F_n - F_pred) / F_n)^2`, eq. 7.1 of Hong (2001).
    pub misfit: f64,
}

/// Misfit of soils against the measurements; a bracket predicts its geometric mean, also that of one end factor.
pub(crate) struct Misfit<'m> {
    constraints: Vec<Constraint<'m>>,
    forces_n: Vec<f64>,
}

impl<'m> Misfit<'m> {
    pub(crate) fn new(setup: &Setup<'m>) -> Result<Self, EstimatorError> {
        let forces_n = setup.observations.iter().map(|o| o.force_n()).collect();
        Ok(Self { constraints: each(setup)?, forces_n })
    }

    pub(crate) fn len(&self) -> usize {
        self.forces_n.len()
    }

    /// Relative residuals; `None` where the model has no answer.
    pub(crate) fn residuals(&self, phi_deg: f64, density_kg_m3: f64, delta_deg: f64) -> Option<Vec<f64>> {
        let nets = self.nets(phi_deg, delta_deg)?;
        Some(self.residuals_of(&nets, density_kg_m3, EndFactors::ANY).collect())
    }

    pub(crate) fn value(&self, phi_deg: f64, density_kg_m3: f64, delta_deg: f64) -> Option<f64> {
        Some(self.residuals(phi_deg, density_kg_m3, delta_deg)?.iter().map(|r| r * r).sum())
    }

    /// What the model says of each measurement.
    fn nets(&self, phi_deg: f64, delta_deg: f64) -> Option<Vec<Net>> {
        self.constraints.iter().map(|constraint| constraint.net(phi_deg, delta_deg).ok().flatten()).collect()
    }

    fn residuals_of(&self, nets: &[Net], density_kg_m3: f64, ends: EndFactors) -> impl Iterator<Item = f64> {
        self.constraints.iter().zip(nets).zip(&self.forces_n).map(move |((constraint, net), force)| {
            let (per_density, rest) = constraint.force_parts(net, ends);
            1.0 - (density_kg_m3 * per_density + rest) / force
        })
    }

    /// Best density at (phi, delta) within the consistent interval there; `None` if no density is consistent.
    fn best_density(&self, setup: &Setup<'_>, phi_deg: f64, delta_deg: f64) -> Option<Fit> {
        let nets = self.nets(phi_deg, delta_deg)?;
        let of = |ends: EndFactors, predicted: EndFactors| {
            let (density_kg_m3, misfit) = self.parabola(setup, &nets, ends, predicted)?;
            let slope_deg_per_decade = setup.friction_law.map(|law| law.slope_deg_per_decade.0);
            Some(Fit { phi_deg, density_kg_m3, delta_deg, slope_deg_per_decade, misfit })
        };
        if setup.shares_ends() {
            let shared = EndFactors::all().filter_map(|ends| of(ends, EndFactors::at(ends.middle())));
            shared.min_by(|a, b| a.misfit.total_cmp(&b.misfit))
        } else {
            of(EndFactors::ANY, EndFactors::ANY)
        }
    }

    /// The density of least misfit, which is a parabola's minimum, among those that bands of end factors leave, and its misfit
    /// by the forces predicted at others of these.
    fn parabola(
        &self,
        setup: &Setup<'_>,
        nets: &[Net],
        ends: EndFactors,
        predicted: EndFactors,
    ) -> Option<(f64, f64)> {
        let of_strokes = ends.of_strokes(setup.end_tolerance);
        let (mut low, mut high) = setup.density_range_kg_m3();
        let (mut slope, mut curvature) = (0.0, 0.0);
        for ((constraint, net), force) in self.constraints.iter().zip(nets).zip(&self.forces_n) {
            let band = constraint.band(net, of_strokes);
            (low, high) = (low.max(band[0]), high.min(band[1]));
            let (per_density, rest) = constraint.force_parts(net, predicted);
            slope += (per_density / force) * (1.0 - rest / force);
            curvature += (per_density / force).powi(2);
        }
        if low > high || curvature == 0.0 {
            return None;
        }
        let density_kg_m3 = (slope / curvature).clamp(low, high);
        let misfit = self.residuals_of(nets, density_kg_m3, predicted).map(|r| r * r).sum();
        Some((density_kg_m3, misfit))
    }
}

/// Soil of least misfit inside the consistent region, to about 0.001 deg; `None` if nothing is consistent.
///
/// # Errors
/// As [`crate::estimate`].
pub fn best_fit(setup: &Setup<'_>, estimate: &Estimate) -> Result<Option<Fit>, EstimatorError> {
    setup.check_known_loads("the soil of least misfit")?;
    let Some(law) = setup.friction_law else {
        return estimate.phi_deg.map_or(Ok(None), |phi| best_fit_within(setup, phi));
    };
    // A soil has one slope: a few of the consistent ones are tried.
    const SLOPES: usize = 5;
    let count = estimate.slices.len();
    let mut best: Option<Fit> = None;
    for i in 0..count.min(SLOPES) {
        let slice = &estimate.slices[(2 * i + 1) * count / (2 * count.min(SLOPES))];
        let [low, high] = slice.slope_deg_per_decade;
        let slope = f64::midpoint(low, high);
        let law = FrictionLaw { slope_deg_per_decade: (slope, slope), ..law };
        let setup = Setup { friction_law: Some(law), ..setup.clone() };
        let found = best_fit_within(&setup, slice.phi_deg)?;
        best = [best, found].into_iter().flatten().min_by(|a, b| a.misfit.total_cmp(&b.misfit));
    }
    Ok(best)
}

/// The same for friction angles of an interval, and a law of one slope.
fn best_fit_within(setup: &Setup<'_>, phi: [f64; 2]) -> Result<Option<Fit>, EstimatorError> {
    const GRID: usize = 40;
    let misfit = Misfit::new(setup)?;
    let delta = setup.delta_deg;
    let better = |a: Option<Fit>, b: Option<Fit>| match (a, b) {
        (Some(a), Some(b)) if b.misfit < a.misfit => Some(b),
        (None, b) => b,
        (a, _) => a,
    };
    let inside = |p: f64, d: f64| {
        (p >= phi[0] && p <= phi[1] && d >= delta.0 && d <= delta.1 && d <= p)
            .then(|| misfit.best_density(setup, p, d))
            .flatten()
    };
    let steps = if delta.0 == delta.1 { 0 } else { GRID };
    let at = |low: f64, high: f64, i: usize, n: usize| low + (high - low) * i as f64 / n.max(1) as f64;
    let mut best = None;
    for i in 0..=GRID {
        for j in 0..=steps {
            best = better(best, inside(at(phi[0], phi[1], i, GRID), at(delta.0, delta.1, j, steps)));
        }
    }
    // Compass search from the best grid point.
    let mut step = [(phi[1] - phi[0]) / GRID as f64, (delta.1 - delta.0) / GRID as f64];
    while step[0].max(step[1]) > 5e-4 {
        let Some(start) = best else { break };
        for (u, v) in [(1., 0.), (-1., 0.), (0., 1.), (0., -1.), (1., 1.), (1., -1.), (-1., 1.), (-1., -1.)] {
            best = better(best, inside(start.phi_deg + u * step[0], start.delta_deg + v * step[1]));
        }
        if best == Some(start) {
            step = step.map(|s| 0.5 * s);
        }
    }
    Ok(best)
}
