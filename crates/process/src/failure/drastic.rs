//! Failures that can't be missed: the force drops, or the plate runs away (section 5.5, figure 5-17).

use std::ops::Range;

use soilctl_stats::{huber, median};

use super::settings::FailureSettings;
use crate::blocks::Blocks;

/// How a drastic failure showed itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sign {
    Drop,
    RunAway,
}

/// Last block before the soil gave way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Break {
    pub(super) block: usize,
    pub(super) sign: Sign,
}

/// The earlier of a drop and a run-away.
pub(super) fn find(blocks: &Blocks, settings: &FailureSettings) -> Option<Break> {
    let drop = drop_at_some_scale(blocks, settings).map(|block| Break { block, sign: Sign::Drop });
    let away = run_away(blocks, settings).map(|block| Break { block, sign: Sign::RunAway });
    match (drop, away) {
        // A plate that runs away in a soil that softens: the peak is the failure, if it comes shortly before.
        (Some(drop), Some(away)) => Some(if away.block < drop.block { away } else { drop }),
        (found, None) | (None, found) => found,
    }
}

/// A fall of the force is one of the soil only while the plate moves on, at this share of its mean speed before at least, or by
/// `LEAST_WAY` depths: at rest the force falls by relaxation, and when the plate is let go.
const LEAST_SPEED: f64 = 0.1;
const LEAST_WAY: f64 = 0.01;
/// Blocks after a fall over which the plate's motion is looked at.
const AFTER: usize = 5;

/// Blocks that are taken together to look for a fall that noise hides in single ones, and the fewest groups.
const SCALES: [usize; 5] = [1, 2, 4, 8, 16];
const FEWEST_GROUPS: usize = 16;

/// A fall of the force in blocks, or else in ever larger groups of them, in which noise is less.
fn drop_at_some_scale(blocks: &Blocks, settings: &FailureSettings) -> Option<usize> {
    SCALES.into_iter().filter(|scale| blocks.t_s.len() >= FEWEST_GROUPS * scale).find_map(|scale| {
        if scale == 1 {
            return drop(blocks, settings);
        }
        let independent = blocks.noise_n / (scale as f64).sqrt();
        let slow = settings.noise.map_or(0.0, |noise| noise.of_mean(scale as f64 * blocks.interval_s()));
        let peak = drop(&blocks.grouped(scale, independent.max(slow)), settings)?;
        let found = steepest(&blocks.f_n, scale * peak.saturating_sub(1)..scale * (peak + 3), scale);
        // A group may reach from the push into the rest.
        moves_on(blocks, found, found + scale, settings).then_some(found)
    })
}

/// The block within a range after which the mean of `width` blocks falls most against the mean of those up to it.
fn steepest(f: &[f64], range: Range<usize>, width: usize) -> usize {
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len().max(1) as f64;
    let fall = |k: usize| {
        mean(&f[(k + 1).saturating_sub(width)..=k]) - mean(&f[k + 1..(k + 1 + width).min(f.len())])
    };
    let inside = range.start..range.end.min(f.len().saturating_sub(1));
    inside.clone().max_by(|a, b| fall(*a).total_cmp(&fall(*b))).unwrap_or(inside.start)
}

/// The highest block from which the force falls by more than noise allows and does not come back, while the plate moves on.
fn drop(blocks: &Blocks, settings: &FailureSettings) -> Option<usize> {
    let f = &blocks.f_n;
    let (mut peak, mut at_rest) = (0, false);
    for (k, &force) in f.iter().enumerate() {
        if force > f[peak] {
            (peak, at_rest) = (k, false);
        }
        if at_rest {
            continue;
        }
        let fall = (settings.drop_rel * f[peak]).max(8.0 * blocks.noise_n);
        if f[peak] - force > fall {
            if !moves_on(blocks, peak, k, settings) {
                at_rest = true;
                continue;
            }
            let later = f[k..].iter().copied().fold(f64::NEG_INFINITY, f64::max);
            // A jump of the encoder throws the force off for a moment; then it climbs on.
            if later < (1.0 + settings.drop_rel / 2.0) * f[peak] {
                return Some(peak);
            }
        }
    }
    None
}

/// Whether the plate goes ahead while the force falls from block `peak` to block `low`.
fn moves_on(blocks: &Blocks, peak: usize, low: usize, settings: &FailureSettings) -> bool {
    let (t, u) = (&blocks.t_s, &blocks.u_m);
    let end = (low + AFTER).min(u.len() - 1);
    let way = u[end] - u[peak];
    let before_s = t[peak] - t[0];
    let usual = if before_s > 0.0 { (u[peak] - u[0]) / before_s } else { 0.0 };
    way > LEAST_WAY * settings.depth_m || (way > 0.0 && way > LEAST_SPEED * usual * (t[end] - t[peak]))
}

/// The first block after which the plate moves much faster than while the force was built up, and the force no
/// longer rises.
fn run_away(blocks: &Blocks, settings: &FailureSettings) -> Option<usize> {
    let (t, u, f) = (&blocks.t_s, &blocks.u_m, &blocks.f_n);
    let least = settings.run_away_rel * settings.depth_m;
    let highest = f.iter().copied().fold(0.0, f64::max);
    let mut speeds: Vec<f64> = Vec::new();
    for k in 8..t.len() {
        let start = t.partition_point(|time| *time < t[k] - settings.run_away_s).min(k - 1);
        let speed = (u[k] - u[start]) / (t[k] - t[start]);
        if u[k] - u[start] > least && f[start] > 0.5 * highest {
            let mut earlier = speeds.clone();
            let usual = median(&mut earlier).max(settings.depth_m * 1e-3);
            if speed > settings.run_away_speed_ratio * usual && f[k] < 1.03 * f[start] {
                // It may still have pushed harder in the beginning of its run.
                return (start..=k).max_by(|a, b| f[*a].total_cmp(&f[*b]));
            }
        }
        speeds.push(speed);
    }
    None
}

/// Up to this noise of a block over the force an eighth of the rise tells the force at the break; beyond, up to so many times more.
const CLEAN: f64 = 0.01;
const MOST_STRETCH: f64 = 3.0;

/// Force at the break and its standard deviation in N: a robust parabola over the blocks that lead up to it, so that
/// the highest of many noisy values isn't taken for the force.
pub(super) fn force_at(blocks: &Blocks, block: usize, settings: &FailureSettings) -> Option<(f64, f64)> {
    // Noise is averaged over more of the rise than a clean curve needs.
    let noise_rel = blocks.noise_n / blocks.f_n.get(block)?.abs().max(f64::MIN_POSITIVE);
    let stretch = (noise_rel / CLEAN).clamp(1.0, MOST_STRETCH);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 6 to 60")]
    let used = ((block / 8) as f64 * stretch).clamp(6.0, 30.0 * stretch.min(2.0)) as usize;
    let first = (block + 1).saturating_sub(used);
    let end = *blocks.t_s.get(block)?;
    let scale = end - blocks.t_s.get(first)?;
    if block + 1 - first < 4 || scale <= 0.0 {
        return Some((*blocks.f_n.get(block)?, blocks.noise_n));
    }
    let rows: Vec<([f64; 3], f64)> = (first..=block)
        .map(|i| {
            let x = (blocks.t_s[i] - end) / scale;
            ([1.0, x, x * x], blocks.f_n[i])
        })
        .collect();
    let (solved, rms) = huber(&rows)?;
    let own_n = rms.max(blocks.noise_n) * solved.inverse[0][0].sqrt();
    // Noise that is slow averages out less than that of independent blocks.
    let slow_n = settings.noise.map_or(0.0, |noise| {
        noise.of_mean(scale)
            * (solved.inverse[0][0] * rows.len() as f64).sqrt().min(1.5 * noise.sd_n / noise.of_mean(scale))
    });
    Some((solved.x[0], own_n.max(slow_n)))
}
