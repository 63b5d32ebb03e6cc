//! Where a rise ends: samples of it follow a falling line, and from some sample on there is nothing but noise.

use soilctl_stats::least_squares;

use super::lines::Noise;

/// Quiet samples in a row that end a rise.
const QUIET: usize = 3;
/// Part of the highest rise from which on the fall to the edge counts.
const FALL: f64 = 0.5;
/// How far beyond half of the highest rise its edge is looked for at least, over the way from the peak to there; a straight side has 1.
const FOOT: f64 = 2.0;
/// The highest rise must be this many times what counts, so that half of it does.
const CLEAR: f64 = 2.0;
/// Samples before the last that count at least.
const TOP: usize = 4;
/// Places between two samples where the edge may be.
const PLACES: usize = 4;

/// Why it cannot be said where the ground broke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoBreak {
    /// Nothing near the plate rises out of the noise.
    NoRise {
        /// The highest rise within the plate's width of its face, in m.
        most_m: f64,
        /// What it would have to be, in m.
        needed_m: f64,
    },
    /// It rises, but by too little to see where the rise ends.
    Faint {
        /// The highest rise, in m.
        most_m: f64,
        /// What it would have to be, in m.
        needed_m: f64,
    },
    /// The rise goes on to where the map ends.
    OffMap,
    /// The edge is where the ground was not seen.
    Hidden,
}

/// The end of a rise, in steps between samples; a sample stands in the middle of its step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge {
    pub(super) at: f64,
    /// Standard deviation by noise.
    pub(super) sd: f64,
    /// How steeply the rise ends, in m a step.
    pub(super) fall: f64,
    /// Where the ground rises once more.
    pub(super) again: Option<f64>,
}

/// Finds the end of the rise that begins within `near` steps of the plate.
///
/// For each place where the rise may end, a step, a slope and a hollow foot, each or all of them, are fitted to the samples from half of the highest
/// rise up to it; those after it have nothing. How much worse one place fits than another, in units of the noise, is how much less it counts; the
/// edge is their mean. So the foot of a slope is not looked for where it leaves the noise, which is too early, and how flat it may be is in
/// the standard deviation.
pub(super) fn find(
    rise_m: &[Option<f64>],
    noise: Noise,
    deviations: f64,
    near: f64,
) -> Result<Edge, NoBreak> {
    let least = deviations * noise.sd_m;
    let is_up = |i: usize| rise_m.get(i).copied().flatten().is_some_and(|rise| rise > least);
    let first = (0..rise_m.len())
        .find(|&i| (i as f64) <= near.max(3.0) && is_up(i) && (is_up(i + 1) || is_up(i + 2)));
    let Some(first) = first else {
        let close = rise_m.iter().take(near as usize + 1).copied().flatten();
        return Err(NoBreak::NoRise { most_m: close.fold(0.0, f64::max), needed_m: least });
    };
    let mut last = first;
    while let Some(next) = (last + 1..=last + QUIET).find(|&i| is_up(i)) {
        last = next;
    }
    let quiet = last + 1..last + 1 + QUIET;
    if quiet.end > rise_m.len() {
        return Err(NoBreak::OffMap);
    }
    if quiet.clone().filter(|&i| rise_m[i].is_none()).count() > 1 {
        return Err(NoBreak::Hidden);
    }
    let again = (quiet.end..rise_m.len()).find(|&i| (i..i + QUIET).all(is_up));
    let value = |i: usize| rise_m.get(i).copied().flatten();
    let (peak, most) = (first..=last)
        .filter_map(|i| Some((i, value(i)?)))
        .fold((first, 0.0), |best, here| if here.1 > best.1 { here } else { best });
    if most < CLEAR * least {
        return Err(NoBreak::Faint { most_m: most, needed_m: CLEAR * least });
    }
    let top =
        (first..=last).rev().find(|&i| value(i).is_some_and(|rise| rise >= FALL * most)).unwrap_or(first);
    // Below the noise a straight side goes on as far as it came from its peak.
    let foot = top + (FOOT * (top - peak) as f64).ceil() as usize;
    let end = foot.max(last + QUIET.max(last - top + 1));
    let end = end.min(again.map_or(rise_m.len(), |again| again - 1) - 1);
    // A fall within a sample or two is a step, of whose top some samples are needed.
    let top = top.min(last.saturating_sub(TOP)).max(first);
    let samples: Vec<(f64, f64)> = (top..=end).filter_map(|i| Some((i as f64 + 0.5, value(i)?))).collect();
    let places = (end - top) * PLACES;
    let fits: Vec<Fit> =
        (0..places).map(|i| Fit::of(&samples, top as f64 + 0.5 + (i as f64 + 0.5) / PLACES as f64)).collect();
    let best = fits.iter().fold(f64::INFINITY, |best, fit| best.min(fit.squares));
    // A heap of another shape is worse than noise, and then tells as much less.
    let misfit = best / (samples.len().saturating_sub(4)).max(1) as f64;
    let variance = (noise.sd_m * noise.sd_m * noise.clumping).max(misfit);
    let (mut sum, mut at, mut square, mut fall) = (0.0, 0.0, 0.0, 0.0);
    for fit in &fits {
        let weight = libm::exp(0.5 * (best - fit.squares) / variance);
        sum += weight;
        at += weight * fit.at;
        square += weight * fit.at * fit.at;
        fall += weight * fit.fall;
    }
    let at = at / sum;
    let sd = (square / sum - at * at).max(0.0).sqrt();
    Ok(Edge { at, sd, fall: fall / sum, again: again.map(|i| i as f64 + 0.5) })
}

/// What a rise is if it ends at a place.
struct Fit {
    at: f64,
    /// Mean fall over the last step.
    fall: f64,
    squares: f64,
}

impl Fit {
    /// Least squares of a step, a slope and a hollow foot, none of them below nothing: over each choice of them the unbounded solution, the best
    /// of those that are allowed.
    fn of(samples: &[(f64, f64)], edge: f64) -> Self {
        let inside: Vec<([f64; 3], f64)> = samples
            .iter()
            .filter(|(at, _)| *at < edge)
            .map(|(at, rise)| ([1.0, edge - at, (edge - at).powi(2)], *rise))
            .collect();
        let outside: f64 = samples.iter().filter(|(at, _)| *at >= edge).map(|(_, rise)| rise * rise).sum();
        let mut found = Self { at: edge, fall: 0.0, squares: f64::INFINITY };
        for choice in 0..8_u8 {
            let is_chosen = |part: usize| choice & (1 << part) != 0;
            let rows = inside.iter().map(|(row, rise)| {
                let mut of = *row;
                (0..3).filter(|part| !is_chosen(*part)).for_each(|part| of[part] = 0.0);
                (of, *rise, 1.0)
            });
            // A part that is left out gets a row of its own that says so.
            let left_out = (0..3).filter(|part| !is_chosen(*part)).map(|part| {
                let mut row = [0.0; 3];
                row[part] = 1.0;
                (row, 0.0, 1.0)
            });
            let Some(solved) = least_squares(rows.chain(left_out)) else { continue };
            if solved.x.iter().any(|part| *part < 0.0) {
                continue;
            }
            let rise_at = |row: &[f64; 3]| row.iter().zip(&solved.x).map(|(a, b)| a * b).sum::<f64>();
            let squares =
                outside + inside.iter().map(|(row, rise)| (rise - rise_at(row)).powi(2)).sum::<f64>();
            if squares < found.squares {
                found = Self { at: edge, fall: solved.x.iter().sum(), squares };
            }
        }
        found
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    const QUIET_GROUND: Noise = Noise { sd_m: 1e-4, clumping: 1.0 };

    fn profile(rise: impl Fn(f64) -> f64) -> Vec<Option<f64>> {
        (0..60).map(|i| Some(rise(f64::from(i) + 0.5))).collect()
    }

    #[test]
    fn the_foot_of_a_slope_and_the_place_of_a_step() {
        let foot = find(&profile(|x| (0.02 - 1e-3 * x).max(0.0)), QUIET_GROUND, 3.0, 10.0).unwrap();
        assert!((foot.at - 20.0).abs() < 0.3 && foot.sd < 0.3, "{foot:?}");
        assert!((foot.fall - 1e-3).abs() < 3e-4 && foot.again.is_none());
        let step = find(&profile(|x| if x < 17.3 { 0.004 } else { 0.0 }), QUIET_GROUND, 3.0, 10.0).unwrap();
        assert!((step.at - 17.0).abs() < 0.1 && step.sd < 0.4, "{step:?}");
    }

    #[test]
    fn what_cannot_be_said_is_not() {
        let no = |rise: &[Option<f64>]| find(rise, QUIET_GROUND, 3.0, 10.0).unwrap_err();
        let flat = profile(|_| 2e-4);
        assert!(
            matches!(no(&flat), NoBreak::NoRise { most_m: 2e-4, needed_m } if (needed_m - 3e-4).abs() < 1e-12)
        );
        assert_eq!(no(&profile(|_| 1e-2)), NoBreak::OffMap);
        assert!(matches!(no(&profile(|x| if x < 15.0 { 5e-4 } else { 0.0 })), NoBreak::Faint { .. }));
        let mut hidden = profile(|x| if x < 15.0 { 1e-2 } else { 0.0 });
        hidden[14..20].fill(None);
        assert_eq!(no(&hidden), NoBreak::Hidden);
        // Far from the plate, it is not the plate's.
        assert!(matches!(no(&profile(|x| if x > 30.0 { 1e-2 } else { 0.0 })), NoBreak::NoRise { .. }));
        assert!(matches!(no(&[]), NoBreak::NoRise { .. }));
    }

    #[test]
    fn a_second_rise_is_told() {
        let twice = profile(|x| if x < 12.0 || (30.0..40.0).contains(&x) { 5e-3 } else { 0.0 });
        let edge = find(&twice, QUIET_GROUND, 3.0, 10.0).unwrap();
        assert!((edge.at - 12.0).abs() < 0.1);
        assert_eq!(edge.again, Some(30.5));
    }
}
