//! How regularly the messages of a recording come.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_session::read::RawMessage;

use crate::Readers;
use crate::contents::is_truth;

/// An interval over so many medians is a gap.
const GAP: f64 = 5.0;
/// Fewer intervals have no median worth the name.
const LEAST_INTERVALS: u64 = 3;
/// Most gaps that are listed.
const MOST_GAPS: usize = 10;

/// Collects the times of messages, topic by topic, in memory that does not grow with their number.
#[derive(Debug, Default)]
pub struct Rates {
    topics: BTreeMap<String, Gauge>,
    readers: Readers,
}

/// How regularly the messages of a topic come.
#[derive(Debug, Clone, PartialEq)]
pub struct Rate {
    /// How many there are.
    pub messages: u64,
    /// The earliest log time in ns.
    pub first_ns: u64,
    /// The latest log time in ns.
    pub last_ns: u64,
    /// Which times the intervals and gaps are taken from.
    pub clock: Clock,
    /// The median interval in ns, to about a hundredth; nothing for fewer than three intervals.
    pub interval_ns: Option<f64>,
    /// How many intervals are longer than five medians.
    pub gaps: u64,
    /// The ten longest of them, in order of time.
    pub longest_gaps: Vec<Gap>,
    /// About the stamps; nothing if messages have none, or cannot be read.
    pub stamps: Option<Stamps>,
}

/// Which times are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clock {
    /// Stamps of the messages, when all have one.
    Stamp,
    /// Times at which they were recorded.
    Log,
}

/// An interval that is too long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Gap {
    /// Time of the message before it in ns.
    pub from_ns: i64,
    /// Its length in ns.
    pub length_ns: u64,
}

/// What is odd about the stamps of a topic.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stamps {
    /// Messages whose stamp was not set.
    pub unset: u64,
    /// Messages whose stamp is before that of an earlier message.
    pub out_of_order: u64,
    /// Messages with the latest stamp so far once more.
    pub duplicates: u64,
    /// Messages that cannot be read.
    pub malformed: u64,
    /// Stamp minus log time where the two differ most, in ns.
    pub largest_offset_ns: i64,
}

impl Rate {
    /// Messages a second by the median interval.
    #[must_use]
    pub fn rate_hz(&self) -> Option<f64> {
        self.interval_ns.map(|ns| 1e9 / ns)
    }
}

impl Rates {
    /// Notes a message. Those below `/truth` are passed over.
    pub fn note(&mut self, message: &RawMessage<'_>) {
        let topic = &message.channel.topic;
        if is_truth(topic) {
            return;
        }
        if !self.topics.contains_key(topic) {
            self.topics.insert(topic.clone(), Gauge::default());
        }
        let Some(gauge) = self.topics.get_mut(topic) else { return };
        let stamp = match self.readers.reader(message) {
            Ok(reader) if reader.has_stamp() => Some(reader.stamp_ns(message.data)),
            _ => None,
        };
        gauge.note(message.log_time_ns, stamp);
    }

    /// What was found, by topic.
    #[must_use]
    pub fn finish(self) -> BTreeMap<String, Rate> {
        self.topics.into_iter().map(|(topic, gauge)| (topic, gauge.finish())).collect()
    }
}

#[derive(Debug, Default)]
struct Gauge {
    messages: u64,
    first_ns: u64,
    last_ns: u64,
    log: Intervals,
    stamp: Intervals,
    stamps: Option<Stamps>,
}

impl Gauge {
    fn note(&mut self, log_ns: u64, stamp: Option<Result<Option<i64>, String>>) {
        self.first_ns = if self.messages == 0 { log_ns } else { self.first_ns.min(log_ns) };
        self.last_ns = self.last_ns.max(log_ns);
        self.messages += 1;
        let log_ns = i64::try_from(log_ns).unwrap_or(i64::MAX);
        self.log.note(log_ns);
        let Some(stamp) = stamp else { return };
        let stamps = self.stamps.get_or_insert_default();
        match stamp {
            Ok(Some(ns)) => {
                match self.stamp.latest.map(|latest| ns.cmp(&latest)) {
                    Some(std::cmp::Ordering::Less) => stamps.out_of_order += 1,
                    Some(std::cmp::Ordering::Equal) => stamps.duplicates += 1,
                    _ => {}
                }
                self.stamp.note(ns);
                let offset = ns.saturating_sub(log_ns);
                if offset.unsigned_abs() > stamps.largest_offset_ns.unsigned_abs() {
                    stamps.largest_offset_ns = offset;
                }
            }
            Ok(None) => stamps.unset += 1,
            Err(_) => stamps.malformed += 1,
        }
    }

    fn finish(self) -> Rate {
        let clock = match self.stamps {
            Some(Stamps { unset: 0, malformed: 0, .. }) => Clock::Stamp,
            _ => Clock::Log,
        };
        let intervals = if clock == Clock::Stamp { self.stamp } else { self.log };
        let interval_ns = intervals.median();
        let (gaps, longest_gaps) = interval_ns.map(|median| intervals.gaps(GAP * median)).unwrap_or_default();
        Rate {
            messages: self.messages,
            first_ns: self.first_ns,
            last_ns: self.last_ns,
            clock,
            interval_ns,
            gaps,
            longest_gaps,
            stamps: self.stamps,
        }
    }
}

/// Intervals between times that rise; a time that does not is passed over. They are counted in bins that are a sixty-fourth wide, some
/// thousand at most, with the sum of each, so that the mean of the middle bin is the median to much better than that.
#[derive(Debug, Default)]
struct Intervals {
    latest: Option<i64>,
    count: u64,
    bins: BTreeMap<u16, (u64, u128)>,
    longest: BTreeSet<(u64, i64)>,
}

impl Intervals {
    fn note(&mut self, ns: i64) {
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

    fn median(&self) -> Option<f64> {
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

    /// How many intervals are longer, and the longest of them.
    fn gaps(&self, over_ns: f64) -> (u64, Vec<Gap>) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is positive")]
        let limit = bin(over_ns as u64);
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
        let (count, listed) = intervals.gaps(5.0 * median);
        assert_eq!((count, listed.len()), (8, 8));
        assert!(listed.is_sorted_by_key(|gap| gap.from_ns));
        assert!(listed.iter().all(|gap| gap.length_ns > 99_000_000));
    }
}
