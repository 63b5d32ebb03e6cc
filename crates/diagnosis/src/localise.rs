//! Where model and measurement disagree: tests of residuals, by channel and covariate.

use nalgebra::{DMatrix, DVector};
use soilctl_effects::Channel;
use soilctl_stats::chi_square_tail;

use crate::channels::spread;
use crate::fit::Fit;
use crate::generic::{Condition, conditions, indicator, standard};
use crate::setup::{FitSetup, SETTING_SD};
use crate::traces::{Phase, PhaseKey};

/// A disagreement that is more than chance.
#[derive(Debug, Clone, PartialEq)]
pub struct Where {
    /// Column of the stroke table, or of the traces.
    pub channel: String,
    /// Phase of the stroke, for readings of traces; `None` for the column itself.
    pub phase: Option<Phase>,
    /// Covariate over which the residuals vary; `all` if all strokes are off what a simulated arm reads.
    pub covariate: String,
    /// Probability of as much by chance, adjusted for the number of tests (Benjamini & Hochberg 1995).
    pub p_adjusted: f64,
}

/// False-discovery rate of what is reported: the usual one.
const RATE: f64 = 0.05;
/// Part of a pattern that must be left after the fit, if a test is to mean anything. Empirical.
const LEAST_OPEN: f64 = 0.15;

/// Covariate of a difference that all strokes share.
const ALL: &str = "all";

/// Whitened residuals of a column and what was fitted to it.
struct Residuals {
    strokes: Vec<usize>,
    z: DVector<f64>,
    /// What takes a fit's directions out, softly where these have priors.
    hat: DMatrix<f64>,
    /// Probability that the mean differs by so much from what was expected by chance, if anything was.
    shared: Option<f64>,
}

/// All tests that survive the control of false discoveries, least probable first.
pub(crate) fn localise(setup: &FitSetup<'_>, baseline: &Fit) -> Vec<Where> {
    let found = conditions(setup.data);
    let mut tests = Vec::new();
    let mut test = |name: &str, phase: Option<Phase>, residuals: &Residuals| {
        if let Some(p) = residuals.shared {
            tests.push((p, name.to_owned(), phase, ALL.to_owned()));
        }
        for covariate in &found {
            let trend: Option<f64> = residuals.p_value(&[&covariate.values]);
            let p = match (
                trend,
                levels(covariate).and_then(|l| residuals.p_value(&l.iter().collect::<Vec<_>>())),
            ) {
                (Some(a), Some(b)) => (2.0 * a.min(b)).min(1.0),
                (Some(a), None) | (None, Some(a)) => a,
                (None, None) => continue,
            };
            tests.push((p, name.to_owned(), phase, covariate.covariate.to_string()));
        }
    };
    if let Some(residuals) = forces(setup, baseline) {
        test("force_n", None, &residuals);
    }
    for channel in setup.baselines.keys() {
        if let Some(residuals) = column(setup, *channel) {
            test(channel.column(), None, &residuals);
        }
    }
    for &(name, phase) in setup.data.phases.keys() {
        if let Some(residuals) = of_phase(setup, (name, phase)) {
            test(name, Some(phase), &residuals);
        }
    }
    tests.sort_by(|a, b| a.0.total_cmp(&b.0));
    let count = tests.len() as f64;
    let mut adjusted = 1.0_f64;
    let mut out: Vec<Where> = Vec::new();
    for (rank, (p, channel, phase, covariate)) in tests.into_iter().enumerate().rev() {
        adjusted = adjusted.min(p * count / (rank as f64 + 1.0));
        if adjusted <= RATE {
            out.push(Where { channel, phase, covariate, p_adjusted: adjusted });
        }
    }
    out.reverse();
    out
}

fn levels(covariate: &Condition) -> Option<Vec<Vec<f64>>> {
    let levels = covariate.levels.as_ref()?;
    let last = *levels.iter().max()?;
    (last > 1).then(|| (0..last).map(|k| indicator(levels, k)).collect())
}

/// Forces about the recalibrated baseline; soil, batches and model error are directions with priors.
fn forces(setup: &FitSetup<'_>, baseline: &Fit) -> Option<Residuals> {
    let data = setup.data;
    let n = data.len();
    let known = setup.known_and([]);
    let at = |i: usize, soil: [f64; 3]| setup.ln_force(i, soil, &known);
    let mut directions: Vec<(Vec<f64>, f64)> = Vec::new();
    for (k, sd) in [data.phi.sd, data.delta.sd, data.density.sd].into_iter().enumerate() {
        let size = 0.01;
        let slope: Option<Vec<f64>> = (0..n)
            .map(|i| {
                let (mut up, mut down) = (baseline.soil, baseline.soil);
                up[k] += size;
                down[k] -= size;
                Some((at(i, up)? - at(i, down)?) / (2.0 * size))
            })
            .collect();
        directions.push((slope?, sd));
    }
    directions.extend(setup.nuisance.iter().cloned());
    let twin = setup.twin().iter();
    directions.extend(twin.map(|setting| ((0..n).map(|i| setting.ln_force(i, 1.0)).collect(), SETTING_SD)));
    let residual: Vec<f64> = (0..n)
        .map(|i| {
            let of_nuisance: f64 =
                setup.nuisance.iter().zip(&baseline.nuisance).map(|((v, _), c)| v[i] * c).sum();
            Some(data.ln_force[i] - at(i, baseline.soil)? - of_nuisance)
        })
        .collect::<Option<_>>()?;
    Residuals::new((0..n).collect(), &residual, &baseline.force_sd, &directions)
}

/// A trace-derived column about its baseline.
fn column(setup: &FitSetup<'_>, channel: Channel) -> Option<Residuals> {
    let baseline = &setup.baselines[&channel];
    let cells = setup.data.channels.get(&channel)?;
    let strokes: Vec<usize> = (0..cells.len()).filter(|&i| cells[i].is_some()).collect();
    let values: Vec<f64> = strokes.iter().filter_map(|&i| Some(cells[i]? - baseline.known[i])).collect();
    // Coefficients are free here: a test is about patterns, not about offsets. How far the twin is off is not free.
    let twin = setup.twin().iter().filter(|setting| setting.channels().contains(&channel));
    let twin =
        twin.map(|setting| (strokes.iter().map(|&i| setting.shift(channel, i, 1.0)).collect(), SETTING_SD));
    let directions: Vec<(Vec<f64>, f64)> = baseline
        .terms
        .iter()
        .map(|(v, prior)| (strokes.iter().map(|&i| v[i]).collect(), 1e3 * prior.sd))
        .chain(twin)
        .collect();
    let shared = setup.data.expected.contains_key(&channel);
    about_baseline(strokes, values, &directions, shared)
}

/// A reading of one phase of the strokes, about a mean and a trend over the tool angle, or about what a simulated arm read.
fn of_phase(setup: &FitSetup<'_>, key: PhaseKey) -> Option<Residuals> {
    let data = setup.data;
    let cells = data.phases.get(&key)?;
    let strokes: Vec<usize> = (0..cells.len()).filter(|&i| cells[i].is_some()).collect();
    let expected = data.expected_phases.get(&key);
    let known = |i: usize| expected.map_or(0.0, |values| values[i]);
    let values: Vec<f64> = strokes.iter().filter_map(|&i| Some(cells[i]? - known(i))).collect();
    let lean = |i: &usize| (data.rows[*i].alpha_deg - data.reference.alpha_deg) / 10.0;
    let size = spread(&values).max(1e-9);
    let directions =
        [(vec![1.0; strokes.len()], 1e3 * size), (strokes.iter().map(lean).collect(), 1e3 * size)];
    about_baseline(strokes, values, &directions, expected.is_some())
}

/// Residuals about free directions. `shared` asks whether their mean differs from zero, too.
fn about_baseline(
    strokes: Vec<usize>,
    values: Vec<f64>,
    directions: &[(Vec<f64>, f64)],
    shared: bool,
) -> Option<Residuals> {
    let n = values.len();
    if n < directions.len() + 4 {
        return None;
    }
    let design = DMatrix::from_fn(n, directions.len(), |i, k| directions[k].0[i] * directions[k].1);
    let mean = values.iter().sum::<f64>() / n as f64;
    let solved = (design.transpose() * &design
        + DMatrix::identity(directions.len(), directions.len()) * 1e-12)
        .cholesky()?
        .solve(&(design.transpose() * DVector::from_vec(values.clone())));
    let fitted = &design * solved;
    let residual: Vec<f64> = values.iter().zip(fitted.iter()).map(|(a, b)| a - b).collect();
    let scatter = spread(&residual);
    if scatter <= 0.0 {
        return None;
    }
    let mut found = Residuals::new(strokes, &residual, &vec![scatter; n], directions)?;
    if shared {
        found.shared = Some(chi_square_tail((mean / scatter).powi(2) * n as f64, 1));
    }
    Some(found)
}

impl Residuals {
    fn new(
        strokes: Vec<usize>,
        residual: &[f64],
        sd: &[f64],
        directions: &[(Vec<f64>, f64)],
    ) -> Option<Self> {
        let n = strokes.len();
        let z = DVector::from_fn(n, |i, _| (residual[i] / sd[i]).clamp(-4.0, 4.0));
        let design =
            DMatrix::from_fn(n, directions.len(), |i, k| directions[k].0[i] * directions[k].1 / sd[i]);
        let inner = design.transpose() * &design + DMatrix::identity(directions.len(), directions.len());
        let hat = &design * inner.cholesky()?.solve(&design.transpose());
        Some(Self { strokes, z, hat, shared: None })
    }

    /// Score test of several regressors over all strokes of the campaign.
    fn p_value(&self, regressors: &[&Vec<f64>]) -> Option<f64> {
        let n = self.strokes.len();
        // What the fit has taken out already is no test.
        let open = |x: &Vec<f64>| {
            let x = DVector::from_column_slice(x);
            x.dot(&(&x - &self.hat * &x)) > LEAST_OPEN * n as f64
        };
        let columns: Vec<Vec<f64>> = regressors
            .iter()
            .filter_map(|values| standard(&self.strokes.iter().map(|&i| values[i]).collect::<Vec<_>>()))
            .filter(open)
            .collect();
        if columns.is_empty() || n < columns.len() + 3 {
            return None;
        }
        let x = DMatrix::from_fn(n, columns.len(), |i, k| columns[k][i]);
        let information = x.transpose() * (&x - &self.hat * &x)
            + DMatrix::identity(x.ncols(), x.ncols()) * (1e-2 * n as f64);
        let score = x.transpose() * &self.z;
        let statistic = score.dot(&information.cholesky()?.solve(&score));
        Some(chi_square_tail(statistic, columns.len()))
    }
}
