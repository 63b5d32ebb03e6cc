//! Cuts a path into pieces about as long as the wanted size.

use super::MeshError;
use super::domain::Domain;
use super::wanted::{GROWTH, Wanted};
use crate::vector::Point;

/// The wanted size along a path, sampled finely enough to be integrated.
pub(super) struct Profile {
    /// Distance from the start and wanted size there; at least two.
    samples: Vec<[f64; 2]>,
}

impl Profile {
    /// Samples along a path of the given length; `at` gives the point at a distance from the start.
    pub(super) fn new(wanted: &Wanted, length: f64, at: impl Fn(f64) -> Point) -> Result<Self, MeshError> {
        let mut samples = vec![[0.0, wanted.at(at(0.0))?]];
        let (mut x, mut h) = (0.0, samples[0][1]);
        loop {
            x += (0.5 * h).min(length / 16.0);
            if x >= length {
                break;
            }
            h = wanted.at(at(x))?;
            samples.push([x, h]);
            wanted.allow(samples.len() / 4)?;
        }
        samples.push([length, wanted.at(at(length))?]);
        Ok(Self { samples })
    }

    /// Wanted sizes at the two ends.
    pub(super) fn ends(&self) -> [f64; 2] {
        [self.samples[0][1], self.samples[self.samples.len() - 1][1]]
    }

    /// Lowers the sizes so that they are at most those given at the ends and grow at most by [`GROWTH`].
    pub(super) fn limit(&mut self, ends: [f64; 2]) {
        let last = self.samples.len() - 1;
        self.samples[0][1] = self.samples[0][1].min(ends[0]);
        self.samples[last][1] = self.samples[last][1].min(ends[1]);
        for i in 1..=last {
            let most = self.samples[i - 1][1] + GROWTH * (self.samples[i][0] - self.samples[i - 1][0]);
            self.samples[i][1] = self.samples[i][1].min(most);
        }
        for i in (0..last).rev() {
            let most = self.samples[i + 1][1] + GROWTH * (self.samples[i + 1][0] - self.samples[i][0]);
            self.samples[i][1] = self.samples[i][1].min(most);
        }
    }

    /// The size at a distance from the start.
    pub(super) fn size(&self, x: f64) -> f64 {
        let i = self.samples.partition_point(|s| s[0] < x).clamp(1, self.samples.len() - 1);
        let ([x0, h0], [x1, h1]) = (self.samples[i - 1], self.samples[i]);
        h0 + (h1 - h0) * ((x - x0) / (x1 - x0)).clamp(0.0, 1.0)
    }

    /// Where to cut between the distances `from` and `to` (neither included): a whole number of pieces, each the same
    /// multiple of the wanted size, at least one.
    pub(super) fn cuts(&self, from: f64, to: f64) -> Vec<f64> {
        let mut sum = vec![[from, 0.0]];
        let inner = self.samples.iter().map(|s| s[0]).filter(|&x| x > from && x < to);
        for x in inner.chain([to]) {
            let [x0, pieces] = sum[sum.len() - 1];
            sum.push([x, pieces + (x - x0) * 2.0 / (self.size(x0) + self.size(x))]);
        }
        let total = sum[sum.len() - 1][1];
        let count = total.round().max(1.0);
        let mut cuts = Vec::new();
        let mut i = 1;
        for k in 1..count as usize {
            let target = total * k as f64 / count;
            while sum[i][1] < target {
                i += 1;
            }
            let ([x0, p0], [x1, p1]) = (sum[i - 1], sum[i]);
            cuts.push(x0 + (x1 - x0) * (target - p0) / (p1 - p0));
        }
        cuts
    }
}

/// The size profile of each line. Sizes agree at corners, and no corner's size is larger than its shortest line.
pub(super) fn line_profiles(domain: &Domain, wanted: &Wanted) -> Result<Vec<Profile>, MeshError> {
    let lines = &domain.statement.lines;
    let mut profiles = Vec::with_capacity(lines.len());
    let mut corner = vec![f64::INFINITY; domain.statement.points.len()];
    let mut samples = 0;
    for (i, line) in lines.iter().enumerate() {
        let length = domain.length(i);
        let profile = Profile::new(wanted, length, |x| domain.on_line(i, x / length))?;
        samples += profile.samples.len();
        wanted.allow(samples.saturating_sub(17 * lines.len()) / 8)?;
        for (point, size) in [line.from, line.to].into_iter().zip(profile.ends()) {
            corner[point] = corner[point].min(size).min(length);
        }
        profiles.push(profile);
    }
    // Small sizes spread along lines and round corners; after a few lines they no longer matter.
    for _ in 0..8 {
        let mut changed = false;
        for (line, profile) in lines.iter().zip(&mut profiles) {
            profile.limit([corner[line.from], corner[line.to]]);
            for (point, size) in [line.from, line.to].into_iter().zip(profile.ends()) {
                changed |= size < corner[point];
                corner[point] = corner[point].min(size);
            }
        }
        if !changed {
            break;
        }
    }
    Ok(profiles)
}
