use soilctl_stats::median;

use crate::clock::{Clock, Repaired};

/// Times further apart than so many usual intervals have a gap between them.
const GAP_INTERVALS: f64 = 5.0;
/// Fewer intervals have no usual one.
const LEAST_INTERVALS: usize = 3;

/// How regularly the messages of a topic came, on the one clock.
#[derive(Debug, Clone, PartialEq)]
pub struct TopicClock {
    /// The topic.
    pub topic: String,
    /// Messages that could be read.
    pub messages: usize,
    /// Time of the first in s.
    pub first_s: f64,
    /// Time of the last in s.
    pub last_s: f64,
    /// Median of the times between two messages in s; `None` for fewer than three.
    pub interval_s: Option<f64>,
    /// Times from and to which no message came for more than five usual intervals, in s.
    pub gaps: Vec<[f64; 2]>,
    /// Whether stamps were put aside, since they are too coarse to tell messages apart.
    pub by_log: bool,
}

impl TopicClock {
    pub(crate) fn of(topic: &str, repaired: &Repaired, by_log: bool, clock: &Clock) -> Self {
        let mut times: Vec<i64> = repaired.times_ns.clone();
        times.sort_unstable();
        let messages = times.len();
        times.dedup();
        let seconds = |ns: Option<&i64>| ns.map_or(0.0, |ns| clock.seconds(*ns));
        let (first_s, last_s) = (seconds(times.first()), seconds(times.last()));
        #[allow(clippy::cast_precision_loss, reason = "a nanosecond in three months")]
        let step = |pair: &[i64]| pair[1].saturating_sub(pair[0]) as f64;
        let mut steps: Vec<f64> = times.windows(2).map(step).collect();
        let interval_ns = (steps.len() >= LEAST_INTERVALS).then(|| median(&mut steps));
        let is_gap = |pair: &&[i64]| interval_ns.is_some_and(|usual| step(pair) > GAP_INTERVALS * usual);
        let gaps = times.windows(2).filter(is_gap).map(|pair| [pair[0], pair[1]].map(|ns| clock.seconds(ns)));
        let gaps = gaps.collect();
        let interval_s = interval_ns.map(|ns| ns * 1e-9);
        Self { topic: topic.to_owned(), messages, first_s, last_s, interval_s, gaps, by_log }
    }
}
