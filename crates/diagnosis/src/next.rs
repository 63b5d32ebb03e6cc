//! The experiment that would tell most: a menu of follow-ups, and the chance of each to settle what is left.

use soilctl_effects::{Active, Base, Channel, Effect, Reference, Stroke, catalogue, effect, force_n};
use soilctl_soil::units::inches_to_m;
use soilctl_strokes::StrokeRow;

use crate::chi_square;
use crate::data::Data;
use crate::setup::Setup;
use crate::testability::{Expected, LEAST_LAMBDA, left_after_soil, stroke_sd};

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
}

/// Strokes in a preparation.
const BATCH: usize = 6;
/// Most levels of a menu entry that are gone through before the next tool angle.
const LEVELS: usize = 4;
/// Sizes of a follow-up, and the power from which a larger one is not needed.
const STROKES: [usize; 3] = [12, 24, 48];
const ENOUGH: f64 = 0.97;
/// Most explanations that are told apart at a time.
const MOST_RIVALS: usize = 5;

/// What needs a ruler or a look at the sensor in free air, and no trace.
const BY_HAND: [Channel; 3] = [Channel::HeapHeight, Channel::TareBefore, Channel::TareAfter];

/// Standard deviations by which two explanations must differ before one of them is named.
const NEEDED: f64 = 2.9;

struct Menu {
    name: &'static str,
    change: fn(&Data, usize, &mut StrokeRow),
}

fn cycle(values: &[f64], i: usize) -> f64 {
    values[i % values.len()]
}

const MENU: [Menu; 10] = [
    Menu {
        name: "a depth ladder from half the usual depth to one and a half times it",
        change: |data, i, row| row.depth_m = cycle(&[0.5, 1.5, 0.75, 1.25], i) * data.reference.depth_m,
    },
    Menu {
        name: "a second, narrower plate at shallow and deep strokes",
        change: |data, i, row| {
            row.width_m *= if i % 4 < 2 { 0.4 } else { 1.0 };
            row.depth_m = cycle(&[0.6, 1.4], i) * data.reference.depth_m;
        },
    },
    Menu {
        name: "a depth ladder from half the usual depth to one and a half times it, with a narrower plate in every other batch",
        change: |data, i, row| {
            row.width_m *= if (i / BATCH).is_multiple_of(2) { 0.4 } else { 1.0 };
            row.depth_m = cycle(&[0.5, 1.5, 0.75, 1.25], i) * data.reference.depth_m;
        },
    },
    Menu {
        name: "a ladder of speeds over a factor of 16, in random order",
        change: |data, i, row| {
            row.speed_mps =
                Some(cycle(&[1.0, 4.0, 0.25, 4.0, 1.0, 0.25], i) * data.reference.speed_mps.unwrap_or(0.01));
        },
    },
    Menu {
        name: "the same tool angles at 12 in and 17 in, swapped",
        change: |_, i, row| row.radius_m = Some(inches_to_m(if i % 2 == 0 { 12.0 } else { 17.0 })),
    },
    Menu {
        name: "the box turned by 90 deg, strokes over all base angles",
        change: |_, i, row| row.base_deg = Some(cycle(&[-90.0, 0.0, 90.0, -45.0, 45.0, 0.0], i)),
    },
    Menu {
        name: "strokes at set distances from earlier ones: side by side and far apart",
        change: |_, i, row| row.gap_prior_m = Some(cycle(&[0.01, 0.15, 0.03], i)),
    },
    Menu {
        name: "strokes close to a wall and in the middle of the box",
        change: |_, i, row| row.wall_m = Some(cycle(&[0.01, 0.2, 0.04], i)),
    },
    Menu {
        name: "bracketing strokes: the interface friction set 4 deg low, right and 4 deg high",
        change: |data, i, row| {
            row.delta_set_deg = Some((data.delta_set_deg(0) + cycle(&[-4.0, 0.0, 4.0], i)).max(1.0))
        },
    },
    Menu { name: "the first batch once more, at the end", change: |_, _, _| {} },
];

/// Strokes of a menu entry: batches of six made after the campaign.
fn design(data: &Data, entry: &Menu, readings: &[Channel], count: usize) -> Vec<StrokeRow> {
    let last = data.rows.iter().filter_map(|row| row.time_s).fold(0.0, f64::max);
    (0..count)
        .map(|i| {
            let like = &data.rows[(i * 5) % data.len().min(12)];
            let mut row = StrokeRow {
                line: i + 2,
                stroke_id: Some(format!("next{:02}", i + 1)),
                batch: Some(format!("next{}", 1 + i / BATCH)),
                order: Some((i % BATCH) as u32 + 1),
                time_s: data.reference.time_s.map(|_| last + 3600.0 + 300.0 * i as f64),
                // One tool angle further in each round, so that no angle always meets the same level of the menu.
                alpha_deg: data.levels_deg[(i + i / LEVELS) % data.levels_deg.len()],
                depth_m: like.depth_m,
                width_m: like.width_m,
                speed_mps: like.speed_mps,
                radius_m: like.radius_m,
                base_deg: like.base_deg,
                gap_prior_m: like.gap_prior_m,
                wall_m: like.wall_m,
                density_kg_m3: like.density_kg_m3,
                delta_set_deg: like.delta_set_deg,
                force_n: 1.0,
                ..StrokeRow::default()
            };
            (entry.change)(data, i, &mut row);
            readings.iter().for_each(|channel| channel.fill(&mut row, 0.0));
            row
        })
        .collect()
}

/// An effect with its amplitude and shape.
type Explanation = (&'static dyn Effect, f64, f64);

/// The best follow-up for what is left open; `None` if nothing on the menu would tell anything. `fitted` holds amplitude and
/// shape of every effect that was fitted, by id.
pub(crate) fn next(
    setup: &Setup<'_>,
    phi_deg: f64,
    fitted: &[(&'static str, f64, f64)],
    equivalents: &[String],
    expected: &[Expected],
) -> Option<NextExperiment> {
    let data = setup.data;
    let known = |id: &str| -> Option<Explanation> {
        let effect = effect(id)?;
        let shape = effect.shape().map_or(0.0, |shape| shape.values[shape.values.len() / 2]);
        let found = fitted.iter().find(|(of, ..)| *of == id).map(|(_, size, shape)| (*size, *shape));
        let (size, shape) = found.unwrap_or((effect.range().typical(), shape));
        Some((effect, size, shape))
    };
    // What is to be told apart: all explanations that are left, or, if one stands alone, it and nothing; if nothing was
    // found, an effect that this design hides and nothing.
    let on_force = |id: &&String| effect(id).is_some_and(|effect| effect.acts_on_force());
    let rivals: Vec<&String> = equivalents.iter().filter(on_force).take(MOST_RIVALS).collect();
    let (explanations, question): (Vec<Explanation>, String) = match rivals.as_slice() {
        [first, second, ..] => (
            rivals.iter().map(|id| known(id)).collect::<Option<_>>()?,
            format!("tells {first} from {second}{}", if rivals.len() > 2 { " and the others" } else { "" }),
        ),
        [only] => (vec![known(only)?], format!("confirms {only}")),
        [] => {
            let hidden = expected
                .iter()
                .filter(|e| e.lambda < LEAST_LAMBDA)
                .min_by(|a, b| a.lambda.total_cmp(&b.lambda));
            let id = hidden.map_or(catalogue()[0].id(), |e| e.id);
            (vec![known(id)?], format!("would show {id}, which this design hides"))
        }
    };
    let shows = |channel: &Channel| explanations.iter().any(|(effect, ..)| effect.linked().contains(channel));
    let lacking = BY_HAND.into_iter().filter(|channel| !data.channels.contains_key(channel));
    let readings: Vec<Channel> = lacking.filter(shows).collect();
    let names: Vec<&str> = readings.iter().map(|channel| channel.column()).collect();
    let with = if names.is_empty() { String::new() } else { format!(", with {}", names.join(" and ")) };
    let mut best: Option<NextExperiment> = None;
    for count in STROKES {
        for entry in &MENU {
            let rows = design(data, entry, &readings, count);
            let Some(lambda) = told_apart(setup, phi_deg, &explanations, &rows, &readings) else { continue };
            let power = normal_tail(NEEDED - lambda.sqrt());
            if best.as_ref().is_none_or(|b| power > b.power + 1e-6) {
                let text = format!("{}{with}: {question}", entry.name);
                best = Some(NextExperiment { text, rows, readings: readings.clone(), power });
            }
        }
        if best.as_ref().is_some_and(|best| best.power >= ENOUGH) {
            break;
        }
    }
    best
}

/// Least squared signal-to-noise ratio of the difference of two explanations (or of the only one and nothing) in campaign and
/// follow-up together, after the soil has been fitted anew and the rival has taken the amplitude that suits it best. The
/// `readings` of the follow-up tell by their means.
fn told_apart(
    setup: &Setup<'_>,
    phi_deg: f64,
    explanations: &[Explanation],
    follow_up: &[StrokeRow],
    readings: &[Channel],
) -> Option<f64> {
    let mut rows = setup.data.rows.clone();
    rows.extend_from_slice(follow_up);
    let data = Data::new(&setup.data.name, rows, setup.data.campaign.clone()).ok()?;
    let joint = Setup::new(&data, setup.surface, phi_deg);
    let sd = stroke_sd(&joint, None);
    let variance_of_mean = |channel: &Channel| {
        let baseline = &joint.baselines[channel];
        let zero = baseline.terms.first().map_or(0.0, |(_, prior)| prior.sd);
        (2.0 * baseline.ln_scatter.mean).exp() / follow_up.len() as f64 + zero * zero
    };
    let of_means = readings.iter().map(|channel| 1.0 / variance_of_mean(channel));
    let weight: Vec<f64> = sd.iter().map(|s| 1.0 / (s * s)).chain(of_means).collect();
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).zip(&weight).map(|((x, y), w)| x * y * w).sum::<f64>();
    let left = explanations.iter().map(|of| {
        let change = change(&joint, phi_deg, *of, &setup.data.reference)?;
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
    setup: &Setup<'_>,
    (effect, amplitude, shape): Explanation,
    channel: Channel,
    last: usize,
) -> f64 {
    if !effect.linked().contains(&channel) {
        return 0.0;
    }
    let data = setup.data;
    let shift = |i: usize| effect.shift(channel, amplitude, shape, &data.strokes[i], &data.reading(i));
    (data.len() - last..data.len()).map(shift).sum::<f64>() / last as f64
}

/// Change of ln force by an effect, by stroke.
fn change(
    setup: &Setup<'_>,
    phi_deg: f64,
    (effect, amplitude, shape): Explanation,
    reference: &Reference,
) -> Option<Vec<f64>> {
    let data = setup.data;
    data.rows
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let base = Base {
                phi_deg,
                delta_deg: data.delta_set_deg(i),
                density_kg_m3: data.density.mean,
                gravity_m_s2: data.gravity_m_s2,
            };
            let stroke = Stroke::new(row, reference);
            let force =
                |active: &[Active<'_>]| force_n(setup.surface, &stroke, reference, &base, active).ok();
            Some((force(&[Active { effect, amplitude, shape }])? / force(&[])?).ln())
        })
        .collect()
}

/// Probability that a standard normal number exceeds a value.
fn normal_tail(value: f64) -> f64 {
    let both = chi_square::tail(value * value, 1);
    if value >= 0.0 { 0.5 * both } else { 1.0 - 0.5 * both }
}
