//! What a recording of any program holds, how regularly it came, and what is odd about it.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_bag::{Clock as Of, Container, Ending, Item, Kind, Rate, Rates, Stamps, kind};

use crate::look::look_through;
use crate::units::implausible;
use crate::{Clock, Columns, Look, MotionError, TopicClock, Trouble, Wanted, columns};

/// Gaps that are told of a topic, the longest.
const MOST_GAPS: usize = 10;
/// A topic with a gap after more than this share of its messages has no rate, but for some few gaps.
const IRREGULAR: f64 = 0.05;
/// So many gaps may be at any rate.
const FEW_GAPS: u64 = 3;

/// What a recording holds.
#[derive(Debug)]
pub struct Inspection {
    /// What it is kept in.
    pub container: Container,
    /// The clock of all times: that of the stamps of wrenches and joint states, or else of the stamps or log times there are.
    pub clock: Clock,
    /// Earliest and latest time of all topics in s.
    pub span_s: [f64; 2],
    /// Topics by name; what stands below `/truth` is left out.
    pub topics: BTreeMap<String, TopicReport>,
    /// Names of the attachments.
    pub attachments: Vec<String>,
    /// Whether there is a URDF in it.
    pub has_urdf: bool,
    /// What wrote it, if it says.
    pub library: String,
    /// What was odd about the messages of wrenches and joint states.
    pub troubles: Vec<Trouble>,
    /// Numbers that cannot be in the units that ROS has, in words.
    pub implausible: Vec<String>,
    /// How the reading ended.
    pub ending: Ending,
}

/// A topic, its times in s on the clock of the recording.
#[derive(Debug, Clone, PartialEq)]
pub struct TopicReport {
    /// Type of its messages.
    pub message_type: String,
    /// What they tell, if it is of a kind.
    pub kind: Option<Kind>,
    /// Why they cannot be read, if they cannot.
    pub problem: Option<String>,
    /// How many there are.
    pub messages: u64,
    /// Earliest and latest time.
    pub span_s: [f64; 2],
    /// Messages a second by the median interval; nothing for fewer than three intervals.
    pub rate_hz: Option<f64>,
    /// How many intervals are longer than five medians.
    pub gaps: u64,
    /// Begin and end of the longest of them, in order of time.
    pub longest_gaps: Vec<[f64; 2]>,
    /// Whether the messages come at a rate, so that gaps are something that is missing.
    pub is_regular: bool,
    /// What is odd about the stamps; nothing if there are none.
    pub stamps: Option<Stamps>,
}

/// Looks through a whole recording, twice.
///
/// # Errors
/// [`MotionError::Bag`] if it cannot be read, is no recording, or to stop. Damage is part of the answer.
pub fn inspect(path: &Path, stop: &AtomicBool) -> Result<Inspection, MotionError> {
    let container = kind(path)?;
    let mut rates = Rates::default();
    let look = look_through(path, stop, &mut |item| {
        if let Item::Message(message) = item {
            rates.note(message);
        }
    })?;
    let rates = rates.finish();
    let (columns, joints) = all_columns(path, &look, stop)?;
    let clock = columns.as_ref().map_or_else(|| clock_of(&rates), |columns| columns.clock);
    let mut topics = BTreeMap::new();
    for (name, topic) in &look.contents.topics {
        let Some(rate) = rates.get(name) else { continue };
        let of_topic = columns.iter().flat_map(|columns| &columns.topics).find(|of| of.topic == *name);
        let mut report = match of_topic {
            Some(of) => repaired(of),
            None => as_told(rate, &clock),
        };
        report.message_type.clone_from(&topic.message_type);
        (report.kind, report.problem, report.stamps) = (topic.kind, topic.problem.clone(), rate.stamps);
        report.messages = topic.messages;
        #[allow(clippy::cast_precision_loss, reason = "far below 2^53")]
        let most = IRREGULAR * report.messages as f64;
        #[allow(clippy::cast_precision_loss, reason = "far below 2^53")]
        let many = report.gaps as f64 > most;
        report.is_regular = report.rate_hz.is_some() && (report.gaps <= FEW_GAPS || !many);
        topics.insert(name.clone(), report);
    }
    let span = |all: [f64; 2], of: &TopicReport| [all[0].min(of.span_s[0]), all[1].max(of.span_s[1])];
    let first = topics.values().next().map_or([0.0; 2], |of| of.span_s);
    let contents = look.contents;
    Ok(Inspection {
        container,
        clock,
        span_s: topics.values().fold(first, span),
        topics,
        has_urdf: contents.urdf.is_some(),
        implausible: columns
            .as_ref()
            .map(|columns| implausible(columns, &joints, contents.urdf.as_deref()))
            .unwrap_or_default(),
        troubles: columns.map(|columns| columns.troubles).unwrap_or_default(),
        attachments: contents.attachments,
        library: contents.library,
        ending: contents.ending,
    })
}

/// The columns of all joints and of one topic of wrenches, and the names of the joints; nothing if there are none, or too many.
pub(crate) fn all_columns(
    path: &Path,
    look: &Look,
    stop: &AtomicBool,
) -> Result<(Option<Columns>, Vec<String>), MotionError> {
    let (joint_topics, names) = look.cover(Vec::new(), &|_| true);
    let wrench_topic = look.wrench_topic(None).ok().or_else(|| {
        let mut topics = look.contents.topics.iter();
        topics.find(|(_, topic)| topic.kind == Some(Kind::Wrench)).map(|(name, _)| name.clone())
    });
    let joints: Vec<String> = names.into_iter().collect();
    if joint_topics.is_empty() && wrench_topic.is_none() {
        return Ok((None, joints));
    }
    let wanted =
        Wanted { joint_topics: &joint_topics, wrench_topic: wrench_topic.as_deref(), joints: &joints };
    match columns(path, &wanted, stop) {
        Ok(columns) => Ok((Some(columns), joints)),
        Err(MotionError::TooMany { .. }) => Ok((None, joints)),
        Err(error) => Err(error),
    }
}

/// Where nothing tells of an arm, times count from the earliest there is.
fn clock_of(rates: &BTreeMap<String, Rate>) -> Clock {
    Clock::beginning(rates.values().map(|rate| rate.span_ns[0]).min(), None)
}

fn repaired(of: &TopicClock) -> TopicReport {
    let mut longest = of.gaps.clone();
    longest.sort_by(|a, b| (b[1] - b[0]).total_cmp(&(a[1] - a[0])).then(a[0].total_cmp(&b[0])));
    longest.truncate(MOST_GAPS);
    longest.sort_by(|a, b| a[0].total_cmp(&b[0]));
    TopicReport {
        span_s: [of.first_s, of.last_s],
        rate_hz: of.interval_s.map(|interval_s| 1.0 / interval_s),
        gaps: of.gaps.len() as u64,
        longest_gaps: longest,
        ..TopicReport::default()
    }
}

fn as_told(rate: &Rate, clock: &Clock) -> TopicReport {
    let seconds = |ns: i64| match rate.clock {
        Of::Stamp => clock.seconds(ns),
        Of::Log => clock.seconds_of_log(ns),
    };
    let gap = |gap: &soilctl_bag::Gap| {
        [gap.from_ns, gap.from_ns.saturating_add_unsigned(gap.length_ns)].map(seconds)
    };
    TopicReport {
        span_s: rate.span_ns.map(seconds),
        rate_hz: rate.rate_hz(),
        gaps: rate.gaps,
        longest_gaps: rate.longest_gaps.iter().map(gap).collect(),
        ..TopicReport::default()
    }
}

impl Default for TopicReport {
    fn default() -> Self {
        Self {
            message_type: String::new(),
            kind: None,
            problem: None,
            messages: 0,
            span_s: [0.0; 2],
            rate_hz: None,
            gaps: 0,
            longest_gaps: Vec::new(),
            is_regular: false,
            stamps: None,
        }
    }
}

impl Inspection {
    /// What is wrong with the content, in sentences; empty for a healthy recording.
    #[must_use]
    pub fn problems(&self) -> Vec<String> {
        let mut problems: Vec<String> = Vec::new();
        if self.topics.is_empty() {
            problems.push("there are no messages".to_owned());
        }
        let of_arm = |kind| matches!(kind, Some(Kind::Joints | Kind::Wrench));
        for (name, topic) in &self.topics {
            if topic.gaps > 0 && topic.is_regular && of_arm(topic.kind) {
                problems.push(gaps_in_words(name, topic));
            }
            if let Some(Stamps { malformed, .. }) = topic.stamps
                && malformed > 0
                && !of_arm(topic.kind)
            {
                problems
                    .push(format!("{name}: {malformed} messages are not of the type {}", topic.message_type));
            }
        }
        problems.extend(self.troubles.iter().map(ToString::to_string));
        problems.extend(self.implausible.iter().cloned());
        problems
    }
}

fn gaps_in_words(name: &str, topic: &TopicReport) -> String {
    let longest = topic.longest_gaps.iter().max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    let [from_s, to_s] = longest.copied().unwrap_or_default();
    let usual_s = topic.rate_hz.map_or(0.0, |rate_hz| 1.0 / rate_hz);
    let gaps = if topic.gaps == 1 { "a gap".to_owned() } else { format!("{} gaps, the longest", topic.gaps) };
    format!(
        "{name}: {gaps} of {:.3} s, from {from_s:.3} to {to_s:.3} s, where messages come every {usual_s:.4} s",
        to_s - from_s
    )
}
