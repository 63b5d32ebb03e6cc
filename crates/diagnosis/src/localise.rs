//! Where model and measurement disagree: tests of residuals, by channel and covariate.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use soilctl_effects::{Base, Channel, force_n};

use crate::channels::spread;
use crate::chi_square;
use crate::fit::Fit;
use crate::generic::{Covariate, covariates, standard};
use crate::setup::Setup;

/// A disagreement that is more than chance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Where {
    /// Column of the stroke table.
    pub channel: String,
    /// Covariate over which the residuals vary.
    pub covariate: String,
    /// Probability of as much by chance, adjusted for the number of tests (Benjamini & Hochberg 1995).
    pub p_adjusted: f64,
}

/// False-discovery rate of what is reported.
const RATE: f64 = 0.05;
/// Part of a pattern that must be left after the fit, if a test is to mean anything.
const LEAST_OPEN: f64 = 0.15;

/// Whitened residuals of a column and what was fitted to it.
struct Residuals {
    strokes: Vec<usize>,
    z: DVector<f64>,
    /// What takes a fit's directions out, softly where these have priors.
    hat: DMatrix<f64>,
}

/// All tests that survive the control of false discoveries, least probable first.
pub(crate) fn localise(setup: &Setup<'_>, baseline: &Fit) -> Vec<Where> {
    let found = covariates(setup.data);
    let mut tests = Vec::new();
    let mut test = |name: &str, residuals: &Residuals| {
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
            tests.push((p, name.to_owned(), covariate.name.to_owned()));
        }
    };
    if let Some(residuals) = forces(setup, baseline) {
        test("force_n", &residuals);
    }
    for channel in setup.baselines.keys() {
        if let Some(residuals) = column(setup, *channel) {
            test(channel.column(), &residuals);
        }
    }
    tests.sort_by(|a, b| a.0.total_cmp(&b.0));
    let count = tests.len() as f64;
    let mut adjusted = 1.0_f64;
    let mut out: Vec<Where> = Vec::new();
    for (rank, (p, channel, covariate)) in tests.into_iter().enumerate().rev() {
        adjusted = adjusted.min(p * count / (rank as f64 + 1.0));
        if adjusted <= RATE {
            out.push(Where { channel, covariate, p_adjusted: adjusted });
        }
    }
    out.reverse();
    out
}

fn levels(covariate: &Covariate) -> Option<Vec<Vec<f64>>> {
    let levels = covariate.levels.as_ref()?;
    let last = *levels.iter().max()?;
    (last > 1)
        .then(|| (0..last).map(|k| levels.iter().map(|&l| f64::from(u8::from(l == k))).collect()).collect())
}

/// Forces about the recalibrated baseline; soil, batches and model error are directions with priors.
fn forces(setup: &Setup<'_>, baseline: &Fit) -> Option<Residuals> {
    let data = setup.data;
    let n = data.len();
    let at = |i: usize, soil: [f64; 3]| {
        let base = Base {
            phi_deg: soil[0],
            delta_deg: (data.delta_set_deg(i) + soil[1]).max(0.0),
            density_kg_m3: data.density.mean * soil[2].exp(),
            gravity_m_s2: data.gravity_m_s2,
        };
        force_n(setup.surface, &data.strokes[i], &data.reference, &base, &[]).ok().map(f64::ln)
    };
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
fn column(setup: &Setup<'_>, channel: Channel) -> Option<Residuals> {
    let baseline = &setup.baselines[&channel];
    let cells = setup.data.channels.get(&channel)?;
    let strokes: Vec<usize> = (0..cells.len()).filter(|&i| cells[i].is_some()).collect();
    let values: Vec<f64> = strokes.iter().filter_map(|&i| Some(cells[i]? - baseline.known[i])).collect();
    // Coefficients are free here: a test is about patterns, not about offsets.
    let directions: Vec<(Vec<f64>, f64)> = baseline
        .terms
        .iter()
        .map(|(v, prior)| (strokes.iter().map(|&i| v[i]).collect(), 1e3 * prior.sd))
        .collect();
    let n = values.len();
    if n < directions.len() + 4 {
        return None;
    }
    let design = DMatrix::from_fn(n, directions.len(), |i, k| directions[k].0[i] * directions[k].1);
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
    Residuals::new(strokes, &residual, &vec![scatter; n], &directions)
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
        Some(Self { strokes, z, hat })
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
        Some(chi_square::tail(statistic, columns.len()))
    }
}
