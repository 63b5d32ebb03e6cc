//! What a design can show, before any data: the gap that is left after soil and interface are fitted anew.

use nalgebra::{Matrix3, Vector3};
use soilctl_effects::{Active, EffectId};

use crate::learnt::Learnt;
use crate::setup::FitSetup;

/// Expected squared signal-to-noise ratio below which nothing can be named honestly: half of it, 4, is the largest ln Bayes factor that
/// is to be expected, a little more than an effect must earn.
pub const LEAST_LAMBDA: f64 = 8.0;
/// Usual scatter of ln force of one stroke, before data say otherwise; the mean of the prior of the fit.
const USUAL_SCATTER: f64 = 0.06;

/// Whether a design can show an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Testable {
    /// A typical amplitude would be seen.
    Yes,
    /// Only a large one would.
    IfLarge,
    /// Friction angle, density and interface friction take it up.
    Absorbed,
    /// The design does not vary what it depends on.
    NotVaried,
}

impl Testable {
    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Yes => "yes",
            Self::IfLarge => "if large",
            Self::Absorbed => "absorbed by phi, density and delta",
            Self::NotVaried => "not testable with this design",
        }
    }
}

/// Expected signal of an effect in a design.
#[derive(Debug, Clone)]
pub struct Expected {
    /// The effect.
    pub id: EffectId,
    /// Squared signal-to-noise ratio at a typical amplitude.
    pub lambda: f64,
    /// The same at the largest plausible amplitude.
    pub lambda_largest: f64,
    /// The verdict.
    pub testable: Testable,
}

/// Standard deviation of ln force of each stroke: scatter, depth error, density.
pub(crate) fn stroke_sd(setup: &FitSetup<'_>, scatter: Option<f64>) -> Vec<f64> {
    let campaign = &setup.data.campaign;
    setup
        .data
        .rows
        .iter()
        .map(|row| {
            let usual = scatter.unwrap_or(USUAL_SCATTER);
            let force = match row.force_sd_n.map(|sd| sd / row.force_n) {
                Some(own) if setup.data.is_summary() => own,
                Some(own) => own.hypot(usual),
                None => usual,
            };
            let depth = 2.0 * campaign.depth_sd_m / row.depth_m;
            (force * force + depth * depth + campaign.density_sd_rel.powi(2)).sqrt()
        })
        .collect()
}

/// Takes out of a change of ln force what a new friction angle, density and interface friction explain, under their
/// priors. The answer is what is left, by stroke.
pub(crate) fn left_after_soil(
    setup: &FitSetup<'_>,
    phi_deg: f64,
    change: &[f64],
    sd: &[f64],
) -> Option<Vec<f64>> {
    let data = setup.data;
    let known = setup.known_and([]);
    let at = |i: usize, soil: [f64; 3]| setup.ln_force(i, soil, &known);
    let prior_sd = [data.phi.sd, data.delta.sd, data.density.sd];
    let mut soil = [phi_deg, 0.0, 0.0];
    let plain: Vec<f64> = (0..data.len()).map(|i| at(i, soil)).collect::<Option<_>>()?;
    let mut rest = change.to_vec();
    for _ in 0..6 {
        let mut hessian = Matrix3::from_diagonal(&Vector3::from(prior_sd.map(|s| 1.0 / (s * s))));
        let mut gradient = Vector3::new(
            -(soil[0] - phi_deg) / prior_sd[0].powi(2),
            -soil[1] / prior_sd[1].powi(2),
            -soil[2] / prior_sd[2].powi(2),
        );
        for i in 0..data.len() {
            let here = at(i, soil)?;
            rest[i] = plain[i] + change[i] - here;
            let mut row = Vector3::zeros();
            for (k, size) in [0.01, 0.01, 0.001].into_iter().enumerate() {
                let mut moved = soil;
                moved[k] += size;
                row[k] = (at(i, moved)? - here) / size;
            }
            let weight = 1.0 / (sd[i] * sd[i]);
            hessian += row * row.transpose() * weight;
            gradient += row * (weight * rest[i]);
        }
        let step = hessian.cholesky()?.solve(&gradient);
        for k in 0..3 {
            // Far steps leave the angles for which the model answers.
            soil[k] += step[k].clamp(-4.0, 4.0);
        }
    }
    for i in 0..data.len() {
        rest[i] = plain[i] + change[i] - at(i, soil)?;
    }
    Some(rest)
}

/// Change of ln force by an effect, on top of what is known, by stroke.
pub(crate) fn change(setup: &FitSetup<'_>, phi_deg: f64, active: Active) -> Option<Vec<f64>> {
    let (without, with) = (setup.known_and([]), setup.known_and([active]));
    let at = |i: usize, effects: &[Active]| setup.ln_force(i, [phi_deg, 0.0, 0.0], effects);
    (0..setup.data.len()).map(|i| Some(at(i, &with)? - at(i, &without)?)).collect()
}

/// `N (g / s)^2` of a change of ln force, after soil and interface are fitted anew.
pub(crate) fn lambda(setup: &FitSetup<'_>, phi_deg: f64, change: &[f64], sd: &[f64]) -> Option<f64> {
    let rest = left_after_soil(setup, phi_deg, change, sd)?;
    Some(rest.iter().zip(sd).map(|(g, s)| (g / s).powi(2)).sum())
}

/// Expected signal of an effect at an amplitude, in forces and linked channels together.
fn signal(setup: &FitSetup<'_>, phi_deg: f64, id: EffectId, amplitude: f64, sd: &[f64]) -> (f64, f64) {
    let (data, effect) = (setup.data, id.effect());
    let told =
        |shape: &&f64| effect.needs(**shape).is_none_or(|channel| data.channels.contains_key(&channel));
    let (mut most, mut raw) = (0.0_f64, 0.0_f64);
    let learnt = data.learnt.get(&id);
    let simulated = [effect.simulated_shape()];
    let shapes = if learnt.is_some() { &simulated } else { effect.shapes() };
    for &shape in shapes.iter().filter(told) {
        let Some(change) = change(setup, phi_deg, Active { effect, amplitude, shape }) else { continue };
        let mut found = lambda(setup, phi_deg, &change, sd).unwrap_or(0.0);
        for channel in learnt.map_or(effect.linked, Learnt::channels) {
            let Some(cells) = data.channels.get(channel) else { continue };
            let scatter = setup.baselines[channel].ln_scatter.mean.exp();
            let shifts = (0..data.len()).filter(|&i| cells[i].is_some()).map(|i| {
                let formula = || effect.shift(*channel, amplitude, shape, &data.reading(i));
                learnt.map_or_else(formula, |learnt| learnt.shift(*channel, i, amplitude)) / scatter
            });
            found += shifts.map(|x| x * x).sum::<f64>();
        }
        most = most.max(found);
        raw = raw.max(change.iter().zip(sd).map(|(g, s)| (g / s).powi(2)).sum::<f64>());
    }
    (most, raw)
}

/// What a design can show of an effect.
pub(crate) fn expected(setup: &FitSetup<'_>, phi_deg: f64, id: EffectId) -> Expected {
    let sd = stroke_sd(setup, None);
    let range = setup.range(id.effect());
    let both = |size: f64| {
        let signs = range.signs().iter();
        signs
            .map(|sign| signal(setup, phi_deg, id, sign * size, &sd))
            .fold((0.0, 0.0), |a: (f64, f64), b| (a.0.max(b.0), a.1.max(b.1)))
    };
    let (lambda, _) = both(range.typical());
    let (lambda_largest, raw) = both(range.high);
    let testable = if lambda >= LEAST_LAMBDA {
        Testable::Yes
    } else if lambda_largest >= LEAST_LAMBDA {
        Testable::IfLarge
    } else if raw >= LEAST_LAMBDA {
        Testable::Absorbed
    } else {
        Testable::NotVaried
    };
    Expected { id, lambda, lambda_largest, testable }
}
