use std::collections::{BTreeMap, BTreeSet};

use super::Gap;

/// An interval over so many medians is a gap.
const GAP: f64 = 5.0;
/// Fewer intervals have no median worth the name.
const LEAST_INTERVALS: u64 = 3;
/// Most gaps that are listed.
const MOST_GAPS: usize = 10;

/// Intervals between times that rise; a time that does not is passed over. They are counted in bins that are a sixty-fourth wide, some
/// thousand at most, with the sum of each, so that the mean of the middle bin is the median to much better than that.
#[derive(Debug, Default)]
pub(super) struct Intervals {
    /// The earliest time so far.
    pub(super) earliest: Option<i64>,
    /// The latest time so far.
    pub(super) latest: Option<i64>,
    count: u64,
    bins: BTreeMap<u16, (u64, u128)>,
    longest: BTreeSet<(u64, i64)>,
}

impl Intervals {
    pub(super) fn note(&mut self, ns: i64) {
        self.earliest = Some(self.earliest.map_or(ns, |earliest| earliest.min(ns)));
        let Some(latest) = self.latest.replace(self.latest.map_or(ns, |latest| latest.max(ns))) else {
            return;
        };
        if ns <= latest {
            return;
        }
        let length = ns.abs_diff(latest);
        self.count += 1;
        let bin = self.bins.entry(bin(length)).or_default();
        bin.0 += 1;
        bin.1 += u128::from(length);
        self.longest.insert((length, latest));
        if self.longest.len() > MOST_GAPS {
            self.longest.pop_first();
        }
    }

    pub(super) fn median(&self) -> Option<f64> {
        if self.count < LEAST_INTERVALS {
            return None;
        }
        let mut before = 0;
        let (count, sum) = self.bins.values().find(|(count, _)| {
            before += count;
            2 * before >= self.count
        })?;
        #[allow(clippy::cast_precision_loss, reason = "far below 2^53 but for logs of months")]
        Some(*sum as f64 / *count as f64)
    }

    /// How many intervals are too long against this median, and the longest of them.
    pub(super) fn gaps(&self, median_ns: f64) -> (u64, Vec<Gap>) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is positive")]
        let limit = bin((GAP * median_ns) as u64);
        let count = self.bins.iter().filter(|(bin, _)| **bin > limit).map(|(_, (count, _))| count).sum();
        let mut listed: Vec<Gap> = self
            .longest
            .iter()
            .filter(|(length, _)| bin(*length) > limit)
            .map(|&(length_ns, from_ns)| Gap { from_ns, length_ns })
            .collect();
        listed.sort_by_key(|gap| gap.from_ns);
        (count, listed)
    }
}

/// Bins rise with the length: 64 for each power of two.
fn bin(length: u64) -> u16 {
    let shift = (u64::BITS - length.leading_zeros()).saturating_sub(7);
    u16::try_from((shift << 6) + u32::try_from(length >> shift).unwrap_or(0)).unwrap_or(u16::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_rise_by_a_sixty_fourth() {
        let mut last = 0;
        for length in (0..100_000).chain((17..63).map(|i| 1 << i)).chain([u64::MAX]) {
            let now = bin(length);
            assert!(now >= last, "{length}");
            last = now;
            if length > 128 {
                assert!(bin(length.saturating_add(length / 63)) > now || length == u64::MAX, "{length}");
            }
        }
    }

    /// The same by sorting.
    #[test]
    fn median_and_gaps_of_irregular_times() {
        let mut seed = 7_u64;
        let mut times = vec![0_i64];
        for i in 0..5000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let jitter = i64::try_from(seed >> 44).unwrap();
            let step = if i % 600 == 599 { 100_000_000 + i } else { 10_000_000 + jitter };
            times.push(times[times.len() - 1] + step);
        }
        let mut intervals = Intervals::default();
        times.iter().for_each(|&t| intervals.note(t));
        let mut sorted: Vec<i64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        sorted.sort_unstable();
        let exact = sorted[sorted.len() / 2] as f64;
        let median = intervals.median().unwrap();
        assert!((median / exact - 1.0).abs() < 0.01, "{median} {exact}");
        let (count, listed) = intervals.gaps(median);
        assert_eq!((count, listed.len()), (8, 8));
        assert!(listed.is_sorted_by_key(|gap| gap.from_ns));
        assert!(listed.iter().all(|gap| gap.length_ns > 99_000_000));
    }
}
