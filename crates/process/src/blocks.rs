//! Samples averaged over short times, and their course over displacement at even arc length.

use std::ops::Range;

use soilctl_stats::noise;

use crate::trace::Trace;

/// At most so many blocks; a stroke of 10 s at 500 Hz has blocks of 10 samples.
const MOST_BLOCKS: usize = 500;

/// Means over blocks of equally many samples.
#[derive(Debug, Clone)]
pub(crate) struct Blocks {
    pub(crate) t_s: Vec<f64>,
    pub(crate) u_m: Vec<f64>,
    pub(crate) f_n: Vec<f64>,
    /// Samples a block.
    pub(crate) samples: usize,
    /// Standard deviation of a block's force.
    pub(crate) noise_n: f64,
}

impl Blocks {
    pub(crate) fn of(trace: &Trace) -> Self {
        let samples = trace.t_s().len().div_ceil(MOST_BLOCKS).max(1);
        let means = |values: &[f64]| -> Vec<f64> {
            values.chunks_exact(samples).map(|chunk| chunk.iter().sum::<f64>() / samples as f64).collect()
        };
        let f_n = means(trace.force_n());
        let noise_n = noise(&f_n);
        Self { t_s: means(trace.t_s()), u_m: means(trace.displacement_m()), f_n, samples, noise_n }
    }

    /// Time from one block to the next in s; 0 of fewer than two.
    pub(crate) fn interval_s(&self) -> f64 {
        self.t_s.windows(2).map(|pair| pair[1] - pair[0]).next().unwrap_or(0.0)
    }

    /// Means of `count` neighbouring blocks each, whose noise is known.
    pub(crate) fn grouped(&self, count: usize, noise_n: f64) -> Self {
        let means = |values: &[f64]| -> Vec<f64> {
            values.chunks_exact(count).map(|chunk| chunk.iter().sum::<f64>() / count as f64).collect()
        };
        Self {
            t_s: means(&self.t_s),
            u_m: means(&self.u_m),
            f_n: means(&self.f_n),
            samples: self.samples * count,
            noise_n,
        }
    }

    /// Some of the blocks.
    pub(crate) fn part(&self, blocks: Range<usize>) -> Self {
        let cut = |values: &[f64]| values.get(blocks.clone()).unwrap_or_default().to_vec();
        Self {
            t_s: cut(&self.t_s),
            u_m: cut(&self.u_m),
            f_n: cut(&self.f_n),
            samples: self.samples,
            noise_n: self.noise_n,
        }
    }

    /// The blocks in which the plate goes where it has not been before, within a tolerance in m: soil that was let go and is
    /// pushed again follows another curve until then.
    pub(crate) fn virgin(&self, tolerance_m: f64) -> Self {
        let mut furthest_m = f64::NEG_INFINITY;
        let is_new = |u: &f64| {
            furthest_m = furthest_m.max(*u);
            *u >= furthest_m - tolerance_m
        };
        let kept: Vec<bool> = self.u_m.iter().map(is_new).collect();
        let only =
            |values: &[f64]| values.iter().zip(&kept).filter_map(|(v, kept)| kept.then_some(*v)).collect();
        Self {
            t_s: only(&self.t_s),
            u_m: only(&self.u_m),
            f_n: only(&self.f_n),
            samples: self.samples,
            noise_n: self.noise_n,
        }
    }

    /// Force against displacement at `count` places evenly spaced along the curve, both axes scaled to their
    /// range: so a stroke that waits long at small displacement doesn't drown its short end.
    pub(crate) fn nodes(&self, count: usize) -> Vec<[f64; 2]> {
        let range = |values: &[f64]| {
            let (low, high) =
                values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
            (high - low).max(f64::MIN_POSITIVE)
        };
        let (u_range, f_range) = (range(&self.u_m), range(&self.f_n));
        let mut arc = Vec::with_capacity(self.u_m.len());
        let mut length = 0.0;
        for (i, (u, f)) in self.u_m.iter().zip(&self.f_n).enumerate() {
            if i > 0 {
                length += ((u - self.u_m[i - 1]) / u_range).hypot((f - self.f_n[i - 1]) / f_range);
            }
            arc.push(length);
        }
        // Each node is the mean of the blocks in its share of the curve, or lies between two blocks if it has none.
        let width = length / count as f64;
        (0..count)
            .filter_map(|k| {
                let (from, to) = (k as f64 * width, (k + 1) as f64 * width);
                let first = arc.partition_point(|s| *s < from);
                let last = arc.partition_point(|s| *s < to);
                if last > first {
                    let n = (last - first) as f64;
                    return Some([
                        self.u_m.get(first..last)?.iter().sum::<f64>() / n,
                        self.f_n.get(first..last)?.iter().sum::<f64>() / n,
                    ]);
                }
                let (a, b) = (first.checked_sub(1)?, first);
                let share = (f64::midpoint(from, to) - arc.get(a)?) / (arc.get(b)? - arc.get(a)?);
                let between = |v: &[f64]| Some(v.get(a)? + share * (v.get(b)? - v.get(a)?));
                Some([between(&self.u_m)?, between(&self.f_n)?])
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn soil_that_is_pushed_again_counts_from_where_it_was_let_go() {
        let u_m = vec![0.0, 1.0, 2.0, 3.0, 2.95, 2.0, 1.0, 2.0, 2.95, 3.0, 4.0];
        let f_n: Vec<f64> = (0..u_m.len()).map(|k| k as f64).collect();
        let blocks = Blocks { t_s: f_n.clone(), u_m, f_n, samples: 1, noise_n: 0.1 };
        let new = blocks.virgin(0.1);
        assert_eq!(new.f_n, [0.0, 1.0, 2.0, 3.0, 4.0, 8.0, 9.0, 10.0]);
        assert_eq!((new.u_m.len(), new.t_s), (8, new.f_n));
    }
}
