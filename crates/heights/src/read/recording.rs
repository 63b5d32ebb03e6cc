//! Clouds of points in recordings.

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
}

/// When a cloud was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taken {
    /// When it was logged, in s since the first message of its topic, as in [`Moment::At`].
    pub at_s: f64,
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
    let first_ns = found.topics.get(&topic).map_or(0, |topic| topic.first_ns);
    let (mut readers, mut taken, mut unreadable) = (Readers::new(), Vec::new(), None);
    let done = scan::<Early>(path, &mut |item| {
        let Item::Message(message) = item else { return Ok(()) };
        if message.channel.topic != topic {
            return Ok(());
        }
        match readers.read(&message) {
            Some(Ok(Reading::Points { stamp_ns, points, .. })) if !points.is_empty() => {
                let logged = message.log_time_ns;
                let time_ns = stamp_ns.unwrap_or_else(|| i64::try_from(logged).unwrap_or(i64::MAX));
                taken.push(Taken { at_s: logged.saturating_sub(first_ns) as f64 / 1e9, time_ns });
            }
            Some(Err(problem)) => unreadable = Some(problem),
            _ => {}
        }
        Ok(())
    });
    match done {
        Ok(_) | Err(Early::Enough) => {}
        Err(Early::Failed(error)) => return Err(error.into()),
    }
    if let (true, Some(problem)) = (taken.is_empty(), unreadable) {
        let reason = format!("none of its clouds can be read: {problem}");
        return Err(BagError::Unreadable { topic, reason }.into());
    }
    taken.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    Ok(Some(Clouds { topic, taken }))
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
    let (mut readers, mut cloud, mut unreadable) = (Readers::new(), None::<(u64, Cloud)>, Vec::new());
    let done = scan::<Early>(path, &mut |item| {
        let Item::Message(message) = item else { return Ok(()) };
        let time = message.log_time_ns;
        // Messages of a recording need not be in the order of their times.
        let better = cloud.as_ref().is_none_or(|(known, _)| match moment {
            Moment::First => time < *known,
            Moment::Last | Moment::At(_) => time >= *known,
        });
        if message.channel.topic != topic || time > last_ns || !better {
            return Ok(());
        }
        match readers.read(&message) {
            Some(Ok(Reading::Points { stamp_ns, frame, points, missing })) if !points.is_empty() => {
                let time_ns = stamp_ns.unwrap_or_else(|| i64::try_from(time).unwrap_or(i64::MAX));
                cloud = Some((time, Cloud { points, missing, frame, time_ns, notes: Vec::new() }));
                Ok(())
            }
            Some(Err(problem)) => {
                unreadable.push(problem);
                Ok(())
            }
            _ => Ok(()),
        }
    });
    match done {
        Ok(_) | Err(Early::Enough) => {}
        Err(Early::Failed(error)) => return Err(error.into()),
    }
    let Some((_, mut cloud)) = cloud else {
        let reason = match (unreadable.first(), moment) {
            (Some(problem), _) => format!("none of its clouds can be read: {problem}"),
            (None, Moment::At(seconds)) => format!("none of its clouds up to {seconds} s has points"),
            (None, Moment::First | Moment::Last) => "none of its clouds has points".to_owned(),
        };
        return Err(BagError::Unreadable { topic, reason }.into());
    };
    if let Some(problem) = unreadable.first() {
        let count = unreadable.len();
        cloud.notes.push(format!("{count} clouds on {topic} cannot be read and are left out: {problem}"));
    }
    cloud.notes.extend(found.ending.damage.iter().map(|damage| format!("{}: {damage}", path.display())));
    Ok(cloud)
}
