//! The joint states and wrenches of a log as columns on one clock.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_bag::{BagError, Item, Kind, Readers, Reading, scan};

use crate::MotionError;
use crate::clock::{Clock, Repaired, Times, repair};
use crate::gaps::TopicClock;
use crate::trouble::{Oddity, Trouble};

/// More wrenches than this are refused: they would need gigabytes of memory.
const MOST_WRENCHES: usize = 30_000_000;
/// Stamps that repeat with other numbers in more than this share of the messages are too coarse to be used.
const COARSE: f64 = 0.02;

/// Values over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series<T> {
    /// Times in s, rising.
    pub t_s: Vec<f64>,
    /// What was measured then.
    pub values: Vec<T>,
}

/// What a log says of the joints that matter and of the wrench.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Columns {
    /// The clock of all times.
    pub clock: Clock,
    /// Position of each joint asked for, in rad or m.
    pub joints: Vec<Series<f64>>,
    /// Force in N and torque in N m in the sensor's frame.
    pub wrenches: Series<[f64; 6]>,
    /// The frame that the first wrench names.
    pub frame: String,
    /// Names of joints that messages had.
    pub named: Vec<String>,
    /// What was odd.
    pub troubles: Vec<Trouble>,
    /// What is damaged in the file.
    pub damage: Vec<String>,
    /// Bytes of the file.
    pub bytes: u64,
    /// How regularly each topic came on this clock, joint states first.
    pub topics: Vec<TopicClock>,
    /// Whether there are clouds of points on some topic.
    pub has_clouds: bool,
}

/// What is to be read.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// Topics of joint states, which may share out the joints among them.
    pub joint_topics: &'a [String],
    /// The topic of the wrenches.
    pub wrench_topic: Option<&'a str>,
    /// Names of the joints.
    pub joints: &'a [String],
}

/// Messages of one topic in the order of the log.
#[derive(Default)]
struct Topic<T> {
    times: Vec<Times>,
    values: Vec<T>,
    malformed: Vec<i64>,
}

/// Reads topics of joint states, and one of wrenches.
///
/// # Errors
/// [`MotionError::Bag`] if the file cannot be read, is no recording, or to stop; [`MotionError::TooMany`].
pub fn columns(path: &Path, wanted: &Wanted<'_>, stop: &AtomicBool) -> Result<Columns, MotionError> {
    let Wanted { joint_topics, wrench_topic, joints } = *wanted;
    let mut readers = Readers::default();
    let mut states: Vec<Topic<Vec<(usize, f64)>>> = joint_topics.iter().map(|_| Topic::default()).collect();
    let mut wrenches: Topic<[f64; 6]> = Topic::default();
    let mut columns = Columns::default();
    let mut named: BTreeMap<String, Option<usize>> = BTreeMap::new();
    let ending = scan(path, &mut |item| -> Result<(), MotionError> {
        if stop.load(Ordering::Relaxed) {
            return Err(BagError::Stopped.into());
        }
        let Item::Message(message) = item else { return Ok(()) };
        let topic = message.channel.topic.as_str();
        let logged_ns = i64::try_from(message.log_time_ns).unwrap_or(i64::MAX);
        if Some(topic) == wrench_topic {
            match readers.read(&message) {
                Some(Ok(Reading::Wrench { stamp_ns, frame, wrench })) => {
                    if wrenches.values.is_empty() {
                        columns.frame = frame;
                    }
                    wrenches.times.push(Times { stamp_ns, logged_ns });
                    wrenches.values.push(wrench);
                }
                _ => wrenches.malformed.push(logged_ns),
            }
            if wrenches.values.len() > MOST_WRENCHES {
                return Err(MotionError::TooMany { what: "wrenches", most: MOST_WRENCHES });
            }
        } else if let Some(number) = joint_topics.iter().position(|known| known == topic)
            && let Some(state) = states.get_mut(number)
        {
            match readers.read(&message) {
                Some(Ok(Reading::Joints { stamp_ns, names, positions })) => {
                    let mut values = Vec::with_capacity(joints.len());
                    for (name, position) in names.into_iter().zip(positions) {
                        let place = named
                            .entry(name)
                            .or_insert_with_key(|name| joints.iter().position(|joint| joint == name));
                        values.extend(place.map(|place| (place, position)));
                    }
                    state.times.push(Times { stamp_ns, logged_ns });
                    state.values.push(values);
                }
                _ => state.malformed.push(logged_ns),
            }
        } else if !columns.has_clouds {
            let kind = readers.reader(&message).ok().and_then(soilctl_bag::Reader::kind);
            columns.has_clouds = kind == Some(Kind::Points);
        }
        Ok(())
    })?;
    (columns.damage, columns.bytes) = (ending.damage, ending.bytes);
    columns.named = named.into_keys().collect();
    columns.assemble(joint_topics, states, (wrench_topic, wrenches), joints.len());
    Ok(columns)
}

impl Columns {
    fn assemble(
        &mut self,
        joint_topics: &[String],
        states: Vec<Topic<Vec<(usize, f64)>>>,
        (wrench_topic, wrenches): (Option<&str>, Topic<[f64; 6]>),
        joints: usize,
    ) {
        let mut of_wrench = repair(&wrenches.times);
        let mut of_states: Vec<Repaired> = states.iter().map(|state| repair(&state.times)).collect();
        // The clock is that of the wrenches' stamps, or else of the joint states'.
        let latency_ns = of_wrench.latency_ns.or_else(|| of_states.iter().find_map(|state| state.latency_ns));
        of_wrench.onto(latency_ns);
        of_states.iter_mut().for_each(|state| state.onto(latency_ns));
        let all = || of_states.iter().chain([&of_wrench]).flat_map(|repaired| &repaired.times_ns);
        let clock = Clock::beginning(all().min().copied(), latency_ns);
        self.clock = clock;
        for (topic, malformed) in joint_topics
            .iter()
            .map(String::as_str)
            .zip(states.iter().map(|state| &state.malformed))
            .chain(wrench_topic.map(|topic| (topic, &wrenches.malformed)))
        {
            let times = malformed.iter().map(|ns| clock.seconds_of_log(*ns));
            self.trouble(topic, Oddity::Malformed, times);
        }
        self.joints = vec![Series::default(); joints];
        let mut values: Vec<Vec<(f64, f64)>> = vec![Vec::new(); joints];
        for ((topic, state), repaired) in joint_topics.iter().zip(&states).zip(&of_states) {
            self.told(topic, repaired);
            self.topics.push(TopicClock::of(topic, repaired, false, &clock));
            let mut not_finite = Vec::new();
            for (time, parts) in repaired.times_ns.iter().zip(&state.values) {
                let t_s = clock.seconds(*time);
                if parts.iter().any(|(_, value)| !value.is_finite()) {
                    not_finite.push(t_s);
                }
                for (place, value) in parts.iter().filter(|(_, value)| value.is_finite()) {
                    values[*place].push((t_s, *value));
                }
            }
            self.trouble(topic, Oddity::NotFinite, not_finite.into_iter());
        }
        let topic = joint_topics.first().map_or("", String::as_str);
        let mut twice = Vec::new();
        for (series, values) in self.joints.iter_mut().zip(values) {
            let (sorted, repeated) = sorted(values);
            twice.extend(repeated);
            *series = sorted;
        }
        twice.sort_by(f64::total_cmp);
        twice.dedup();
        self.trouble(topic, Oddity::Duplicate, twice.into_iter());
        if let Some(topic) = wrench_topic {
            self.wrenches(topic, wrenches, of_wrench);
        }
    }

    fn wrenches(&mut self, topic: &str, messages: Topic<[f64; 6]>, mut repaired: Repaired) {
        let clock = self.clock;
        let coarse = coarse(&repaired.times_ns, &messages.values);
        if coarse {
            let latency_ns = repaired.latency_ns.unwrap_or(0);
            repaired.times_ns =
                messages.times.iter().map(|times| times.logged_ns.saturating_sub(latency_ns)).collect();
            repaired.wrong_stamps = messages.times.len() as u64;
            repaired.disordered = 0;
        }
        self.told(topic, &repaired);
        self.topics.push(TopicClock::of(topic, &repaired, coarse, &clock));
        let mut values = Vec::with_capacity(messages.values.len());
        let mut not_finite = Vec::new();
        for (time, wrench) in repaired.times_ns.iter().zip(messages.values) {
            let t_s = clock.seconds(*time);
            if wrench.iter().all(|part| part.is_finite()) {
                values.push((t_s, wrench));
            } else {
                not_finite.push(t_s);
            }
        }
        self.trouble(topic, Oddity::NotFinite, not_finite.into_iter());
        let (series, twice) = sorted(values);
        self.wrenches = series;
        self.trouble(topic, Oddity::Duplicate, twice.into_iter());
    }

    /// Tells what was odd about a topic's times.
    fn told(&mut self, topic: &str, repaired: &Repaired) {
        let clock = self.clock;
        let ends = [repaired.times_ns.iter().min(), repaired.times_ns.iter().max()]
            .map(|time| time.map_or(0.0, |ns| clock.seconds(*ns)));
        for (what, count) in [
            (Oddity::Unstamped, repaired.unstamped),
            (Oddity::WrongStamps, repaired.wrong_stamps),
            (Oddity::Disordered, repaired.disordered),
        ] {
            if count > 0 {
                let [first_s, last_s] = ends;
                self.troubles.push(Trouble { topic: topic.to_owned(), what, count, first_s, last_s });
            }
        }
        for step in &repaired.steps {
            #[allow(clippy::cast_precision_loss, reason = "to be read")]
            let what = Oddity::ClockSet { by_s: step.by_ns as f64 * 1e-9 };
            let at_s = clock.seconds(step.at_ns);
            self.troubles.push(Trouble {
                topic: topic.to_owned(),
                what,
                count: 1,
                first_s: at_s,
                last_s: at_s,
            });
        }
    }

    /// Adds what is odd about messages of a topic at some times in s; nothing without a time.
    pub fn trouble(&mut self, topic: &str, what: Oddity, times_s: impl Iterator<Item = f64>) {
        let mut found: Option<Trouble> = None;
        for t_s in times_s {
            let trouble = found.get_or_insert_with(|| Trouble {
                topic: topic.to_owned(),
                what,
                count: 0,
                first_s: t_s,
                last_s: t_s,
            });
            trouble.count += 1;
            (trouble.first_s, trouble.last_s) = (trouble.first_s.min(t_s), trouble.last_s.max(t_s));
        }
        self.troubles.extend(found);
    }
}

/// Whether many messages with different numbers share a time.
fn coarse(times_ns: &[i64], values: &[[f64; 6]]) -> bool {
    let mut order: Vec<usize> = (0..times_ns.len()).collect();
    order.sort_by_key(|k| times_ns[*k]);
    let same = order.windows(2).filter(|pair| {
        let [a, b] = [pair[0], pair[1]];
        times_ns[a] == times_ns[b] && values[a] != values[b]
    });
    same.count() as f64 > COARSE * times_ns.len() as f64
}

/// In order of time, each time once; also the times of those that were left out.
fn sorted<T>(mut values: Vec<(f64, T)>) -> (Series<T>, Vec<f64>) {
    values.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut series =
        Series { t_s: Vec::with_capacity(values.len()), values: Vec::with_capacity(values.len()) };
    let mut twice = Vec::new();
    for (t_s, value) in values {
        if series.t_s.last() == Some(&t_s) {
            twice.push(t_s);
        } else {
            series.t_s.push(t_s);
            series.values.push(value);
        }
    }
    (series, twice)
}
