//! What a design can show, before any data: the gap that is left after soil and interface are fitted anew.

use nalgebra::{Matrix3, Vector3};
use soilctl_effects::{Active, EffectId};

use crate::fit::Background;
use crate::learnt::Learnt;
use crate::setup::FitSetup;
use crate::spec::{Choice, Spec};

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
    /// Only columns show it, and what these may be off by without it takes it up.
    Masked,
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
            Self::Masked => "masked by what the instrument and the simulated arm may be off by",
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

/// Squared signal-to-noise ratios of an effect.
#[derive(Debug, Clone, Copy, Default)]
struct Signal {
    /// After everything that a fit moves is fitted anew.
    left: f64,
    /// Before, in forces and in all readings.
    force: f64,
    all: f64,
}

impl Signal {
    fn most(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            force: self.force.max(other.force),
            all: self.all.max(other.all),
        }
    }
}

/// Expected signal of an effect at an amplitude: in forces alone, or in all readings if these tell more.
fn signal(
    setup: &FitSetup<'_>,
    background: Option<&Background<'_>>,
    phi_deg: f64,
    id: EffectId,
    amplitude: f64,
    sd: &[f64],
) -> Signal {
    let (data, effect) = (setup.data, id.effect());
    let told =
        |shape: &&f64| effect.needs(**shape).is_none_or(|channel| data.channels.contains_key(&channel));
    let learnt = data.learnt.get(&id);
    let simulated = [effect.simulated_shape()];
    let shapes = if learnt.is_some() { &simulated } else { effect.shapes() };
    let shows = learnt.map_or(effect.linked, Learnt::channels);
    let of = |shape: f64| {
        let change = change(setup, phi_deg, Active { effect, amplitude, shape });
        let force = change.map_or_else(Signal::default, |change| {
            let force = change.iter().zip(sd).map(|(g, s)| (g / s).powi(2)).sum();
            Signal { left: lambda(setup, phi_deg, &change, sd).unwrap_or(0.0), force, all: force }
        });
        let sign = amplitude.signum();
        let choice = Choice { effect, sign, shape, linked: true, responds: false, learnt: learnt.is_some() };
        let together = background
            .filter(|background| background.has_any(shows))
            .and_then(|background| background.lambda(&choice, amplitude));
        let all = together.map(|(left, all)| Signal { left, all, force: 0.0 });
        force.most(all.unwrap_or_default())
    };
    shapes.iter().filter(told).map(|shape| of(*shape)).fold(Signal::default(), Signal::most)
}

/// What a design can show of effects.
pub(crate) fn expected(
    setup: &FitSetup<'_>,
    phi_deg: f64,
    ids: impl Iterator<Item = EffectId>,
) -> Vec<Expected> {
    let nothing = Spec::default();
    let background = Background::new(setup, &nothing, phi_deg);
    let sd = stroke_sd(setup, None);
    let of = |id: EffectId| {
        let range = setup.range(id.effect());
        let both = |size: f64| {
            let signs = range.signs().iter();
            signs
                .map(|sign| signal(setup, background.as_ref(), phi_deg, id, sign * size, &sd))
                .fold(Signal::default(), Signal::most)
        };
        let (typical, largest) = (both(range.typical()), both(range.high));
        let testable = if typical.left >= LEAST_LAMBDA {
            Testable::Yes
        } else if largest.left >= LEAST_LAMBDA {
            Testable::IfLarge
        } else if largest.force >= LEAST_LAMBDA {
            Testable::Absorbed
        } else if largest.all >= LEAST_LAMBDA {
            Testable::Masked
        } else {
            Testable::NotVaried
        };
        Expected { id, lambda: typical.left, lambda_largest: largest.left, testable }
    };
    ids.map(of).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]

    use soilctl_earth_pressure::model;
    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;
    use crate::data::Data;
    use crate::surface::Surface;

    /// Play `a` of the drives is a constant in their gap. With N strokes of one force F, a gap that scatters by s, a zero that is known to b and a
    /// stretch known to 1 / k, what all strokes share is known to `v = b² + (F / k)² + s² / N`, and lambda is `a² / v`: by hand, without a fit.
    #[test]
    fn a_constant_in_a_column_stands_out_by_what_its_zero_is_known_to() {
        let (n, force_n) = (16_usize, 5.0);
        let row = |i: usize| StrokeRow {
            alpha_deg: 90.0,
            depth_m: 0.02,
            width_m: 0.1,
            force_n,
            motor_ext_gap_m: Some(if i.is_multiple_of(2) { 1e-4 } else { -1e-4 }),
            ..StrokeRow::default()
        };
        let campaign = Campaign::default();
        let data = Data::new("test", (0..n).map(row).collect(), campaign.clone()).unwrap();
        let surface = Surface::new(model("chen").unwrap(), (90.0, 90.0)).unwrap();
        let setup = FitSetup::new(&data, &surface, 35.0);
        let found = expected(&setup, 35.0, [EffectId::Backlash].into_iter());
        let instrument = &campaign.instrument;
        let known = (0.25 * instrument.gap_sd).max(6e-5).hypot(force_n / instrument.joint_stiffness_n_per_m);
        let variance = known * known + instrument.gap_sd.powi(2) / n as f64;
        let range = EffectId::Backlash.effect().range;
        for (lambda, amplitude) in [(found[0].lambda, range.typical()), (found[0].lambda_largest, range.high)]
        {
            let by_hand = amplitude * amplitude / variance;
            assert!((lambda / by_hand - 1.0).abs() < 1e-9, "{lambda} {by_hand}");
        }
        // However many strokes there are, a zero that is known to half a millimetre hides play of as much.
        let many = Data::new("test", (0..400).map(row).collect(), campaign).unwrap();
        let setup = FitSetup::new(&many, &surface, 35.0);
        let found = expected(&setup, 35.0, [EffectId::Backlash].into_iter());
        assert_eq!(found[0].testable, Testable::Masked, "{found:?}");
    }
}
