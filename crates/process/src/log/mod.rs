//! Strokes out of logs, in one pass and in bounded memory.
//!
//! A log of our own controller ([`soilctl_session`]) says itself where strokes are, what arm it was and how the
//! stroke was meant; where a hand led the plate it only tells soil and plate. Of any other bag only joint states and wrenches are used; [`LogSettings`] tells the rest.
//! Topics under `/truth` are never looked at.

mod own;
mod rub;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_session::messages::{TfMessage, decode};
use soilctl_session::read::{Item, scan};
use soilctl_session::{CONFIGURATION_RECORD, SESSION_RECORD, SessionError};

use self::own::OwnLog;
pub use self::rub::{RubSample, read_wrenches};
use crate::foreign::{self, ForeignLog};
use crate::{Evaluated, Outcome, ProcessError};

/// How far a plate that is led by hand may go until its soil fails, in depths: loose soil takes a quarter of one.
const MOST_WAY_IN_DEPTHS: f64 = 1.0;

/// What a log of another program does not tell, or what shall be taken in place of what a log tells.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LogSettings {
    /// Topic of the joint states (`sensor_msgs/msg/JointState`); without it `/joint_states`, or the only one.
    pub joint_topic: Option<String>,
    /// Topic of the wrenches (`geometry_msgs/msg/WrenchStamped`); without it `/wrench`, or the only one.
    pub wrench_topic: Option<String>,
    /// Text of the URDF; without it the one in the log.
    pub urdf: Option<String>,
    /// Link at the plate's lower edge, z down along the plate; without it `plate_tip`.
    pub plate_frame: Option<String>,
    /// Link of the wrenches; without it the frame that their headers name.
    pub sensor_frame: Option<String>,
    /// Height of the soil in the URDF's root frame in m.
    pub surface_z_m: Option<f64>,
    /// Tool angle in deg; without it the one of the plate frame.
    pub alpha_deg: Option<f64>,
    /// Width of the plate in m.
    pub width_m: Option<f64>,
    /// Set-point of the interface friction in deg.
    pub delta_set_deg: Option<f64>,
    /// Wrench in free air in N and N m; without it that before each stroke.
    pub tare: Option<[f64; 6]>,
    /// Weight in N of what the sensor carries, if it is known: it turns with the sensor. Without it a log of another program tells it by
    /// free air in several postures.
    pub tool_weight_n: Option<f64>,
    /// Whose force the wrenches of a log of another program are.
    pub sense: Sense,
    /// Begin and end of each stroke in s, on the clock of the stamps; without them strokes are looked for.
    pub windows: Option<Vec<[f64; 2]>>,
}

/// Whose force on whom wrenches are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sense {
    /// The force of the soil on the plate, and the weight of the tool on the sensor.
    #[default]
    SoilOnPlate,
    /// What holds against them: all readings have the other sign.
    PlateOnSoil,
}

impl Sense {
    /// A reading as the force of the soil on the plate, with the bias and the weight that are in it.
    #[must_use]
    pub fn on_plate(self, wrench: [f64; 6]) -> [f64; 6] {
        match self {
            Self::SoilOnPlate => wrench,
            Self::PlateOnSoil => wrench.map(|part| -part),
        }
    }
}

impl LogSettings {
    /// Whether a log shall be read as one of another program, even if it is one of ours.
    fn is_foreign(&self) -> bool {
        self.joint_topic.is_some()
            || self.wrench_topic.is_some()
            || self.urdf.is_some()
            || self.sense != Sense::default()
            || self.windows.is_some()
    }
}

/// Displacement of the plate along its stroke by either set of encoders, in m, without any compensation; one value a
/// sample of the trace.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// By the external encoders.
    pub external_m: Vec<f64>,
    /// By the motors'.
    pub motor_m: Vec<f64>,
}

/// A stroke of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct LogStroke {
    /// Row, curve and failure. Whoever knows the log gives the stroke its name.
    pub evaluated: Evaluated,
    /// The two encoders' readings; `None` of bags, which have one.
    pub course: Option<Course>,
    /// How the controller says it ended.
    pub finish: Option<String>,
    /// What to keep in mind: words such as `encoder_jump`.
    pub flags: Vec<&'static str>,
    /// When it began, in s on the log's clock.
    pub start_s: f64,
    /// When it ended.
    pub end_s: f64,
}

/// A part of a log that looked like a stroke.
#[derive(Debug, Clone, PartialEq)]
pub struct NoStroke {
    /// Begin in s.
    pub from_s: f64,
    /// End in s.
    pub to_s: f64,
    /// Why it is none, or can't be used.
    pub reason: String,
    /// Whether it is a stroke that cannot be weighed, and not something else.
    pub refused: bool,
}

/// A piece of a log that may be a stroke.
#[derive(Debug, Clone, PartialEq)]
pub enum Candidate {
    /// A stroke.
    Stroke(Box<LogStroke>),
    /// It is none, or cannot be used.
    Rejected(NoStroke),
}

/// What is said of a log as a whole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LogSummary {
    /// Whether our own controller wrote it, and made its strokes; those of a hand are looked for as in a log of another program.
    pub own: bool,
    /// Bytes of the file.
    pub bytes: u64,
    /// What is damaged; it was left out.
    pub damage: Vec<String>,
    /// Messages that could not be used: late, repeated, malformed, or without joints around them.
    pub unusable: Vec<String>,
    /// What else was found in a log of another program.
    pub foreign: Option<ForeignLog>,
    /// The log's notes on its campaign: entries of its configuration beside arm, controller and plan.
    pub notes: BTreeMap<String, String>,
}

/// How a log is taken, once that is clear.
enum Taken {
    Unclear { session: BTreeMap<String, String> },
    Own(Box<OwnLog>),
}

/// Why the reading of a log ends before its end.
enum Ended {
    /// Another program wrote it, or it shall be read as if.
    Foreign,
    Failed(ProcessError),
}

impl From<ProcessError> for Ended {
    fn from(error: ProcessError) -> Self {
        Self::Failed(error)
    }
}

impl From<SessionError> for Ended {
    fn from(error: SessionError) -> Self {
        Self::Failed(error.into())
    }
}

/// Reads a log from beginning to end and hands over each stroke as soon as it is complete.
///
/// Memory is bounded by the longest stroke in a log of ours, and by the joint states and wrenches in one of another program, of which
/// all free air is needed. `stop` ends the reading.
///
/// # Errors
/// [`ProcessError::Log`] if the file can't be read or is no log; [`ProcessError::Missing`], [`ProcessError::Topic`],
/// [`ProcessError::Joints`], [`ProcessError::Urdf`] or [`ProcessError::NoFrame`] if something is missing in a bag;
/// [`ProcessError::Stopped`]. A stroke that can't be evaluated is no error, but a [`Candidate::Rejected`].
pub fn read_log(
    path: &Path,
    settings: &LogSettings,
    stop: &AtomicBool,
    found: &mut dyn FnMut(Candidate),
) -> Result<LogSummary, ProcessError> {
    let mut summary = LogSummary::default();
    let mut taken = Taken::Unclear { session: BTreeMap::new() };
    let mut visit = |item: Item<'_>| -> Result<(), Ended> {
        if stop.load(Ordering::Relaxed) {
            return Err(ProcessError::Stopped.into());
        }
        match (&mut taken, item) {
            (Taken::Unclear { session }, Item::Metadata { name: SESSION_RECORD, content }) => {
                session.clone_from(content);
            }
            (Taken::Unclear { session }, Item::Metadata { name: CONFIGURATION_RECORD, content }) => {
                summary.own = true;
                let known = ["arm", "controller", "plan"];
                let notes = content.iter().filter(|(key, _)| !known.contains(&key.as_str()));
                summary.notes = notes.map(|(key, value)| (key.clone(), value.clone())).collect();
                taken = Taken::Own(Box::new(OwnLog::new(
                    content,
                    session,
                    settings.tool_weight_n.unwrap_or(0.0),
                )?));
            }
            (Taken::Own(log), Item::Metadata { name, content }) => log.record(name, content),
            (Taken::Own(log), Item::Message(message)) => {
                log.message(&message)?;
                let (strokes, refused) = log.take();
                hand_over(strokes, refused, found);
            }
            (Taken::Unclear { .. }, Item::Message(_)) => return Err(Ended::Foreign),
            _ => {}
        }
        Ok(())
    };
    if settings.is_foreign() || soilctl_bag::kind(path)? != soilctl_bag::Container::Mcap {
        return foreign_log(path, settings, stop, found);
    }
    let ending = match scan(path, &mut visit) {
        Ok(ending) => ending,
        Err(Ended::Foreign) => return foreign_log(path, settings, stop, found),
        Err(Ended::Failed(error)) => return Err(error),
    };
    summary.bytes = ending.bytes;
    summary.damage = ending.damage;
    match taken {
        Taken::Own(mut log) => {
            log.end();
            if let Some(settings) = log.by_hand(settings) {
                let damage = std::mem::take(&mut summary.damage);
                let led = foreign_log(path, &settings, stop, &mut |candidate| found(by_hand(candidate)))?;
                return Ok(LogSummary { damage, notes: summary.notes, ..led });
            }
            let (strokes, refused) = log.take();
            hand_over(strokes, refused, found);
            if log.unreadable > 0 {
                summary.unusable.push(format!("{} steps cannot be read", log.unreadable));
            }
        }
        Taken::Unclear { .. } => return Err(ProcessError::Log("it has no messages".into())),
    }
    Ok(summary)
}

fn foreign_log(
    path: &Path,
    settings: &LogSettings,
    stop: &AtomicBool,
    found: &mut dyn FnMut(Candidate),
) -> Result<LogSummary, ProcessError> {
    let log = foreign::read(path, settings, stop, found)?;
    Ok(LogSummary {
        bytes: log.bytes,
        damage: log.damage.clone(),
        unusable: log.troubles.iter().map(ToString::to_string).collect(),
        foreign: Some(log),
        ..LogSummary::default()
    })
}

/// A drag by hand as it is taken: not where the soil seems to have failed only after a long way. A stroke of the controller ends before it has
/// heaped up much; a hand goes on, and the force that is greatest at the end is that of the heap.
fn by_hand(candidate: Candidate) -> Candidate {
    let Candidate::Stroke(stroke) = candidate else { return candidate };
    let Evaluated { row, analysis, .. } = &stroke.evaluated;
    let Outcome::Found(point) = &analysis.outcome else { return Candidate::Stroke(stroke) };
    if point.displacement_m <= MOST_WAY_IN_DEPTHS * row.depth_m {
        return Candidate::Stroke(stroke);
    }
    let reason = format!(
        "the force was greatest when the plate had gone {:.0} mm, at a depth of {:.0} mm: what it had heaped up lay ahead of it, and its \
         failure was missed; go on from a rest, by at most {MOST_WAY_IN_DEPTHS} times the depth, at 5 to 10 mm/s",
        1e3 * point.displacement_m,
        1e3 * row.depth_m
    );
    Candidate::Rejected(NoStroke { from_s: stroke.start_s, to_s: stroke.end_s, reason, refused: true })
}

fn hand_over(strokes: Vec<LogStroke>, refused: Vec<NoStroke>, found: &mut dyn FnMut(Candidate)) {
    strokes.into_iter().for_each(|stroke| found(Candidate::Stroke(Box::new(stroke))));
    refused.into_iter().for_each(|refused| found(Candidate::Rejected(refused)));
}

/// Height of the frame `soil_surface` in a `tf2_msgs/msg/TFMessage`, in m.
fn surface_in(message: &[u8]) -> Option<f64> {
    let frames: TfMessage = decode(message).ok()?;
    let found = frames.transforms.iter().rev().find(|frame| frame.child_frame_id == "soil_surface")?;
    Some(found.transform.translation.z).filter(|z| z.is_finite())
}
