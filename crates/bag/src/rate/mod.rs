//! How regularly the messages of a recording come.

mod intervals;

use std::collections::BTreeMap;

use soilctl_session::read::RawMessage;

use self::intervals::Intervals;
use crate::Readers;
use crate::contents::is_truth;

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
    /// The earliest and the latest of these times in ns.
    pub span_ns: [i64; 2],
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
        let span_ns = [intervals.earliest, intervals.latest].map(Option::unwrap_or_default);
        let (gaps, longest_gaps) = interval_ns.map(|median| intervals.gaps(median)).unwrap_or_default();
        Rate {
            messages: self.messages,
            first_ns: self.first_ns,
            last_ns: self.last_ns,
            clock,
            span_ns,
            interval_ns,
            gaps,
            longest_gaps,
            stamps: self.stamps,
        }
    }
}
