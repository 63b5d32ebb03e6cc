#![doc = include_str!("../README.md")]

mod about;
mod error;
mod follow;
mod foreign;
mod layout;
mod rows;
mod rrd;
mod safe_force;
mod sandbox;
mod shapes;
mod style;

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufWriter, Read};
use std::path::Path;
use std::sync::atomic::AtomicBool;

pub use error::RecordingError;
use follow::Follower;
use rrd::Writer;
use soilctl_jobs::Beside;
pub use soilctl_live::protocol::{FORCE_M_PER_N, LEAD_SCALE};
pub use soilctl_motion::Settings;
use soilctl_session::{SessionError, is_own};

/// A layout for Foxglove: the arm, curves and states of the topics that soilctl writes.
pub const FOXGLOVE_LAYOUT: &str = include_str!("../foxglove.json");

/// A recording that was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Rows by entity, without what always holds.
    pub entities: BTreeMap<String, u64>,
    /// Steps of the controller in the log.
    pub steps: u64,
    /// Log time of the first and the last step in s; of another program's recording time of the first and the last state.
    pub span_s: [f64; 2],
    /// What is wrong with the log, in words; empty if it is whole.
    pub damage: Vec<String>,
    /// What else there is to know of another program's recording; nothing of a log of ours.
    pub foreign: Option<Foreign>,
}

/// Of another program's recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Foreign {
    /// States of the arm that are shown.
    pub states: usize,
    /// Where times begin, in s of the stamps: 0, or a whole second of a wall clock.
    pub clock_origin_s: i64,
    /// What was odd, or could not be used, in sentences.
    pub notes: Vec<String>,
}

/// Makes a recording for Rerun (`.rrd`) from a log that soilctl wrote, or from a recording of any program with joint states and a URDF. A
/// damaged one gives what can be read of it. The same log gives the same bytes. The file has its name only once it is whole. With
/// `settings` a log of ours is read like that of any other program.
///
/// # Errors
/// [`RecordingError::NotOurs`] if a log of ours lacks a configuration or steps, [`RecordingError::Arm`], [`RecordingError::Write`],
/// [`RecordingError::Session`] if the log cannot be read at all, or [`RecordingError::Motion`].
pub fn record(log: &Path, out: &Path, settings: &Settings) -> Result<Recording, RecordingError> {
    let beside = Beside::new(out);
    let own = *settings == Settings::default() && is_own(log, &AtomicBool::new(false));
    let recording = if own {
        write(log, &id(log)?, beside.path())?
    } else {
        foreign::write(log, settings, beside.path())?
    };
    beside.keep().map_err(|error| unwritten(out, &error.into()))?;
    Ok(recording)
}

fn write(log: &Path, id: &str, part: &Path) -> Result<Recording, RecordingError> {
    let file = File::create(part).map_err(|error| unwritten(part, &error.into()))?;
    let writer = Writer::new(BufWriter::new(file), id).map_err(|error| unwritten(part, &error))?;
    let mut follower = Follower::new(writer, log, part)?;
    let ending = soilctl_session::read::scan::<RecordingError>(log, &mut |item| follower.item(item))?;
    follower.finish(ending.damage)
}

/// From the beginning of the log and its length, so that two logs are two recordings in the viewer.
fn id(log: &Path) -> Result<String, RecordingError> {
    let failed =
        |error: std::io::Error| SessionError::File { path: log.to_owned(), reason: error.to_string() };
    let file = File::open(log).map_err(failed)?;
    let length = file.metadata().map_err(failed)?.len();
    let mut beginning = Vec::new();
    file.take(1 << 20).read_to_end(&mut beginning).map_err(failed)?;
    Ok(format!("{:08x}-{length:x}", crc32fast::hash(&beginning)))
}

fn unwritten(path: &Path, error: &rrd::WriteError) -> RecordingError {
    let reason = match error {
        rrd::WriteError::Io(error) => error.to_string(),
        rrd::WriteError::Arrow(error) => error.to_string(),
    };
    RecordingError::Write { path: path.to_owned(), reason }
}
