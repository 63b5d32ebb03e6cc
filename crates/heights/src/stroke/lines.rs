//! Lines over the middle half of the plate's width, along its heading.

use soilctl_stats::sd_of_median_abs;

use super::{Plate, Profile, edge};
use crate::change::Change;

/// Parts of the middle half whose edges are looked at one by one.
pub(super) const PARTS: usize = 5;
/// Samples in a row over which it shows how noise clumps along a line.
const RUN: usize = 4;
/// Fewest places of unchanged ground that tell the noise of a profile.
const FEWEST: usize = 30;

/// Noise of the samples of a profile.
#[derive(Debug, Clone, Copy)]
pub(super) struct Noise {
    /// Standard deviation of one, in m.
    pub(super) sd_m: f64,
    /// Variance of sums of neighbours over that of independent samples.
    pub(super) clumping: f64,
}

pub(super) struct Lines<'a> {
    change: &'a Change,
    plate: &'a Plate,
    pub(super) step_m: f64,
    /// Places of the lines to the left of the plate's middle, in m.
    left_m: Vec<f64>,
    samples: usize,
    pub(super) noise: Noise,
}

impl<'a> Lines<'a> {
    pub(super) fn new(change: &'a Change, plate: &'a Plate) -> Self {
        let step_m = change.grid.cell_m();
        let count = (0.5 * plate.width_m / step_m).floor() as usize + 1;
        let left_m = (0..count).map(|i| (i as f64 - 0.5 * (count as f64 - 1.0)) * step_m).collect();
        let [x, y] = change.grid.extent_m();
        let samples = (libm::hypot(x[1] - x[0], y[1] - y[0]) / step_m) as usize + 1;
        let noise = Noise { sd_m: change.noise_m, clumping: 1.0 };
        let mut lines = Self { change, plate, step_m, left_m, samples, noise };
        lines.noise = lines.noise_of(&lines.left_m);
        lines
    }

    /// Change of the cell at a sample of a line.
    fn at(&self, sample: f64, left_m: f64) -> Option<(f64, usize)> {
        let place = self.plate.place([(sample + 0.5) * self.step_m, left_m]);
        let cell = self.change.grid.cell_of(place)?;
        self.change.by_m.get(cell).copied().flatten().map(|by| (by, cell))
    }

    fn means(&self, left_m: &[f64]) -> Vec<Option<f64>> {
        let mean = |sample: usize| {
            let values: Vec<f64> =
                left_m.iter().filter_map(|left| Some(self.at(sample as f64, *left)?.0)).collect();
            (2 * values.len() >= left_m.len() && !values.is_empty())
                .then(|| values.iter().sum::<f64>() / values.len() as f64)
        };
        let mut means: Vec<_> = (0..self.samples).map(mean).collect();
        // Where the map ends, so does the profile.
        let end = means.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
        means.truncate(end);
        means
    }

    /// Noise of means over lines as far apart, from the same lines put everywhere on unchanged ground.
    fn noise_of(&self, left_m: &[f64]) -> Noise {
        let apart = left_m.len() as f64 * self.step_m;
        let half = self.samples as f64;
        let count = (half * self.step_m / apart) as i64;
        let (mut all, mut runs) = (Vec::new(), Vec::new());
        for k in -count..=count {
            let mut run: Vec<f64> = Vec::new();
            for i in 0..2 * self.samples {
                let values: Option<Vec<f64>> = left_m
                    .iter()
                    .map(|left| {
                        let (by, cell) = self.at(i as f64 - half, left + k as f64 * apart)?;
                        (!self.change.changed.get(cell)?).then_some(by)
                    })
                    .collect();
                let Some(values) = values else {
                    run.clear();
                    continue;
                };
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                all.push(mean);
                run.push(mean);
                if run.len() == RUN {
                    runs.push(run.iter().sum::<f64>() / RUN as f64);
                    run.clear();
                }
            }
        }
        // Independent cells would leave this, and so does what is known of heights.
        let change = self.change;
        let least = change.noise_m / (left_m.len() as f64).sqrt();
        if all.len() < FEWEST {
            return Noise { sd_m: least * change.clumping.sqrt(), clumping: 1.0 };
        }
        let sd_m = sd_of_median_abs(all.into_iter());
        let clumping = if runs.len() < FEWEST || sd_m == 0.0 {
            1.0
        } else {
            (sd_of_median_abs(runs.into_iter()) / sd_m).powi(2) * RUN as f64
        };
        Noise { sd_m: sd_m.max(least), clumping: clumping.max(1.0) }
    }

    pub(super) fn profile(&self) -> Profile {
        let rise_m = self.means(&self.left_m);
        Profile {
            ahead_m: (0..rise_m.len()).map(|i| (i as f64 + 0.5) * self.step_m).collect(),
            rise_m,
            noise_m: self.noise.sd_m,
            lines: self.left_m.len(),
        }
    }

    /// Where the edge is by parts of the lines, in steps; nothing where a part is too noisy to tell, or there are fewer lines than parts.
    pub(super) fn parts(&self, deviations: f64) -> [Option<f64>; PARTS] {
        let count = self.left_m.len();
        let mut parts = [None; PARTS];
        if count < PARTS {
            return parts;
        }
        for (i, part) in parts.iter_mut().enumerate() {
            let of = self.left_m.get(i * count / PARTS..(i + 1) * count / PARTS).unwrap_or_default();
            let noise = self.noise_of(of);
            let found = edge::find(&self.means(of), noise, deviations, self.plate.width_m / self.step_m);
            *part = found.ok().map(|edge| edge.at);
        }
        parts
    }
}
