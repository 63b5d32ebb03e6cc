//! How far the signal of an effect stands out of everything else that a fit moves.

use nalgebra::{Cholesky, DVector, Dyn};
use soilctl_effects::{Active, Channel};

use super::problem::{Problem, Row};
use crate::setup::FitSetup;
use crate::spec::{Choice, Spec};

/// All readings of a campaign, and what soil, batches, model error, baselines and settings of the twin make of them under their priors.
pub(crate) struct Background<'a> {
    problem: Problem<'a>,
    soil: [f64; 3],
    /// Standard deviation of each row.
    sd: Vec<f64>,
    /// By group of rows that vary together: how the parameters move these rows, made independent and in standard deviations.
    lines: Vec<Vec<f64>>,
    /// Precision of the parameters, with their priors.
    precision: Cholesky<f64, Dyn>,
}

impl<'a> Background<'a> {
    /// Of a soil that has this friction angle, with readings that scatter as is to be expected. `nothing` has no effect and no shape. `None` if
    /// the force model has no answer.
    pub(crate) fn new(setup: &'a FitSetup<'a>, nothing: &'a Spec, phi_deg: f64) -> Option<Self> {
        let channels = setup.baselines.keys().copied().collect();
        let problem = Problem::new(setup, nothing, &channels, true, &super::everything(setup));
        let mut p: Vec<f64> = problem.priors.iter().map(|prior| prior.mean).collect();
        p[0] = phi_deg;
        let mut jacobian = problem.design.clone();
        problem.fill_nonlinear(&p, &mut jacobian)?;
        let ln_scatter: Vec<f64> = problem.scatter_priors().iter().map(|prior| prior.mean).collect();
        let sd: Vec<f64> = (0..problem.rows.len()).map(|r| problem.row_sd(r, &ln_scatter).0).collect();
        let width = problem.priors.len();
        let mut lines = Vec::with_capacity(problem.together.len());
        for together in &problem.together {
            let rows = together.rows.iter();
            let mut of: Vec<f64> = rows
                .flat_map(|&r| {
                    let sd = sd[r];
                    jacobian[r * width..(r + 1) * width].iter().map(move |value| value / sd)
                })
                .collect();
            together.whiten_lines(&mut of, width);
            lines.push(of);
        }
        let means = problem.y.clone();
        let precision = problem.normal(&p, &means, &ln_scatter, &jacobian).0.cholesky()?;
        Some(Self { soil: [p[0], p[1], p[2]], problem, sd, lines, precision })
    }

    /// Squared signal-to-noise ratio of an effect `s`: with everything that a fit moves (`sᵀ (C + J P Jᵀ)⁻¹ s`, of which half is the most that
    /// ln of a Bayes factor is to be expected to be), and without (`sᵀ C⁻¹ s`). `None` if the force model has no answer.
    pub(crate) fn lambda(&self, choice: &Choice, amplitude: f64) -> Option<(f64, f64)> {
        let Problem { setup, channels, rows, together, priors, .. } = &self.problem;
        let active = Active { effect: choice.effect, amplitude, shape: choice.shape };
        let (without, with) = (setup.known_and([]), setup.known_and([active]));
        let signal = |row: Row| match row {
            Row::Force(i) => {
                Some(setup.ln_force(i, self.soil, &with)? - setup.ln_force(i, self.soil, &without)?)
            }
            Row::Channel { stroke, block } => {
                Some(choice.shift(setup.data, channels[block], stroke, &active))
            }
        };
        let width = priors.len();
        let (mut raw, mut moved) = (0.0, DVector::zeros(width));
        for (together, lines) in together.iter().zip(&self.lines) {
            let rows = together.rows.iter().map(|&r| Some(signal(rows[r])? / self.sd[r]));
            let mut z: Vec<f64> = rows.collect::<Option<_>>()?;
            together.whiten(&mut z);
            for (z, line) in z.iter().zip(lines.chunks_exact(width)) {
                raw += z * z;
                for (sum, value) in moved.iter_mut().zip(line) {
                    *sum += z * value;
                }
            }
        }
        let taken = moved.dot(&self.precision.solve(&moved));
        Some(((raw - taken).max(0.0), raw))
    }

    /// Whether the readings have a column that shows the effect.
    pub(crate) fn has_any(&self, channels: &[Channel]) -> bool {
        channels.iter().any(|channel| self.problem.channels.contains(channel))
    }
}
