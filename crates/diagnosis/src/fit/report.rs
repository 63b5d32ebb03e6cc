//! What a fit tells.

use nalgebra::DMatrix;

use super::problem::{Problem, Row};
use super::{Fit, Reading};

impl Problem<'_> {
    pub(super) fn report(
        &self,
        p: &[f64],
        means: &[f64],
        ln_scatter: &[f64],
        jacobian: &[f64],
        covariance: &DMatrix<f64>,
        log_evidence: f64,
    ) -> Fit {
        let data = self.setup.data;
        let width = self.priors.len();
        let sd = |k: usize| covariance[(k, k)].max(0.0).sqrt();
        let amplitudes = self
            .spec
            .choices
            .iter()
            .enumerate()
            .map(|(k, choice)| {
                let size = p[self.amplitude_at + k].exp();
                (choice.sign * size, size * sd(self.amplitude_at + k))
            })
            .collect();
        let (mut soil, mut soil_sd) =
            ([data.phi.mean, 0.0, 0.0], [data.phi.sd, data.delta.sd, data.density.sd]);
        if self.with_force {
            soil = [p[0], p[1], p[2]];
            soil_sd = [sd(0), sd(1), sd(2)];
        }
        let shape = self.generic_at..self.generic_at + self.spec.generic.len();
        let batches = if self.with_force { self.setup.batch_terms } else { 0 };
        let (mut force_sd, mut ln_force, mut expectation_sd) = (Vec::new(), Vec::new(), Vec::new());
        let mut readings = Vec::new();
        for (r, row) in self.rows.iter().enumerate() {
            if matches!(row, Row::Channel { .. }) && self.included[r] {
                continue;
            }
            let line = &jacobian[r * width..(r + 1) * width];
            let of_batch: f64 =
                (0..batches).map(|k| line[self.nuisance_at + k] * p[self.nuisance_at + k]).sum();
            let keep: Vec<usize> = (0..width)
                .filter(|k| !(self.nuisance_at..self.nuisance_at + batches).contains(k) && line[*k] != 0.0)
                .collect();
            let mut variance = 0.0;
            for &i in &keep {
                for &j in &keep {
                    variance += line[i] * covariance[(i, j)] * line[j];
                }
            }
            let (of_row, of_mean) = (self.row_sd(r, ln_scatter).0, variance.max(0.0).sqrt());
            match *row {
                Row::Force(_) => {
                    force_sd.push(of_row);
                    ln_force.push(means[r] - of_batch);
                    expectation_sd.push(of_mean);
                }
                Row::Channel { stroke, block } => readings.push(Reading {
                    channel: self.channels[block],
                    stroke,
                    residual: self.y[r] - means[r],
                    sd: of_row.hypot(of_mean),
                }),
            }
        }
        Fit {
            log_evidence,
            soil,
            soil_sd,
            amplitudes,
            nuisance: p[self.nuisance_at..self.generic_at].to_vec(),
            shape: shape.clone().map(|k| p[k]).collect(),
            shape_covariance: shape
                .clone()
                .map(|i| shape.clone().map(|j| covariance[(i, j)]).collect())
                .collect(),
            scatter: ln_scatter[0].exp(),
            force_sd,
            ln_force,
            expectation_sd,
            readings,
        }
    }
}
