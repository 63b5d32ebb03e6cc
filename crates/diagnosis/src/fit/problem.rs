//! Expectations of all readings as functions of the parameters, and what they cost.

use std::collections::BTreeSet;

use soilctl_effects::{Active, Channel};

use super::together::Together;
use crate::data::Prior;
use crate::setup::{FitSetup, SETTING_SD};
use crate::spec::Spec;

/// Residuals beyond about this many standard deviations count less and less (pseudo-Huber). Usual: one in 80 of a normal scatter.
const HUBER: f64 = 2.5;
/// ln scatter of a stroke before it is looked at, and its standard deviation: 6 %, within a factor of 1.5. Empirical: strokes
/// of `data/failure_forces.csv` scatter by 5 to 10 %, mostly.
const LN_SCATTER: Prior = Prior { mean: -2.813, sd: 0.4 };
/// Standard deviation of the coefficient of a shape without a name, as a change of ln force: that of a usual effect. Empirical.
const GENERIC_SD: f64 = 0.08;
/// Relative freedom of an amplitude that is kept as it is: none to speak of, but a prior that can be computed with.
const FIXED_SD: f64 = 1e-5;

#[derive(Clone, Copy)]
pub(super) enum Row {
    Force(usize),
    Channel { stroke: usize, block: usize },
}

impl Row {
    pub(super) fn stroke(self) -> usize {
        match self {
            Self::Force(stroke) | Self::Channel { stroke, .. } => stroke,
        }
    }
}

pub(super) struct Problem<'a> {
    pub(super) setup: &'a FitSetup<'a>,
    pub(super) spec: &'a Spec,
    pub(super) channels: Vec<Channel>,
    pub(super) rows: Vec<Row>,
    pub(super) y: Vec<f64>,
    /// Block of each row: 0 forces, then channels.
    pub(super) block: Vec<usize>,
    pub(super) included: Vec<bool>,
    /// Rows that take part, those together that vary together.
    pub(super) together: Vec<Together>,
    /// Design of the linear parameters, row by row; nonlinear columns are filled in every round.
    pub(super) design: Vec<f64>,
    pub(super) priors: Vec<Prior>,
    pub(super) with_force: bool,
    pub(super) nuisance_at: usize,
    pub(super) generic_at: usize,
    pub(super) amplitude_at: usize,
}

impl<'a> Problem<'a> {
    pub(super) fn new(
        setup: &'a FitSetup<'a>,
        spec: &'a Spec,
        channels: &BTreeSet<Channel>,
        with_force: bool,
        include: &[bool],
    ) -> Self {
        let data = setup.data;
        let channels: Vec<Channel> = channels.iter().copied().collect();
        let mut priors = Vec::new();
        if with_force {
            priors.extend([data.phi, setup.delta(spec), Prior { mean: 0.0, sd: data.density.sd }]);
        }
        let nuisance_at = priors.len();
        let nuisance: &[(Vec<f64>, f64)] = if with_force { &setup.nuisance } else { &[] };
        priors.extend(nuisance.iter().map(|(_, sd)| Prior { mean: 0.0, sd: *sd }));
        let generic_at = priors.len();
        let generic_sd = GENERIC_SD / (spec.generic.len().max(1) as f64).sqrt();
        priors.extend(spec.generic.iter().map(|_| Prior { mean: 0.0, sd: generic_sd }));
        let twin_at = priors.len();
        let twin = if with_force { setup.twin() } else { &[] };
        priors.extend(twin.iter().map(|_| Prior { mean: 0.0, sd: SETTING_SD }));
        // Linear terms of channels: (column, block, values by stroke).
        let mut terms: Vec<(usize, Vec<f64>)> = Vec::new();
        let terms_at = priors.len();
        for (block, channel) in channels.iter().enumerate() {
            for (values, prior) in &setup.baselines[channel].terms {
                terms.push((block, values.clone()));
                priors.push(*prior);
            }
            for choice in spec.choices.iter().filter(|choice| choice.responds) {
                for response in choice.effect.responses.iter().filter(|r| r.channel == *channel) {
                    let at = |stroke| choice.effect.response(*channel, choice.shape, stroke, &data.reference);
                    terms.push((block, data.strokes.iter().map(at).collect()));
                    priors.push(Prior { mean: response.mean, sd: response.sd });
                }
            }
        }
        let amplitude_at = priors.len();
        for (k, choice) in spec.choices.iter().enumerate() {
            let range = setup.range(choice.effect);
            let held = data.held(choice.effect.id).map(|(amplitude, _)| amplitude);
            priors.push(match spec.fixed.get(k).copied().or(held) {
                Some(amplitude) => Prior { mean: amplitude.abs().ln(), sd: FIXED_SD },
                None => Prior { mean: range.typical().ln(), sd: range.ln_sd() },
            });
        }
        let (mut rows, mut y, mut blocks, mut design) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let width = priors.len();
        let mut included = Vec::new();
        if with_force {
            for i in 0..data.len() {
                included.push(include[i]);
                rows.push(Row::Force(i));
                y.push(data.ln_force[i]);
                blocks.push(0);
                let mut line = vec![0.0; width];
                for (k, (values, _)) in nuisance.iter().enumerate() {
                    line[nuisance_at + k] = values[i];
                }
                for (k, values) in spec.generic.iter().enumerate() {
                    line[generic_at + k] = values[i];
                }
                for (k, setting) in twin.iter().enumerate() {
                    line[twin_at + k] = setting.ln_force(i, 1.0);
                }
                design.extend(line);
            }
        }
        for (block, channel) in channels.iter().enumerate() {
            let baseline = &setup.baselines[channel];
            for i in 0..data.len() {
                let Some(value) = data.channels.get(channel).and_then(|cells| cells[i]) else { continue };
                included.push(include[i]);
                rows.push(Row::Channel { stroke: i, block });
                y.push(value - baseline.known[i]);
                blocks.push(block + 1);
                let mut line = vec![0.0; width];
                for (k, (of, values)) in terms.iter().enumerate() {
                    if *of == block {
                        line[terms_at + k] = values[i];
                    }
                }
                for (k, setting) in twin.iter().enumerate() {
                    line[twin_at + k] = setting.shift(*channel, i, 1.0);
                }
                design.extend(line);
            }
        }
        let signal = |row: Row| match row {
            Row::Force(_) => None,
            Row::Channel { block, .. } => Some(channels[block]),
        };
        let together = Together::all(&rows, &included, signal, setup.correlation());
        Self {
            setup,
            spec,
            channels,
            rows,
            y,
            block: blocks,
            included,
            together,
            design,
            priors,
            with_force,
            nuisance_at,
            generic_at,
            amplitude_at,
        }
    }

    /// What is known, then the choices.
    pub(super) fn actives(&self, p: &[f64]) -> Vec<Active> {
        let amplitudes = &p[self.amplitude_at..];
        self.setup.known_and(self.spec.choices.iter().zip(amplitudes).map(|(choice, a)| Active {
            effect: choice.effect,
            amplitude: choice.sign * a.exp(),
            shape: choice.shape,
        }))
    }

    /// Nonlinear part of all expectations; `None` where the model has no answer.
    pub(super) fn nonlinear(&self, p: &[f64]) -> Option<Vec<f64>> {
        let actives = self.actives(p);
        self.rows.iter().map(|row| self.nonlinear_row(*row, p, &actives)).collect()
    }

    pub(super) fn nonlinear_row(&self, row: Row, p: &[f64], actives: &[Active]) -> Option<f64> {
        let data = self.setup.data;
        match row {
            Row::Force(i) => self.setup.ln_force(i, [p[0], p[1], p[2]], actives),
            Row::Channel { stroke, block } => {
                let channel = self.channels[block];
                let reads_delta = self.with_force && self.setup.baselines[&channel].reads_delta;
                let mut value = if reads_delta { p[1] } else { 0.0 };
                for (choice, active) in self.spec.choices.iter().zip(&actives[data.known.len()..]) {
                    value += choice.shift(data, channel, stroke, active);
                }
                Some(value)
            }
        }
    }

    pub(super) fn means(&self, p: &[f64]) -> Option<Vec<f64>> {
        let mut means = self.nonlinear(p)?;
        let (width, first) = (self.priors.len(), self.nuisance_at);
        for (r, mean) in means.iter_mut().enumerate() {
            let line = &self.design[r * width..(r + 1) * width];
            *mean += (first..self.amplitude_at).map(|k| line[k] * p[k]).sum::<f64>();
        }
        Some(means)
    }

    pub(super) fn included_rows<'m>(&'m self, means: &'m [f64]) -> impl Iterator<Item = (usize, &'m f64)> {
        means.iter().enumerate().filter(|(r, _)| self.included[*r])
    }

    /// Standard deviation of a row and the share of its variance that is the fitted scatter.
    pub(super) fn row_sd(&self, r: usize, ln_scatter: &[f64]) -> (f64, f64) {
        let s = ln_scatter[self.block[r]].exp();
        match self.rows[r] {
            Row::Force(i) => {
                let row = &self.setup.data.rows[i];
                let depth = 2.0 * self.setup.data.campaign.depth_sd_m / row.depth_m;
                // What a force is known to says nothing of how far strokes scatter; rows of a summary hold both.
                let (own, fitted) = match row.force_sd_n {
                    Some(sd) if self.setup.data.is_summary() => (sd / row.force_n, 0.0),
                    Some(sd) => (sd / row.force_n, s),
                    None => (0.0, s),
                };
                let variance = own * own + fitted * fitted + depth * depth + self.setup.unsteadiness(None, i);
                (variance.sqrt().max(1e-4), fitted * fitted / variance)
            }
            Row::Channel { stroke, block } => {
                let other = self.setup.unsteadiness(Some(self.channels[block]), stroke);
                let variance = s * s + other;
                if other > 0.0 { (variance.sqrt(), s * s / variance) } else { (s, 1.0) }
            }
        }
    }

    pub(super) fn scatter_priors(&self) -> Vec<Prior> {
        std::iter::once(LN_SCATTER)
            .chain(self.channels.iter().map(|channel| self.setup.baselines[channel].ln_scatter))
            .collect()
    }

    pub(super) fn objective(&self, p: &[f64], ln_scatter: &[f64]) -> Option<f64> {
        let means = self.means(p)?;
        let mut sum = 0.0;
        for together in &self.together {
            let mut z = Vec::with_capacity(together.rows.len());
            for &r in &together.rows {
                let sd = self.row_sd(r, ln_scatter).0;
                sum += sd.ln();
                z.push((self.y[r] - means[r]) / sd);
            }
            together.whiten(&mut z);
            sum += z.into_iter().map(loss).sum::<f64>() + together.half_ln_det;
        }
        for (value, prior) in p.iter().zip(&self.priors) {
            sum += 0.5 * ((value - prior.mean) / prior.sd).powi(2);
        }
        sum.is_finite().then_some(sum)
    }
}

fn loss(z: f64) -> f64 {
    HUBER * HUBER * ((1.0 + (z / HUBER).powi(2)).sqrt() - 1.0)
}

pub(super) fn weight(z: f64) -> f64 {
    1.0 / (1.0 + (z / HUBER).powi(2)).sqrt()
}
