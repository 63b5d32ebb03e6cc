//! What one would otherwise do: plain nonlinear least squares, from several starts.
//!
//! Kept for comparison (Hong 2001, section 7.4): the misfit has a long flat valley with several minima, a single
//! answer says nothing about its uncertainty, and different starts end in different places.

use argmin::core::{CostFunction, Executor, State};
use argmin::solver::neldermead::NelderMead;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::storage::Owned;
use nalgebra::{DVector, Dyn, Matrix, OVector, U3, Vector3};

use crate::misfit::{Fit, Misfit};
use crate::{EstimatorError, Setup};

/// A local optimiser.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Optimiser {
    /// Downhill simplex (Nelder & Mead), which the thesis used.
    DownhillSimplex,
    /// Levenberg-Marquardt, the usual damped Newton method for least squares.
    LevenbergMarquardt,
}

/// Where an optimiser started and ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalMinimum {
    /// Which optimiser.
    pub optimiser: Optimiser,
    /// Start (phi in degrees, density in kg/m3, delta in degrees).
    pub start: [f64; 3],
    /// End.
    pub end: Fit,
}

/// The search box; inside it the parameters are free, outside the logistic map never leads.
struct Box3 {
    low: [f64; 3],
    high: [f64; 3],
}

impl Box3 {
    fn of(setup: &Setup<'_>) -> Self {
        let (phi, density) = (setup.phi_range_deg(), setup.density_range_kg_m3());
        Self { low: [phi.0, density.0, setup.delta_deg.0], high: [phi.1, density.1, setup.delta_deg.1] }
    }

    fn inside(&self, u: &[f64]) -> [f64; 3] {
        std::array::from_fn(|i| self.low[i] + (self.high[i] - self.low[i]) / (1.0 + (-u[i]).exp()))
    }

    fn free(&self, x: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| {
            let width = (self.high[i] - self.low[i]).max(f64::MIN_POSITIVE);
            let t = ((x[i] - self.low[i]) / width).clamp(1e-6, 1.0 - 1e-6);
            (t / (1.0 - t)).ln()
        })
    }
}

struct Problem<'a, 'm> {
    misfit: &'a Misfit<'m>,
    domain: &'a Box3,
    at: Vector3<f64>,
}

impl Problem<'_, '_> {
    fn residuals_at(&self, u: &[f64]) -> Vec<f64> {
        let [phi, density, delta] = self.domain.inside(u);
        let n = self.misfit.residuals(phi, density, delta.min(phi));
        // Where the model has no answer, a misfit larger than any real one.
        n.unwrap_or_else(|| vec![1e3; self.misfit.len()])
    }
}

impl CostFunction for Problem<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    fn cost(&self, u: &Self::Param) -> Result<f64, argmin::core::Error> {
        Ok(self.residuals_at(u).iter().map(|r| r * r).sum())
    }
}

impl LeastSquaresProblem<f64, Dyn, U3> for Problem<'_, '_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, U3>;
    type ParameterStorage = Owned<f64, U3>;

    fn set_params(&mut self, u: &OVector<f64, U3>) {
        self.at = *u;
    }

    fn params(&self) -> OVector<f64, U3> {
        self.at
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(DVector::from_vec(self.residuals_at(self.at.as_slice())))
    }

    fn jacobian(&self) -> Option<Matrix<f64, Dyn, U3, Self::JacobianStorage>> {
        const STEP: f64 = 1e-5;
        let columns: Vec<DVector<f64>> = (0..3)
            .map(|i| {
                let (mut ahead, mut behind) = (self.at, self.at);
                ahead[i] += STEP;
                behind[i] -= STEP;
                let difference = DVector::from_vec(self.residuals_at(ahead.as_slice()))
                    - DVector::from_vec(self.residuals_at(behind.as_slice()));
                difference / (2.0 * STEP)
            })
            .collect();
        Some(Matrix::<f64, Dyn, U3, _>::from_columns(&columns))
    }
}

/// Minimises the misfit over phi, density and delta within the search range from each start
/// (phi in degrees, density in kg/m3, delta in degrees), ignoring the uncertainties.
///
/// # Errors
/// As [`crate::estimate`].
pub fn local_minima(
    setup: &Setup<'_>,
    optimiser: Optimiser,
    starts: &[[f64; 3]],
) -> Result<Vec<LocalMinimum>, EstimatorError> {
    setup.check()?;
    setup.check_one_friction("the search for local minima")?;
    setup.check_known_loads("the search for local minima")?;
    let (misfit, domain) = (Misfit::new(setup)?, Box3::of(setup));
    let mut found = Vec::with_capacity(starts.len());
    for &start in starts {
        let free = domain.free(start);
        let problem = Problem { misfit: &misfit, domain: &domain, at: Vector3::from(free) };
        let end = match optimiser {
            Optimiser::DownhillSimplex => downhill_simplex(problem, free),
            Optimiser::LevenbergMarquardt => {
                LevenbergMarquardt::new().with_patience(200).minimize(problem).0.at.as_slice().to_vec()
            }
        };
        let [phi_deg, density_kg_m3, delta] = domain.inside(&end);
        let delta_deg = delta.min(phi_deg);
        if let Some(value) = misfit.value(phi_deg, density_kg_m3, delta_deg) {
            found.push(LocalMinimum {
                optimiser,
                start,
                end: Fit { phi_deg, density_kg_m3, delta_deg, slope_deg_per_decade: None, misfit: value },
            });
        }
    }
    Ok(found)
}

/// A start is returned unchanged if the simplex breaks down on it.
fn downhill_simplex(problem: Problem<'_, '_>, start: [f64; 3]) -> Vec<f64> {
    let mut simplex = vec![start.to_vec()];
    for i in 0..3 {
        let mut corner = start.to_vec();
        corner[i] += 0.5;
        simplex.push(corner);
    }
    NelderMead::new(simplex)
        .with_sd_tolerance(1e-14)
        .and_then(|solver| Executor::new(problem, solver).configure(|state| state.max_iters(2000)).run())
        .ok()
        .and_then(|result| result.state().get_best_param().cloned())
        .unwrap_or_else(|| start.to_vec())
}

/// Starts spread over the search range: a grid of three values of each parameter that is not known exactly.
#[must_use]
pub fn spread_starts(setup: &Setup<'_>) -> Vec<[f64; 3]> {
    let domain = Box3::of(setup);
    // Densities beyond any sand only slow the search down.
    let (low, high) = (domain.low[1].max(1000.0), domain.high[1].min(2200.0));
    let spread = |low: f64, high: f64| -> Vec<f64> {
        if low >= high { vec![low] } else { [0.15, 0.5, 0.85].map(|t| low + t * (high - low)).to_vec() }
    };
    let mut starts = Vec::new();
    for &phi in &spread(domain.low[0], domain.high[0]) {
        for &density in &spread(low, high) {
            for &delta in &spread(domain.low[2], domain.high[2]) {
                starts.push([phi, density, delta.min(phi)]);
            }
        }
    }
    starts
}
