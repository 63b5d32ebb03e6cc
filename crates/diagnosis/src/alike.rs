//! Two simulated arms of one campaign, and what of their difference is chance.

use crate::data::{Data, is_of_a_kind};
use crate::transfer::kept;

impl Data {
    /// Takes chance out of what is expected beyond what `base` expects, the same strokes beside another simulated arm: strokes of one kind (tool angle
    /// and radius) differ by their mean and with their depth, and each by what it has beyond, drawn to nothing by the share of its square that is to be
    /// expected of strokes that go their own way. Two arms made by themselves would each have its own chance, which is as much as small effects are.
    pub fn expect_as(&mut self, base: &Self) {
        let both: Vec<bool> = self.made.iter().zip(&base.made).map(|(a, b)| *a && *b).collect();
        let mut expected = std::mem::take(&mut self.expected);
        for (channel, values) in &mut expected {
            if let Some(theirs) = base.expected.get(channel) {
                *values = self.smooth(values, theirs, &both, self.unsteadiness.mean_variance(Some(*channel)));
            }
        }
        self.expected = expected;
        if let (Some(scene), Some(theirs)) = (self.scene.as_ref(), base.scene.as_ref()) {
            self.scene = Some(self.smooth(scene, theirs, &both, self.unsteadiness.mean_variance(None)));
        }
    }

    /// `theirs` and what of `values` beyond it is no chance, of which a difference has this variance, as told by some of the strokes.
    fn smooth(&self, values: &[f64], theirs: &[f64], told_by: &[bool], variance: f64) -> Vec<f64> {
        let beyond: Vec<f64> = values.iter().zip(theirs).map(|(a, b)| a - b).collect();
        let depth = |i: usize| self.rows[i].depth_m;
        let told: Vec<usize> = (0..beyond.len()).filter(|&i| told_by[i]).collect();
        // Mean depth and difference of strokes like one.
        let means = |i: usize| {
            let like: Vec<usize> =
                told.iter().copied().filter(|&j| is_of_a_kind(&self.rows[i], &self.rows[j])).collect();
            let of = if like.is_empty() { &told } else { &like };
            let n = of.len().max(1) as f64;
            (of.iter().map(|&j| depth(j)).sum::<f64>() / n, of.iter().map(|&j| beyond[j]).sum::<f64>() / n)
        };
        let means: Vec<(f64, f64)> = (0..beyond.len()).map(means).collect();
        let sum = |of: &dyn Fn(usize, f64, f64) -> f64| -> f64 {
            told.iter().map(|&i| of(i, depth(i) - means[i].0, beyond[i] - means[i].1)).sum()
        };
        let square = sum(&|_, d, _| d * d);
        let slope = if square > 0.0 { sum(&|_, d, x| d * x) / square } else { 0.0 };
        let slope = kept(slope * slope * square, variance) * slope;
        let left = sum(&|_, d, x| (x - slope * d).powi(2)) / told.len().max(1) as f64;
        let own = kept(left, variance);
        let of_stroke = |i: usize| {
            let ((at, mean), is_told) = (means[i], told_by[i]);
            let shared = mean + slope * (depth(i) - at);
            theirs[i] + shared + if is_told { own * (beyond[i] - shared) } else { 0.0 }
        };
        (0..beyond.len()).map(of_stroke).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    /// Four strokes at each of two tool angles: what differs by kind and depth stays as it is, what alternates by as much as chance goes, and of what is
    /// twice as much in root mean square three quarters stay. A stroke that says nothing takes what its kind says.
    #[test]
    fn what_kinds_and_depths_do_is_no_chance() {
        let row = |i: usize| StrokeRow {
            alpha_deg: if i < 4 { 90.0 } else { 80.0 },
            depth_m: [0.02, 0.02, 0.03, 0.03][i % 4],
            width_m: 0.1,
            force_n: 5.0,
            ..StrokeRow::default()
        };
        let data = Data::new("t", (0..8).map(row).collect(), Campaign::default()).unwrap();
        let theirs: Vec<f64> = (0..8).map(|i| 0.3 * f64::from(i)).collect();
        let real = |i: usize| if i < 4 { 2.0 } else { -1.0 } + 400.0 * (data.rows[i].depth_m - 0.025);
        let chance = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let beyond = |size: f64, told_by: &[bool; 8], variance: f64| -> Vec<f64> {
            let values: Vec<f64> = (0..8).map(|i| theirs[i] + real(i) + size * chance(i)).collect();
            let smooth = data.smooth(&values, &theirs, told_by, variance);
            smooth.iter().zip(&theirs).map(|(a, b)| a - b).collect()
        };
        let slope = 1.0 - 1.0 / (8.0 * 4.0);
        let expected = |i: usize| {
            let depth = 400.0 * (data.rows[i].depth_m - 0.025);
            real(i) - depth + slope * depth
        };
        for (i, found) in beyond(1.0, &[true; 8], 0.0).into_iter().enumerate() {
            assert!((found - real(i) - chance(i)).abs() < 1e-12);
        }
        // The slope is 2 in root mean square, of eight strokes.
        let of_left = |size: f64| {
            let left = size * size + (2.0 * (1.0 - slope)).powi(2);
            kept(left, 1.0)
        };
        for (i, found) in beyond(0.9, &[true; 8], 1.0).into_iter().enumerate() {
            assert!((found - expected(i)).abs() < 1e-12, "{i}: {found}");
        }
        for (i, found) in beyond(2.0, &[true; 8], 1.0).into_iter().enumerate() {
            let own = of_left(2.0) * (real(i) + 2.0 * chance(i) - expected(i));
            assert!((found - expected(i) - own).abs() < 1e-12 && (of_left(2.0) - 0.75).abs() < 0.01);
        }
        let silent = beyond(0.0, &[false, true, true, true, true, true, true, true], 0.0);
        let depth = data.rows[0].depth_m - (0.02 + 0.03 + 0.03) / 3.0;
        assert!((silent[0] - (2.0 + 400.0 * (0.08 / 3.0 - 0.025) + 400.0 * depth)).abs() < 1e-9);
    }
}
