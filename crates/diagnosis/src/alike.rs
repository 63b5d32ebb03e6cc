//! Two simulated arms of one campaign, and what of their difference is chance.

use std::collections::BTreeMap;

use soilctl_effects::Channel;
use soilctl_stats::median;

use crate::channels::{reads_delta, spread};
use crate::data::Data;
use crate::transfer::kept;

/// Depths of two strokes, relative to the lesser, from which they tell how a difference goes with the depth.
const LEAST_APART: f64 = 0.05;

/// By how many standard deviations of chance a stroke that goes another way on one arm than on another differs from the others of its kind. Empirical.
const ASTRAY: f64 = 6.0;

/// What one arm expects of a signal beyond another one, by stroke.
struct Beyond {
    /// What strokes of a kind share, and what goes with their depth.
    shared: Vec<f64>,
    /// What each has beyond that; 0 of those that tell nothing.
    left: Vec<f64>,
    /// Share of it that is more than chance.
    own: f64,
    /// Variance of chance.
    chance: f64,
}

impl Beyond {
    /// Whether a stroke goes another way.
    fn is_astray(&self, stroke: usize) -> bool {
        self.chance > 0.0 && self.left[stroke].powi(2) > ASTRAY * ASTRAY * self.chance
    }

    fn of(&self, stroke: usize) -> f64 {
        self.shared[stroke] + self.own * self.left[stroke]
    }
}

impl Data {
    /// Takes chance out of what is expected beyond what `base` expects, the same strokes beside another simulated arm: two arms made by themselves would
    /// each have its own, which is as much as small effects are. Strokes of one kind (tool angle and radius) differ by their median and with their
    /// depth, and each by what it has beyond, drawn to nothing by the share of its square that is to be expected of strokes that go their own way.
    /// Where one of a kind goes another way than the others (its column jumps, or it slips, which all columns show), what each has beyond is no
    /// expectation, but a measure of how they scatter on this arm.
    pub fn expect_as(&mut self, base: &Self) {
        let told_by: Vec<bool> = self.made.iter().zip(&base.made).map(|(a, b)| *a && *b).collect();
        let mut signals: BTreeMap<Option<Channel>, (Beyond, &Vec<f64>)> = BTreeMap::new();
        let columns = self
            .expected
            .iter()
            .map(|(channel, values)| (Some(*channel), Some(values), base.expected.get(channel)));
        for (signal, values, theirs) in columns.chain([(None, self.scene.as_ref(), base.scene.as_ref())]) {
            let Some((values, theirs)) = values.zip(theirs) else { continue };
            let chance = self.unsteadiness.mean_variance(signal);
            signals.insert(signal, (self.beyond(values, theirs, &told_by, chance), theirs));
        }
        let slips = |i: usize| {
            signals.iter().any(|(signal, (of, _))| signal.is_some_and(reads_delta) && of.is_astray(i))
        };
        let kinds: Vec<Vec<usize>> = (0..self.len()).map(|i| self.kind(i)).collect();
        let slip: Vec<bool> = kinds.iter().map(|kind| kind.iter().any(|i| slips(*i))).collect();
        for (signal, (of, theirs)) in signals {
            let mut expected = Vec::new();
            for (i, theirs) in theirs.iter().enumerate() {
                let told: Vec<f64> =
                    kinds[i].iter().filter(|j| told_by[**j]).map(|j| of.left[*j].powi(2)).collect();
                let astray = slip[i] || kinds[i].iter().any(|j| of.is_astray(*j));
                if astray && !told.is_empty() {
                    let scatter = told.iter().sum::<f64>() / told.len() as f64;
                    self.unsteadiness.widen(signal, i, scatter);
                    expected.push(theirs + of.shared[i]);
                } else {
                    expected.push(theirs + of.of(i));
                }
            }
            match signal {
                Some(channel) => drop(self.expected.insert(channel, expected)),
                None => self.scene = Some(expected),
            }
        }
    }

    /// What of `values` beyond `theirs` is no chance, of which a difference has this variance, as told by some of the strokes. One that went another way
    /// tells nothing of the others of its kind: medians.
    fn beyond(&self, values: &[f64], theirs: &[f64], told_by: &[bool], variance: f64) -> Beyond {
        let beyond: Vec<f64> = values.iter().zip(theirs).map(|(a, b)| a - b).collect();
        let depth = |i: usize| self.rows[i].depth_m;
        let told: Vec<usize> = (0..beyond.len()).filter(|&i| told_by[i]).collect();
        let like = |i: usize| -> Vec<usize> {
            let of: Vec<usize> = self.kind(i).into_iter().filter(|&j| told_by[j]).collect();
            if of.is_empty() { told.clone() } else { of }
        };
        // Over the depth: the median slope of pairs of a kind (Theil & Sen).
        let apart = |i: usize, j: usize| depth(j) - depth(i);
        let mut slopes: Vec<f64> = told
            .iter()
            .flat_map(|&i| like(i).into_iter().map(move |j| (i, j)))
            .filter(|&(i, j)| apart(i, j) > LEAST_APART * depth(i))
            .map(|(i, j)| (beyond[j] - beyond[i]) / apart(i, j))
            .collect();
        let slope = if slopes.is_empty() { 0.0 } else { median(&mut slopes) };
        let level = |i: usize| -> f64 {
            let mut levels: Vec<f64> = like(i).into_iter().map(|j| beyond[j] - slope * depth(j)).collect();
            if levels.is_empty() { 0.0 } else { median(&mut levels) }
        };
        let shared: Vec<f64> = (0..beyond.len()).map(|i| level(i) + slope * depth(i)).collect();
        let of_told: Vec<f64> = told.iter().map(|&i| beyond[i] - shared[i]).collect();
        let own = kept(spread(&of_told).powi(2), variance);
        let mut left = vec![0.0; beyond.len()];
        told.iter().zip(of_told).for_each(|(&i, of)| left[i] = of);
        Beyond { shared, left, own, chance: variance }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    /// Six strokes at each of two tool angles: what differs by kind and depth stays as it is, what is no more than chance goes, and one stroke that goes
    /// another way changes no other one. One that says nothing takes what its kind says.
    #[test]
    fn what_kinds_and_depths_do_is_no_chance() {
        let row = |i: usize| StrokeRow {
            alpha_deg: if i < 6 { 90.0 } else { 80.0 },
            depth_m: [0.02, 0.02, 0.02, 0.03, 0.03, 0.03][i % 6],
            width_m: 0.1,
            force_n: 5.0,
            ..StrokeRow::default()
        };
        let data = Data::new("t", (0..12).map(row).collect(), Campaign::default()).unwrap();
        let theirs: Vec<f64> = (0..12).map(|i| 0.3 * f64::from(i)).collect();
        let real = |i: usize| if i < 6 { 2.0 } else { -1.0 } + 400.0 * (data.rows[i].depth_m - 0.025);
        let chance = |i: usize| [0.0, 1.0, -1.0][i % 3];
        let smooth = |own: &dyn Fn(usize) -> f64, told_by: &[bool], variance: f64| -> Vec<f64> {
            let values: Vec<f64> = (0..12).map(|i| theirs[i] + real(i) + own(i)).collect();
            let beyond = data.beyond(&values, &theirs, told_by, variance);
            (0..12).map(|i| beyond.of(i)).collect()
        };
        let near = |found: &[f64], expected: &dyn Fn(usize) -> f64| {
            found.iter().enumerate().all(|(i, found)| (found - expected(i)).abs() < 1e-12)
        };
        let all = [true; 12];
        assert!(near(&smooth(&chance, &all, 0.0), &|i| real(i) + chance(i)));
        assert!(near(&smooth(&chance, &all, 3.0), &real));
        // Half of chance's variance is 1.4826 ** 2 / 2 here, by the median of the sizes 0, 1 and 1.
        assert!(near(&smooth(&chance, &all, 0.5 * 1.4826_f64.powi(2)), &|i| real(i) + 0.5 * chance(i)));
        let astray = |i: usize| if i == 1 { 90.0 } else { 0.0 };
        assert!(near(&smooth(&astray, &all, 1.0), &real));
        let mut told_by = all;
        told_by[1] = false;
        assert!(near(&smooth(&astray, &told_by, 0.0), &real));
    }

    /// A kind of which one stroke slips otherwise is expected to read what it shares, and to scatter by what its strokes are off that on this arm, in all
    /// columns; where another column jumps it is that one alone, and where nothing does nobody scatters more.
    #[test]
    fn strokes_that_jump_scatter() {
        let arm = |slips_deg: [f64; 6], drifts_m: [f64; 6]| {
            let row = |i: usize| StrokeRow {
                stroke_id: Some(format!("s{i}")),
                alpha_deg: if i < 3 { 90.0 } else { 80.0 },
                depth_m: 0.025,
                width_m: 0.1,
                force_n: 5.0,
                friction_angle_deg: Some(slips_deg[i]),
                z_drift_m: Some(drifts_m[i]),
                ..StrokeRow::default()
            };
            Data::new("t", (0..6).map(row).collect(), Campaign::default()).unwrap()
        };
        let still = || arm([23.0; 6], [0.0; 6]);
        let beside = |simulated: &Data| {
            let mut data = still();
            data.expect(&still(), false, 0.0);
            // Chance of 0.1 deg and 0.1 mm.
            let jumps = arm([23.1; 6], [1e-4; 6]);
            data.doubt(crate::learnt::Learnt::of_setting(&data, &still(), &jumps, &jumps));
            data.expect(simulated, false, 0.0);
            data
        };
        let base = beside(&still());
        let drifts_m = [1e-3, 1e-3, 1.2e-3, 0.0, 0.0, 6e-3];
        let mut with = beside(&arm([25.0, 25.0, 28.0, 24.0, 24.0, 24.0], drifts_m));
        with.expect_as(&base);
        let chance = 4.0 / 3.0 * 0.1_f64.powi(2);
        let check = |channel: Channel, unit: f64, of_kinds: [(f64, f64); 2]| {
            for i in 0..6 {
                let (expected, further) = of_kinds[i / 3];
                assert!((with.expected[&channel][i] / unit - expected).abs() < 1e-9, "{channel:?} {i}");
                let variance = with.unsteadiness.variance(Some(channel), i) / (unit * unit);
                assert!((variance - chance - further).abs() < 1e-9, "{channel:?} {i}: {variance}");
            }
        };
        check(Channel::FrictionAngle, 1.0, [(25.0, 3.0), (24.0, 0.0)]);
        check(Channel::ZDrift, 1e-3, [(1.0, 0.04 / 3.0), (0.0, 12.0)]);
        assert_eq!(with.readings().strokes, [true; 6]);
    }
}
