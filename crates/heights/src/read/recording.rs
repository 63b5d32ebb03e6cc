//! Clouds of points in recordings.

use std::cell::Cell;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::Path;

use soilctl_bag::{BagError, Early, Item, Kind, Readers, Reading, contents, scan};

use crate::HeightsError;

/// The topic that depth cameras have if they have a single one.
const USUAL: &str = "/points";

/// Which cloud of a recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Moment {
    /// The first that has points.
    First,
    /// The last that has points.
    Last,
    /// The last that was logged at this time or before it, in s since the first one.
    At(f64),
}

/// A cloud of points of a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Cloud {
    /// Points with finite coordinates, in m.
    pub points: Vec<[f64; 3]>,
    /// Points without, left out.
    pub missing: usize,
    /// The frame that it names; empty if there is none.
    pub frame: String,
    /// When it was taken: its stamp, or else its log time, in ns.
    pub time_ns: i64,
    /// What is odd, in sentences.
    pub notes: Vec<String>,
}

/// When the clouds of a topic were taken.
#[derive(Debug, Clone, PartialEq)]
pub struct Clouds {
    /// The topic.
    pub topic: String,
    /// Those with points, by the time at which they were logged.
    pub taken: Vec<Taken>,
    /// What is odd about them or the recording, in sentences.
    pub notes: Vec<String>,
}

/// When a cloud was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taken {
    /// When it was logged, in ns.
    pub logged_ns: u64,
    /// When it was taken: its stamp, or else its log time, in ns.
    pub time_ns: i64,
}

/// When the clouds of a recording were taken, on a topic or on the only one that has clouds; `None` if no topic was asked for and none has any.
///
/// # Errors
/// [`HeightsError::Bag`] if it cannot be read, or has not the topic, or several of which none was asked for.
pub fn clouds(path: &Path, topic: Option<&str>) -> Result<Option<Clouds>, HeightsError> {
    let found = contents(path)?;
    if topic.is_none() && !found.topics.values().any(|topic| topic.kind == Some(Kind::Points)) {
        return Ok(None);
    }
    let topic = found.choose(topic, USUAL, Kind::Points)?;
    let (mut taken, mut unreadable) = (Vec::new(), Vec::new());
    messages(path, &topic, &mut |_| true, &mut |logged_ns, read| {
        match read {
            Ok(cloud) => taken.push(Taken { logged_ns, time_ns: cloud.time_ns }),
            Err(problem) => unreadable.push(problem),
        }
        ControlFlow::Continue(())
    })?;
    if let (true, Some(problem)) = (taken.is_empty(), unreadable.first()) {
        let reason = format!("none of its clouds can be read: {problem}");
        return Err(BagError::Unreadable { topic, reason }.into());
    }
    taken.sort_by_key(|taken| taken.logged_ns);
    let notes = notes(path, &topic, &unreadable, &found.ending.damage);
    Ok(Some(Clouds { topic, taken, notes }))
}

/// Reads a recording once more, and hands over the clouds of a topic that were logged at some of the times, as they are met, until enough are read.
///
/// # Errors
/// [`HeightsError::Bag`] if it cannot be read.
pub fn read_clouds(
    path: &Path,
    topic: &str,
    logged_ns: &BTreeSet<u64>,
    each: &mut dyn FnMut(u64, Cloud) -> ControlFlow<()>,
) -> Result<(), HeightsError> {
    // What cannot be read was told as the times were.
    messages(path, topic, &mut |time| logged_ns.contains(&time), &mut |time, read| match read {
        Ok(cloud) => each(time, cloud),
        Err(_) => ControlFlow::Continue(()),
    })
}

/// Clouds of a topic with points, by the time at which they were logged, of those times that are wanted; or why one cannot be read.
fn messages(
    path: &Path,
    topic: &str,
    wanted: &mut dyn FnMut(u64) -> bool,
    each: &mut dyn FnMut(u64, Result<Cloud, String>) -> ControlFlow<()>,
) -> Result<(), HeightsError> {
    let mut readers = Readers::new();
    let done = scan::<Early>(path, &mut |item| {
        let Item::Message(message) = item else { return Ok(()) };
        let time = message.log_time_ns;
        if message.channel.topic != topic || !wanted(time) {
            return Ok(());
        }
        let read = match readers.read(&message) {
            Some(Ok(Reading::Points { stamp_ns, frame, points, missing })) if !points.is_empty() => {
                let time_ns = stamp_ns.unwrap_or_else(|| i64::try_from(time).unwrap_or(i64::MAX));
                Ok(Cloud { points, missing, frame, time_ns, notes: Vec::new() })
            }
            Some(Err(problem)) => Err(problem),
            _ => return Ok(()),
        };
        match each(time, read) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Early::Enough),
        }
    });
    match done {
        Ok(_) | Err(Early::Enough) => Ok(()),
        Err(Early::Failed(error)) => Err(error.into()),
    }
}

/// What is odd about the clouds of a topic.
fn notes(path: &Path, topic: &str, unreadable: &[String], damage: &[String]) -> Vec<String> {
    let left_out = unreadable.first().map(|problem| {
        format!("{} clouds on {topic} cannot be read and are left out: {problem}", unreadable.len())
    });
    let damage = damage.iter().map(|damage| format!("{}: {damage}", path.display()));
    left_out.into_iter().chain(damage).collect()
}

/// Whether a file or folder is a recording.
#[must_use]
pub fn is_recording(path: &Path) -> bool {
    path.is_dir() || soilctl_bag::is_recording(path)
}

/// The cloud of a recording at a moment, on a topic or on the only one that has clouds.
///
/// # Errors
/// [`HeightsError::Bag`] if it cannot be read, or has no cloud with points then.
pub fn cloud(path: &Path, topic: Option<&str>, moment: Moment) -> Result<Cloud, HeightsError> {
    let found = contents(path)?;
    let topic = found.choose(topic, USUAL, Kind::Points)?;
    let first_ns = found.topics.get(&topic).map_or(0, |topic| topic.first_ns);
    let last_ns = match moment {
        Moment::First | Moment::Last => u64::MAX,
        Moment::At(seconds) => first_ns.saturating_add((seconds.max(0.0) * 1e9).round() as u64),
    };
    let (mut best, mut unreadable) = (None, Vec::new());
    let best_ns = Cell::new(None);
    // Messages of a recording need not be in the order of their times.
    let mut wanted = |time: u64| {
        let better = best_ns.get().is_none_or(|known| match moment {
            Moment::First => time < known,
            Moment::Last | Moment::At(_) => time >= known,
        });
        time <= last_ns && better
    };
    messages(path, &topic, &mut wanted, &mut |time, read| {
        match read {
            Ok(cloud) => {
                best_ns.set(Some(time));
                best = Some(cloud);
            }
            Err(problem) => unreadable.push(problem),
        }
        ControlFlow::Continue(())
    })?;
    let Some(mut cloud) = best else {
        let reason = match (unreadable.first(), moment) {
            (Some(problem), _) => format!("none of its clouds can be read: {problem}"),
            (None, Moment::At(seconds)) => format!("none of its clouds up to {seconds} s has points"),
            (None, Moment::First | Moment::Last) => "none of its clouds has points".to_owned(),
        };
        return Err(BagError::Unreadable { topic, reason }.into());
    };
    cloud.notes = notes(path, &topic, &unreadable, &found.ending.damage);
    Ok(cloud)
}
