//! Recordings of other programs.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_motion::{Inspection, TopicReport, inspect};

use super::Answer;
use super::answer::{Content, Found, Gap, Topic};
use crate::AppError;

/// What is in a recording of another program.
pub(super) fn look(path: &Path, action: &'static str, stop: &AtomicBool) -> Result<Answer, AppError> {
    let found = inspect(path, stop)?;
    let problems = if action == "doctor" { found.problems() } else { Vec::new() };
    Ok(Answer {
        action,
        whole: found.ending.is_whole(),
        damage: found.ending.damage.clone(),
        problems,
        content: Some(content(found)),
        written: None,
    })
}

fn content(found: Inspection) -> Content {
    let (some, [start_s, end_s]) = (!found.topics.is_empty(), found.span_s);
    let about = Found {
        container: found.container.to_string(),
        compression: found.ending.compressions.iter().cloned().collect(),
        clock_origin_s: found.clock.origin_s,
        duration_s: end_s - start_s,
        has_urdf: found.has_urdf,
        library: found.library,
        oddities: found.troubles.iter().map(ToString::to_string).collect(),
        implausible: found.implausible,
    };
    Content {
        start_s: some.then_some(start_s),
        end_s: some.then_some(end_s),
        topics: found.topics.into_iter().map(|(name, report)| topic(name, report)).collect(),
        attachments: found.attachments,
        found: Some(about),
        ..Content::default()
    }
}

fn topic(topic: String, report: TopicReport) -> Topic {
    let [start_s, end_s] = report.span_s;
    let gap = |[from_s, to_s]: [f64; 2]| Gap { from_s, to_s };
    Topic {
        topic,
        message_type: report.message_type,
        messages: report.messages,
        kind: report.kind.map(soilctl_bag::Kind::word),
        start_s: Some(start_s),
        end_s: Some(end_s),
        rate_hz: report.rate_hz,
        gaps: Some(report.gaps),
        longest_gaps: Some(report.longest_gaps.into_iter().map(gap).collect()),
        problem: report.problem,
    }
}
