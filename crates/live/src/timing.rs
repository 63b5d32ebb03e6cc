use std::time::Duration;

use schemars::JsonSchema;
use serde::Serialize;

/// Upper ends of the bins of a [`Histogram`] in microseconds; the last bin has none.
pub const BIN_ENDS_US: [u32; 12] = [5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 100_000];

/// How long something took, in bins of fixed size. Counting allocates nothing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Histogram {
    /// Counts of the bins; the last one is what lies beyond all ends.
    pub counts: [u64; BIN_ENDS_US.len() + 1],
    /// The largest in microseconds.
    pub worst_us: u64,
}

impl Histogram {
    /// Counts one.
    pub fn add(&mut self, time: Duration) {
        let us = u64::try_from(time.as_micros()).unwrap_or(u64::MAX);
        let bin = BIN_ENDS_US.iter().position(|&end| us < u64::from(end)).unwrap_or(BIN_ENDS_US.len());
        if let Some(count) = self.counts.get_mut(bin) {
            *count += 1;
        }
        self.worst_us = self.worst_us.max(us);
    }

    /// How many were counted.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// One line: `below 5 us: 10, below 10 us: 3, ...; worst 8 us`. Empty bins are left out.
    #[must_use]
    pub fn words(&self) -> String {
        let bins: Vec<_> = self
            .counts
            .iter()
            .enumerate()
            .filter(|(_, count)| **count > 0)
            .map(|(bin, count)| match (BIN_ENDS_US.get(bin), BIN_ENDS_US.last()) {
                (Some(end), _) => format!("below {end} us: {count}"),
                (None, Some(last)) => format!("{last} us and more: {count}"),
                (None, None) => String::new(),
            })
            .collect();
        format!("{}; worst {} us", bins.join(", "), self.worst_us)
    }
}

/// How well a run in real time kept time.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Timing {
    /// Ticks that were still busy when the next one was due.
    pub overruns: u64,
    /// Ticks that were given up to catch up with the clock.
    pub skipped: u64,
    /// How late the ticks began, against their deadlines.
    pub lateness: Histogram,
    /// How long a tick took: hardware, controller, and handing things on.
    pub busy: Histogram,
    /// Whether the servo thread ran under SCHED_FIFO.
    pub fifo: bool,
    /// Whether the memory was locked.
    pub locked: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_time_has_one_bin() {
        let mut histogram = Histogram::default();
        for us in [0, 4, 5, 999, 1000, 99_999, 100_000, 5_000_000] {
            histogram.add(Duration::from_micros(us));
        }
        assert_eq!(histogram.counts, [2, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 2]);
        assert_eq!((histogram.total(), histogram.worst_us), (8, 5_000_000));
        let words = histogram.words();
        assert!(words.starts_with("below 5 us: 2, below 10 us: 1, "), "{words}");
        assert!(words.ends_with("100000 us and more: 2; worst 5000000 us"), "{words}");
    }
}
