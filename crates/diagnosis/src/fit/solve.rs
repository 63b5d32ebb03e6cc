//! The search for the most likely parameters, and the evidence there by Laplace's approximation.

use nalgebra::{DMatrix, DVector};

use super::Fit;
use super::problem::{Problem, weight};
use crate::data::Prior;

/// Mean of weight times squared residual for Gaussian scatter, `E[z^2 / sqrt(1 + z^2 / 2.5^2)]`, which makes the scatter come out right
/// for it.
const GAUSSIAN_SHARE: f64 = 0.840;
/// Most rounds; what has not settled by then is judged where it is.
const MAX_ROUNDS: usize = 30;
/// Standard deviations of its prior by which a ln scatter may lie below it: readings that are all the same say nothing of how
/// exact the next one is, and a scatter of nothing would leave nothing to be computed with.
const LEAST_SCATTER: f64 = 4.0;
/// Half the step of a central difference, in ln density and ln amplitude; angles, in deg, take ten times as much.
const STEP: f64 = 1e-4;

impl Problem<'_> {
    pub(super) fn solve(&self) -> Option<Fit> {
        let width = self.priors.len();
        let scatter_priors = self.scatter_priors();
        let mut ln_scatter: Vec<f64> = scatter_priors.iter().map(|prior| prior.mean).collect();
        let mut p: Vec<f64> = self.priors.iter().map(|prior| prior.mean).collect();
        let mut jacobian = self.design.clone();
        let mut last = None;
        for round in 0..MAX_ROUNDS {
            self.fill_nonlinear(&p, &mut jacobian)?;
            let means = self.means(&p)?;
            let (hessian, gradient) = self.normal(&p, &means, &ln_scatter, &jacobian);
            let cholesky = hessian.cholesky()?;
            let step = cholesky.solve(&gradient);
            let moved = self.walk(&mut p, &step, &ln_scatter)?;
            let covariance = cholesky.inverse();
            let mut change = 0.0_f64;
            for k in 0..width {
                change = change.max((moved * step[k]).abs() / covariance[(k, k)].sqrt());
            }
            let means = self.means(&p)?;
            let shift = self.update_scatter(&means, &mut ln_scatter, &scatter_priors, &jacobian, &covariance);
            last = Some(covariance);
            if change < 0.01 && shift < 0.005 && round > 1 {
                break;
            }
        }
        self.fill_nonlinear(&p, &mut jacobian)?;
        let means = self.means(&p)?;
        let (hessian, _) = self.normal(&p, &means, &ln_scatter, &jacobian);
        let cholesky = hessian.cholesky()?;
        let half_ln_det: f64 = (0..width).map(|k| cholesky.l_dirty()[(k, k)].ln()).sum();
        let priors: f64 = self.priors.iter().map(|prior| prior.sd.ln()).sum();
        let scatter: f64 = scatter_priors
            .iter()
            .zip(&ln_scatter)
            .skip(usize::from(!self.with_force))
            .map(|(prior, s)| 0.5 * ((s - prior.mean) / prior.sd).powi(2))
            .sum();
        let log_evidence = -self.objective(&p, &ln_scatter)? - priors - half_ln_det - scatter;
        last = Some(cholesky.inverse()).or(last);
        Some(self.report(&p, &means, &ln_scatter, &jacobian, &last?, log_evidence))
    }

    /// Derivatives with respect to soil and amplitudes.
    pub(super) fn fill_nonlinear(&self, p: &[f64], jacobian: &mut [f64]) -> Option<()> {
        let width = self.priors.len();
        let soil = 0..self.nuisance_at;
        for k in soil.chain(self.amplitude_at..width) {
            let size = STEP * if k < 2 { 10.0 } else { 1.0 };
            let (mut up, mut down) = (p.to_vec(), p.to_vec());
            up[k] += size;
            down[k] -= size;
            let (up, down) = (self.nonlinear(&up)?, self.nonlinear(&down)?);
            for r in 0..self.rows.len() {
                jacobian[r * width + k] = (up[r] - down[r]) / (2.0 * size);
            }
        }
        Some(())
    }

    pub(super) fn normal(
        &self,
        p: &[f64],
        means: &[f64],
        ln_scatter: &[f64],
        jacobian: &[f64],
    ) -> (DMatrix<f64>, DVector<f64>) {
        let width = self.priors.len();
        let mut hessian = DMatrix::zeros(width, width);
        let mut gradient = DVector::zeros(width);
        for together in &self.together {
            let (mut residuals, mut lines) = (Vec::new(), Vec::with_capacity(together.rows.len() * width));
            for &r in &together.rows {
                let sd = self.row_sd(r, ln_scatter).0;
                residuals.push((self.y[r] - means[r]) / sd);
                lines.extend(jacobian[r * width..(r + 1) * width].iter().map(|value| value / sd));
            }
            together.whiten(&mut residuals);
            together.whiten_lines(&mut lines, width);
            for (z, line) in residuals.into_iter().zip(lines.chunks_exact(width)) {
                let weight = weight(z);
                let columns = hessian.as_mut_slice().chunks_exact_mut(width);
                for (i, (column, value)) in
                    columns.zip(line).enumerate().filter(|(_, (_, value))| **value != 0.0)
                {
                    let scaled = weight * value;
                    gradient[i] += scaled * z;
                    // The upper triangle, in a form that is computed several values at a time.
                    for (sum, other) in column[..=i].iter_mut().zip(line) {
                        *sum += scaled * other;
                    }
                }
            }
        }
        for (k, prior) in self.priors.iter().enumerate() {
            let precision = 1.0 / (prior.sd * prior.sd);
            hessian[(k, k)] += precision;
            gradient[k] -= precision * (p[k] - prior.mean);
        }
        for i in 0..width {
            for j in 0..i {
                hessian[(i, j)] = hessian[(j, i)];
            }
        }
        (hessian, gradient)
    }

    /// Goes along a step as far as the objective falls; the share of the step that was taken.
    fn walk(&self, p: &mut Vec<f64>, step: &DVector<f64>, ln_scatter: &[f64]) -> Option<f64> {
        let before = self.objective(p, ln_scatter)?;
        let mut share = 1.0;
        for _ in 0..12 {
            let mut moved: Vec<f64> =
                p.iter().zip(step.iter()).map(|(value, change)| value + share * change).collect();
            // Amplitudes far off their range (a factor of 5 to 50 beyond it) are no place to look at.
            for (k, value) in moved.iter_mut().enumerate().skip(self.amplitude_at) {
                let prior = self.priors[k];
                *value = value.clamp(prior.mean - 6.0 * prior.sd, prior.mean + 4.0 * prior.sd);
            }
            if self.objective(&moved, ln_scatter).is_some_and(|after| after <= before + 1e-9) {
                *p = moved;
                return Some(share);
            }
            share *= 0.4;
        }
        Some(0.0)
    }

    /// Moves the scatters towards where the evidence is greatest; the largest change of a ln scatter.
    fn update_scatter(
        &self,
        means: &[f64],
        ln_scatter: &mut [f64],
        priors: &[Prior],
        jacobian: &[f64],
        covariance: &DMatrix<f64>,
    ) -> f64 {
        let width = self.priors.len();
        let (mut excess, mut curvature) = (vec![0.0; ln_scatter.len()], vec![0.0; ln_scatter.len()]);
        let mut present = Vec::with_capacity(width);
        for (r, mean) in self.included_rows(means) {
            let (sd, share) = self.row_sd(r, ln_scatter);
            if share == 0.0 {
                continue;
            }
            let z = (self.y[r] - mean) / sd;
            let w = weight(z);
            let line = &jacobian[r * width..(r + 1) * width];
            present.clear();
            present.extend((0..width).filter(|&k| line[k] != 0.0));
            let mut leverage = 0.0;
            for &i in &present {
                for &j in &present {
                    leverage += line[i] * covariance[(i, j)] * line[j];
                }
            }
            leverage = (w * leverage / (sd * sd)).min(0.95);
            excess[self.block[r]] += share * (w * z * z / GAUSSIAN_SHARE - (1.0 - leverage));
            curvature[self.block[r]] += 2.0 * share * share * (1.0 - leverage);
        }
        let mut largest = 0.0_f64;
        for (block, prior) in priors.iter().enumerate() {
            let precision = 1.0 / (prior.sd * prior.sd);
            let change = (excess[block] - precision * (ln_scatter[block] - prior.mean))
                / (curvature[block] + precision);
            let change = change.clamp(-0.5, 0.5);
            let least = prior.mean - LEAST_SCATTER * prior.sd;
            let moved = (ln_scatter[block] + change).max(least);
            largest = largest.max((moved - ln_scatter[block]).abs());
            ln_scatter[block] = moved;
        }
        largest
    }
}
