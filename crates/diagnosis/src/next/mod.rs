//! The experiment that would tell most: a menu of follow-ups, and the chance of each to settle what is left.

mod menu;

use menu::{ANGLES, MENU, design};
use soilctl_effects::{Active, Channel, EffectId};
use soilctl_stats::normal_tail;
use soilctl_strokes::StrokeRow;

use crate::data::Data;
use crate::explanation::{Dependence, Explanation};
use crate::setup::FitSetup;
use crate::testability::{Expected, LEAST_LAMBDA, change, left_after_soil, stroke_sd};

/// A proposed follow-up.
#[derive(Debug, Clone)]
pub struct NextExperiment {
    /// What to do and why.
    pub text: String,
    /// Strokes to make, as further batches of the campaign; forces are placeholders, and so are `readings`.
    pub rows: Vec<StrokeRow>,
    /// What to read by hand with each stroke, which the campaign lacks.
    pub readings: Vec<Channel>,
    /// Chance that it settles the question.
    pub power: f64,
    /// Whether a plan of the arm can say it.
    pub by_plan: bool,
}

/// Sizes of a follow-up (two, four and eight preparations), and the power from which a larger one is not needed. Empirical.
const STROKES: [usize; 3] = [12, 24, 48];
const ENOUGH: f64 = 0.97;
/// To look for what may not be there: a chance that is not worth the sand, and one that is. Empirical.
const LEAST_POWER: f64 = 0.2;
const FAIR_POWER: f64 = 0.5;
/// Most explanations that are told apart at a time, for time grows with the square.
const MOST_RIVALS: usize = 5;

/// What needs a ruler or a look at the sensor in free air, and no trace.
const BY_HAND: [Channel; 3] = [Channel::HeapHeight, Channel::TareBefore, Channel::TareAfter];

/// Standard deviations by which two explanations must differ before one of them is named: half the square, 4.2, is the ln Bayes
/// factor that an effect must earn (3.6) and what the range of its amplitude costs it. Empirical.
const NEEDED: f64 = 2.9;

/// What a campaign has told so far.
pub(crate) struct Found<'a> {
    /// Every effect that was fitted; the first one of an effect counts.
    pub(crate) fitted: &'a [Active],
    /// Scatter of ln force of one stroke.
    pub(crate) scatter: f64,
    /// What a shape without a name depends on and its ln Bayes factor, if that is what is left.
    pub(crate) shape: Option<(Dependence, f64)>,
}

/// The best follow-up for what is left open; `None` if nothing on the menu would tell much.
pub(crate) fn next(
    setup: &FitSetup<'_>,
    phi_deg: f64,
    Found { fitted, scatter, shape }: Found<'_>,
    equivalents: &[Explanation],
    expected: &[Expected],
) -> Option<NextExperiment> {
    let data = setup.data;
    if let (Some((over, log_bayes)), Some(Explanation::Unknown(_))) = (shape, equivalents.first()) {
        return more_of(data, over, log_bayes);
    }
    let typical = |id: EffectId| {
        let (effect, shapes) = (id.effect(), id.effect().shapes());
        Active { effect, amplitude: setup.range(effect).typical(), shape: shapes[shapes.len() / 2] }
    };
    let known = |id: EffectId| {
        let found = fitted.iter().find(|of| of.effect.id == id);
        found.copied().unwrap_or_else(|| typical(id))
    };
    let best = |explanations: &[Active], question: &str| {
        best_on_menu(setup, (phi_deg, scatter), explanations, question)
    };
    // What is to be told apart: all explanations that are left, or, if one stands alone, it and nothing; if nothing was
    // found, an effect that this design hides and nothing.
    let on_force = |id: &EffectId| id.effect().acts_on_force();
    let effects = equivalents.iter().filter_map(|explanation| match explanation {
        Explanation::Effect(id) => Some(*id),
        Explanation::Unknown(_) => None,
    });
    let rivals: Vec<EffectId> = effects.filter(on_force).take(MOST_RIVALS).collect();
    match rivals[..] {
        [first, second, ..] => {
            let explanations: Vec<Active> = rivals.iter().map(|id| known(*id)).collect();
            let others = if rivals.len() > 2 { " and the others" } else { "" };
            best(&explanations, &format!("tells {first} from {second}{others}"))
        }
        [only] => best(&[known(only)], &format!("confirms {only}")),
        [] => {
            // One that forces show: what hides for want of a trace is in no follow-up of this menu.
            let mut hidden: Vec<&Expected> =
                expected.iter().filter(|e| e.lambda < LEAST_LAMBDA && on_force(&e.id)).collect();
            hidden.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
            let mut found: Option<NextExperiment> = None;
            for of in hidden {
                let question = format!("would show {}, which this design hides", of.id);
                let next = best(&[typical(of.id)], &question);
                if next.as_ref().map_or(0.0, |next| next.power)
                    > found.as_ref().map_or(LEAST_POWER, |found| found.power)
                {
                    found = next;
                }
                if found.as_ref().is_some_and(|found| found.power >= FAIR_POWER) {
                    break;
                }
            }
            found
        }
    }
}

/// The follow-up of the menu that tells explanations apart best, the smaller one if that is enough.
fn best_on_menu(
    setup: &FitSetup<'_>,
    soil: (f64, f64),
    explanations: &[Active],
    question: &str,
) -> Option<NextExperiment> {
    let data = setup.data;
    let shows = |channel: &Channel| explanations.iter().any(|of| of.effect.linked.contains(channel));
    // Neither a simulated arm nor a log of the real one has what is read by hand.
    let by_hand = BY_HAND.into_iter().filter(|_| !data.is_compared());
    let lacking = by_hand.filter(|channel| !data.channels.contains_key(channel));
    let readings: Vec<Channel> = lacking.filter(shows).collect();
    let names: Vec<&str> = readings.iter().map(|channel| channel.column()).collect();
    let with = if names.is_empty() { String::new() } else { format!(", with {}", names.join(" and ")) };
    let mut best: Option<NextExperiment> = None;
    for count in STROKES {
        // Who has a simulated arm beside the real one has a plan that both can run.
        for entry in MENU.iter().filter(|entry| entry.by_plan || !data.is_compared()) {
            let rows = design(data, entry, &readings, count);
            let Some(lambda) = separation(setup, soil, explanations, &rows, &readings) else { continue };
            let power = normal_tail(NEEDED - lambda.sqrt());
            if best.as_ref().is_none_or(|b| power > b.power + 1e-6) {
                let doubt = if power < LEAST_POWER { ", though it will hardly settle it" } else { "" };
                let text = format!("{}{with}: {question}{doubt}", entry.name);
                best = Some(NextExperiment {
                    text,
                    rows,
                    readings: readings.clone(),
                    power,
                    by_plan: entry.by_plan,
                });
            }
        }
        if best.as_ref().is_some_and(|best| best.power >= ENOUGH) {
            break;
        }
    }
    best
}

/// More strokes along what a shape without a name depends on. Its signal grows with the strokes, at the least as it did so far.
fn more_of(data: &Data, over: Dependence, log_bayes: f64) -> Option<NextExperiment> {
    let entry = [Some(over.on), over.times]
        .into_iter()
        .flatten()
        .find_map(|on| MENU.iter().chain([&ANGLES]).find(|entry| entry.covariates.contains(&on)))?;
    let power = |count: usize| {
        let lambda = 2.0 * log_bayes.max(0.0) * count as f64 / data.len() as f64;
        normal_tail(NEEDED - lambda.sqrt())
    };
    let count = STROKES.into_iter().find(|count| power(*count) >= ENOUGH).unwrap_or(STROKES[2]);
    let text =
        format!("{}: shows what depends on {over}, which no effect of the catalogue explains", entry.name);
    Some(NextExperiment {
        text,
        rows: design(data, entry, &[], count),
        readings: Vec::new(),
        power: power(count),
        by_plan: entry.by_plan,
    })
}

/// Least squared signal-to-noise ratio of the difference of two explanations (or of the only one and nothing) in campaign and
/// follow-up together, after the soil has been fitted anew and the rival has taken the amplitude that suits it best. The
/// `readings` of the follow-up tell by their means.
fn separation(
    setup: &FitSetup<'_>,
    (phi_deg, scatter): (f64, f64),
    explanations: &[Active],
    follow_up: &[StrokeRow],
    readings: &[Channel],
) -> Option<f64> {
    let mut rows = setup.data.rows.clone();
    rows.extend_from_slice(follow_up);
    let mut data = Data::new(&setup.data.name, rows, setup.data.campaign.clone()).ok()?;
    data.refer_to(setup.data.reference.clone());
    data.gravity_m_s2 = setup.data.gravity_m_s2;
    data.known.clone_from(&setup.data.known);
    let joint = FitSetup::new(&data, setup.surface, phi_deg);
    let sd = stroke_sd(&joint, Some(scatter));
    let variance_of_mean = |channel: &Channel| {
        let baseline = &joint.baselines[channel];
        let zero = baseline.terms.first().map_or(0.0, |(_, prior)| prior.sd);
        (2.0 * baseline.ln_scatter.mean).exp() / follow_up.len() as f64 + zero * zero
    };
    let of_means = readings.iter().map(|channel| 1.0 / variance_of_mean(channel));
    let weight: Vec<f64> = sd.iter().map(|s| 1.0 / (s * s)).chain(of_means).collect();
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).zip(&weight).map(|((x, y), w)| x * y * w).sum::<f64>();
    let left = explanations.iter().map(|of| {
        let change = change(&joint, phi_deg, *of)?;
        let mut left = left_after_soil(&joint, phi_deg, &change, &sd)?;
        left.extend(readings.iter().map(|channel| mean_shift(&joint, *of, *channel, follow_up.len())));
        Some(left)
    });
    let left: Vec<Vec<f64>> = left.collect::<Option<_>>()?;
    if let [only] = left.as_slice() {
        return Some(dot(only, only));
    }
    let mut least = f64::INFINITY;
    for (i, a) in left.iter().enumerate() {
        for (j, b) in left.iter().enumerate() {
            let of_b = dot(b, b);
            if i != j && of_b > 0.0 {
                least = least.min((dot(a, a) - dot(a, b).powi(2) / of_b).max(0.0));
            }
        }
    }
    least.is_finite().then_some(least)
}

/// Mean shift of a channel by an effect in the last strokes.
fn mean_shift(
    setup: &FitSetup<'_>,
    Active { effect, amplitude, shape }: Active,
    channel: Channel,
    last: usize,
) -> f64 {
    if !effect.linked.contains(&channel) {
        return 0.0;
    }
    let data = setup.data;
    let shift = |i: usize| effect.shift(channel, amplitude, shape, &data.reading(i));
    (data.len() - last..data.len()).map(shift).sum::<f64>() / last as f64
}
