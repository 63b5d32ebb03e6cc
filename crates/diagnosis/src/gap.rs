//! The gap between model and forces, before and after effects are added, also on batches that the fit has not seen.

use std::collections::BTreeSet;

use soilctl_effects::Channel;

use crate::fit::{Fit, everything, fit};
use crate::parts::{Miss, Misses, Part, parts, sum_and_error};
use crate::setup::FitSetup;
use crate::spec::Spec;

/// How far model and measurement are apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Root mean square of ln force measured over predicted, without effects.
    pub before: f64,
    /// The same with effects.
    pub after: f64,
    /// The same as `before`, each batch predicted from the others; none with fewer than two batches.
    pub heldout_before: Option<f64>,
    /// The same as `after`, each batch predicted from the others.
    pub heldout_after: Option<f64>,
    /// Held-out chi-square a stroke without effects.
    pub chi2_per_n_before: Option<f64>,
    /// Held-out chi-square a stroke with effects.
    pub chi2_per_n_after: Option<f64>,
    /// Gain in expected log predictive density of all batches.
    pub delta_elpd: Option<f64>,
    /// Its standard error over batches.
    pub delta_elpd_se: Option<f64>,
}

/// Soil of a fit that a model file can repeat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedSoil {
    /// Friction angle, deg.
    pub phi_deg: f64,
    /// Its standard deviation.
    pub phi_sd_deg: f64,
    /// Interface friction minus set-point, deg.
    pub delta_offset_deg: f64,
    /// Its standard deviation.
    pub delta_offset_sd_deg: f64,
    /// Density, kg/m3.
    pub density_kg_m3: f64,
    /// Its standard deviation.
    pub density_sd_kg_m3: f64,
}

/// Gap, soils and predictions of ln force.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// The gap.
    pub gap: Gap,
    /// Soil without effects.
    pub soil_before: FittedSoil,
    /// Soil with effects.
    pub soil_after: FittedSoil,
    /// ln force without effects, by stroke.
    pub before: Vec<f64>,
    /// ln force with effects.
    pub after: Vec<f64>,
    /// ln force without effects, from the other batches.
    pub heldout_before: Option<Vec<f64>>,
    /// ln force with effects, from the other batches.
    pub heldout_after: Option<Vec<f64>>,
    /// Coefficients of a shape without a name and their covariances, if there is one.
    pub(crate) shape: (Vec<f64>, Vec<Vec<f64>>),
    /// Standard deviation of ln force of each stroke about its prediction, batches included.
    pub stroke_sd: Vec<f64>,
    /// The held-out gap by column and condition; empty with fewer than two batches.
    pub parts: Vec<Part>,
}

/// Compares a set of effects (amplitudes fixed) and a shape without a name with none. `None` if a fit fails.
pub(crate) fn compare(full: &FitSetup<'_>, spec: &Spec, amplitudes: &[f64]) -> Option<Comparison> {
    let setup = full.without_model_error();
    let core = setup.core();
    let OnForces { forces, kept, channels } = OnForces::of(&setup, spec, amplitudes);
    let all = everything(&setup);
    let before = fit(&setup, &Spec::default(), &core, true, &all)?;
    let after = fit(&setup, &kept, &channels, true, &all)?;
    let columns = Columns::new(&setup, spec);
    let mut held = None;
    if setup.batch_terms > 1 {
        let n = setup.data.len();
        let mut out = [Held::new(n), Held::new(n)];
        for batch in 0..setup.data.batches {
            let include: Vec<bool> = setup.data.batch.iter().map(|&b| b != batch).collect();
            if include.iter().all(|&i| i) || !include.iter().any(|&i| i) {
                continue;
            }
            let pair = [
                fit(&setup, &Spec::default(), &core, true, &include)?,
                fit(&setup, &forces, &channels, true, &include)?,
            ];
            for (held, fit) in out.iter_mut().zip(&pair) {
                held.take(&setup, fit, &include);
            }
            columns.take(&setup, &pair, &include, &mut out);
        }
        held = Some(out);
    }
    let rms = |ln: &[f64]| {
        let squares = ln.iter().zip(&setup.data.ln_force).map(|(a, b)| (a - b).powi(2));
        (squares.sum::<f64>() / ln.len() as f64).sqrt()
    };
    let chi2_per_n = |held: &Held| {
        let of_forces = held.misses.get(&None).into_iter().flatten().flatten();
        of_forces.map(Miss::squared).sum::<f64>() / setup.data.len() as f64
    };
    let elpd = held.as_ref().map(|[a, b]| {
        let gains: Vec<f64> = b.log_density.iter().zip(&a.log_density).map(|(x, y)| x - y).collect();
        sum_and_error(&gains)
    });
    let gap = Gap {
        before: rms(&before.ln_force),
        after: rms(&after.ln_force),
        heldout_before: held.as_ref().map(|[a, _]| rms(&a.ln_force)),
        heldout_after: held.as_ref().map(|[_, b]| rms(&b.ln_force)),
        chi2_per_n_before: held.as_ref().map(|[a, _]| chi2_per_n(a)),
        chi2_per_n_after: held.as_ref().map(|[_, b]| chi2_per_n(b)),
        delta_elpd: elpd.map(|(sum, _)| sum),
        delta_elpd_se: elpd.map(|(_, se)| se),
    };
    let (heldout_before, heldout_after, parts) = match held {
        Some([a, b]) => (Some(a.ln_force), Some(b.ln_force), parts(setup.data, &a.misses, &b.misses)),
        None => (None, None, Vec::new()),
    };
    let stroke_sd = after.force_sd.iter().map(|s| s.hypot(setup.batch_sd)).collect();
    Some(Comparison {
        gap,
        soil_before: soil(&setup, &before),
        soil_after: soil(&setup, &after),
        before: before.ln_force,
        after: after.ln_force,
        shape: (after.shape, after.shape_covariance),
        heldout_before,
        heldout_after,
        stroke_sd,
        parts,
    })
}

/// What of a set of effects acts on forces.
struct OnForces {
    forces: Spec,
    /// The same with amplitudes that stay as they are.
    kept: Spec,
    /// Columns that a fit of the forces with them has.
    channels: BTreeSet<Channel>,
}

impl OnForces {
    fn of(setup: &FitSetup<'_>, spec: &Spec, amplitudes: &[f64]) -> Self {
        let forces = Spec {
            choices: spec.choices.iter().filter(|choice| choice.effect.acts_on_force()).copied().collect(),
            generic: spec.generic.clone(),
            ..Spec::default()
        };
        let fixed = spec.choices.iter().zip(amplitudes).filter(|(choice, _)| choice.effect.acts_on_force());
        let kept = Spec { fixed: fixed.map(|(_, a)| *a).collect(), ..forces.clone() };
        let mut channels = forces.touched(setup.data);
        channels.extend(&setup.core());
        Self { forces, kept, channels }
    }
}

/// The soil of a fit of forces.
pub(crate) fn soil(setup: &FitSetup<'_>, fit: &Fit) -> FittedSoil {
    let density = setup.data.density.mean * fit.soil[2].exp();
    FittedSoil {
        phi_deg: fit.soil[0],
        phi_sd_deg: fit.soil_sd[0],
        delta_offset_deg: fit.soil[1],
        delta_offset_sd_deg: fit.soil_sd[1],
        density_kg_m3: density,
        density_sd_kg_m3: density * fit.soil_sd[2],
    }
}

/// Predictions of batches that took no part, gathered batch by batch.
struct Held {
    ln_force: Vec<f64>,
    log_density: Vec<f64>,
    misses: Misses,
}

impl Held {
    fn new(n: usize) -> Self {
        Self { ln_force: vec![0.0; n], log_density: Vec::new(), misses: Misses::new() }
    }

    fn take(&mut self, setup: &FitSetup<'_>, fit: &Fit, include: &[bool]) {
        // Strokes of a batch share its scatter: a matrix of rank one on top of a diagonal.
        let shared = setup.batch_sd * setup.batch_sd;
        let (mut sum_w, mut sum_wz, mut sum_wz2, mut ln_det, mut count) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (i, _) in include.iter().enumerate().filter(|(_, inside)| !**inside) {
            self.ln_force[i] = fit.ln_force[i];
            let z = setup.data.ln_force[i] - fit.ln_force[i];
            let variance = fit.force_sd[i].powi(2) + fit.expectation_sd[i].powi(2);
            self.miss(None, i, Miss { residual: z, sd: (variance + shared).sqrt() });
            sum_w += 1.0 / variance;
            sum_wz += z / variance;
            sum_wz2 += z * z / variance;
            ln_det += variance.ln();
            count += 1.0;
        }
        let inner = 1.0 + shared * sum_w;
        let quadratic = sum_wz2 - shared * sum_wz * sum_wz / inner;
        self.log_density.push(-0.5 * (quadratic + ln_det + inner.ln() + count * std::f64::consts::TAU.ln()));
    }

    fn miss(&mut self, channel: Option<Channel>, stroke: usize, miss: Miss) {
        let strokes = self.ln_force.len();
        self.misses.entry(channel).or_insert_with(|| vec![None; strokes])[stroke] = Some(miss);
    }

    fn read(&mut self, fit: &Fit) {
        for reading in &fit.readings {
            let miss = Miss { residual: reading.residual, sd: reading.sd };
            self.miss(Some(reading.channel), reading.stroke, miss);
        }
    }
}

/// Which columns are fitted with what, so that each has a prediction without and with the effects.
struct Columns {
    /// Columns that no fit of forces has without effects.
    alone: BTreeSet<Channel>,
    /// Effects and their columns, if some of them are seen in columns only: those the fit of the forces leaves out.
    joint: Option<(Spec, BTreeSet<Channel>)>,
}

impl Columns {
    fn new(setup: &FitSetup<'_>, spec: &Spec) -> Self {
        let core = setup.core();
        let alone = setup.baselines.keys().filter(|channel| !core.contains(channel)).copied().collect();
        let joint = spec.choices.iter().any(|choice| !choice.effect.acts_on_force()).then(|| {
            let effects = Spec { choices: spec.choices.clone(), ..Spec::default() };
            let mut channels = effects.touched(setup.data);
            if effects.on_force() {
                channels.extend(&core);
            }
            (effects, channels)
        });
        Self { alone, joint }
    }

    /// Predictions of the columns of a batch that took no part, given the fits of the forces. Columns without a fit have none.
    fn take(&self, setup: &FitSetup<'_>, [before, after]: &[Fit; 2], include: &[bool], out: &mut [Held; 2]) {
        let plain = fit(setup, &Spec::default(), &self.alone, false, include);
        for held in out.iter_mut() {
            held.read(before);
            if let Some(plain) = &plain {
                held.read(plain);
            }
        }
        out[1].read(after);
        if let Some((spec, channels)) = &self.joint
            && let Some(joint) = fit(setup, spec, channels, spec.on_force(), include)
        {
            out[1].read(&joint);
        }
    }
}
