//! Two simulated arms of one campaign, and what of their difference is chance.

use soilctl_effects::Channel;
use soilctl_stats::median;

use crate::channels::spread;
use crate::data::{Data, is_of_a_kind};
use crate::transfer::kept;

/// Depths of two strokes, relative to the lesser, from which they tell how a difference goes with the depth.
const LEAST_APART: f64 = 0.05;

/// Columns in which a stroke that slips or sinks on one arm and not on another differs from the others of its kind, and by how many standard deviations
/// of chance. Empirical.
const SLIPPING: [Channel; 2] = [Channel::FrictionAngle, Channel::SlipAngle];
const ASTRAY: f64 = 6.0;

impl Data {
    /// Takes chance out of what is expected beyond what `base` expects, the same strokes beside another simulated arm: two arms made by themselves would
    /// each have its own, which is as much as small effects are. Strokes of one kind (tool angle and radius) differ by their median and with their
    /// depth, and each by what it has beyond, drawn to nothing by the share of its square that is to be expected of strokes that go their own way. A
    /// kind of which one slips otherwise than the others is on the brink and takes no part, as one of which a stroke sinks ([`Data::readings`]).
    pub fn expect_as(&mut self, base: &Self) {
        let both: Vec<bool> = self.made.iter().zip(&base.made).map(|(a, b)| *a && *b).collect();
        let mut astray = vec![false; both.len()];
        let mut expected = std::mem::take(&mut self.expected);
        for (channel, values) in &mut expected {
            let Some(theirs) = base.expected.get(channel) else { continue };
            let variance = self.unsteadiness.mean_variance(Some(*channel));
            let (smooth, left) = self.smooth(values, theirs, &both, variance);
            *values = smooth;
            if SLIPPING.contains(channel) && variance > 0.0 {
                let far = |left: f64| left * left > ASTRAY * ASTRAY * variance;
                astray.iter_mut().zip(left).for_each(|(astray, left)| *astray |= far(left));
            }
        }
        self.expected = expected;
        for i in (0..astray.len()).filter(|&i| astray[i]) {
            let of_kind = |j: &usize| is_of_a_kind(&self.rows[i], &self.rows[*j]);
            let kind: Vec<usize> = (0..self.rows.len()).filter(of_kind).collect();
            kind.into_iter().for_each(|j| self.made[j] = false);
        }
        if let (Some(scene), Some(theirs)) = (self.scene.as_ref(), base.scene.as_ref()) {
            self.scene = Some(self.smooth(scene, theirs, &both, self.unsteadiness.mean_variance(None)).0);
        }
    }

    /// `theirs` and what of `values` beyond it is no chance, of which a difference has this variance, as told by some of the strokes. One that went another
    /// way tells nothing of the others of its kind: medians. Beside it, what each stroke has beyond what its kind shares; 0 of those that tell nothing.
    fn smooth(
        &self,
        values: &[f64],
        theirs: &[f64],
        told_by: &[bool],
        variance: f64,
    ) -> (Vec<f64>, Vec<f64>) {
        let beyond: Vec<f64> = values.iter().zip(theirs).map(|(a, b)| a - b).collect();
        let depth = |i: usize| self.rows[i].depth_m;
        let told: Vec<usize> = (0..beyond.len()).filter(|&i| told_by[i]).collect();
        let like = |i: usize| -> Vec<usize> {
            let of_kind = |j: &usize| is_of_a_kind(&self.rows[i], &self.rows[*j]);
            let of: Vec<usize> = told.iter().copied().filter(of_kind).collect();
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
        let smooth = (0..beyond.len()).map(|i| theirs[i] + shared[i] + own * left[i]).collect();
        (smooth, left)
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
            let smooth = data.smooth(&values, &theirs, told_by, variance).0;
            smooth.iter().zip(&theirs).map(|(a, b)| a - b).collect()
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
}
