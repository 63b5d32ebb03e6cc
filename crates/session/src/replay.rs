use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_columns::Cell;
use soilctl_controller::{Params, State, step};

use crate::fields::cells;
use crate::messages::{ControllerStep, Keyframe};
use crate::read::{Ending, Item, RawMessage, scan_until};
use crate::setup::{CONFIGURATION_RECORD, SESSION_RECORD};
use crate::{SessionError, SessionSetup, cdr, topics};

/// What a replay found.
#[derive(Debug, Clone, PartialEq)]
pub struct Replay {
    /// Steps that were run again and compared.
    pub steps: u64,
    /// Steps with an output of other bits.
    pub different_steps: u64,
    /// Steps that could not be run again, because steps before them are not in the log.
    pub skipped_steps: u64,
    /// Key frames that were compared with the state of the replay.
    pub keyframes: u64,
    /// The first output that differs.
    pub first_difference: Option<Difference>,
    /// How the reading of the file ended.
    pub ending: Ending,
}

impl Replay {
    /// Whether every bit of every output and of every key frame is the same.
    #[must_use]
    pub const fn is_identical(&self) -> bool {
        self.first_difference.is_none()
    }
}

/// An output that is not what the log says.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Number of the step.
    pub step: u64,
    /// The tick it answered.
    pub tick: u64,
    /// Field of `/controller/step`, or `state` for a key frame.
    pub field: String,
    /// What the log says.
    pub logged: Cell<'static>,
    /// What the replay gave.
    pub replayed: Cell<'static>,
}

/// Runs the controller again on the inputs of a log, from key frame `from` on (0 is the beginning), and compares every
/// bit of every output. Where steps are missing it goes on from the next key frame.
///
/// # Errors
/// [`SessionError::Missing`] if the log has no settings or no steps, [`SessionError::NoKeyframe`],
/// [`SessionError::Version`] for a log of another program, [`SessionError::Message`] for a malformed message, those of
/// [`SessionSetup::params`], and those of [`scan`](crate::read::scan).
pub fn replay(path: &Path, from: u32) -> Result<Replay, SessionError> {
    replay_until(path, from, &AtomicBool::new(false))
}

/// [`replay`] that ends when `stop` is set.
///
/// # Errors
/// [`SessionError::Stopped`], and those of [`replay`].
pub fn replay_until(path: &Path, from: u32, stop: &AtomicBool) -> Result<Replay, SessionError> {
    let file = path.display().to_string();
    let mut run = Run::new(&file, from);
    let ending = scan_until(path, stop, &mut |item| run.item(item))?;
    if run.keyframes_met <= from {
        if run.keyframes_met == 0 {
            let advice = "only logs that soilctl wrote can be replayed";
            let what = format!("key frame on {}", topics::KEYFRAME);
            return Err(SessionError::Missing { file, what, advice });
        }
        return Err(SessionError::NoKeyframe { wanted: from, available: run.keyframes_met });
    }
    Ok(Replay { ending, ..run.answer })
}

struct Run<'a> {
    file: &'a str,
    from: u32,
    records: BTreeMap<String, BTreeMap<String, String>>,
    params: Option<Params>,
    /// State before the step of this number; none before the first key frame and where steps are missing.
    state: Option<(u64, State)>,
    keyframes_met: u32,
    messages: u64,
    buffer: Vec<u8>,
    answer: Replay,
}

impl<'a> Run<'a> {
    fn new(file: &'a str, from: u32) -> Self {
        Self {
            file,
            from,
            records: BTreeMap::new(),
            params: None,
            state: None,
            keyframes_met: 0,
            messages: 0,
            buffer: Vec::new(),
            answer: Replay {
                steps: 0,
                different_steps: 0,
                skipped_steps: 0,
                keyframes: 0,
                first_difference: None,
                ending: Ending::default(),
            },
        }
    }

    fn item(&mut self, item: Item<'_>) -> Result<(), SessionError> {
        match item {
            Item::Metadata { name: name @ (SESSION_RECORD | CONFIGURATION_RECORD), content } => {
                self.records.insert(name.to_owned(), content.clone());
                Ok(())
            }
            Item::Message(message) if message.channel.topic == topics::KEYFRAME => self.keyframe(&message),
            Item::Message(message) if message.channel.topic == topics::STEP => self.step(&message),
            _ => Ok(()),
        }
    }

    fn keyframe(&mut self, message: &RawMessage<'_>) -> Result<(), SessionError> {
        let number = self.keyframes_met;
        self.keyframes_met = self.keyframes_met.saturating_add(1);
        let frame: Keyframe = cdr::decode(message.data)
            .map_err(|reason| malformed(topics::KEYFRAME, u64::from(number), reason))?;
        if number < self.from {
            return Ok(());
        }
        match &self.state {
            // The replay must have come to the same state by itself.
            Some((step, state)) if *step == frame.step => {
                let mine = Keyframe::new(frame.number, frame.step, state)?;
                self.answer.keyframes += 1;
                if mine != frame && self.answer.first_difference.is_none() {
                    let text = |frame: &Keyframe| Cell::Text(format!("{} bytes", frame.state.len()).into());
                    self.answer.first_difference = Some(Difference {
                        step: frame.step,
                        tick: state.tick,
                        field: "state".to_owned(),
                        logged: text(&frame),
                        replayed: text(&mine),
                    });
                }
            }
            _ => self.state = Some((frame.step, frame.state()?)),
        }
        Ok(())
    }

    fn step(&mut self, message: &RawMessage<'_>) -> Result<(), SessionError> {
        let number = self.messages;
        self.messages += 1;
        if self.keyframes_met <= self.from {
            return Ok(());
        }
        let bad = |reason| malformed(topics::STEP, number, reason);
        let logged: ControllerStep = cdr::decode(message.data).map_err(bad)?;
        let Some((due, mut state)) = self.state.take().filter(|(due, _)| *due == logged.step) else {
            self.answer.skipped_steps += 1;
            return Ok(());
        };
        if self.params.is_none() {
            let record = |name: &str| self.records.get(name);
            let setup =
                SessionSetup::from_records(self.file, record(SESSION_RECORD), record(CONFIGURATION_RECORD))?;
            self.params = Some(setup.params()?);
        }
        let Some(params) = &self.params else { return Ok(()) };
        let (sensed, commands) = (logged.sensed(), logged.commands().map_err(bad)?);
        let outputs = step(params, &mut state, &sensed, &commands);
        self.state = Some((due + 1, state));
        self.answer.steps += 1;
        let replayed = ControllerStep::new(logged.step, &sensed, &commands, &outputs);
        cdr::encode(&replayed, &mut self.buffer).map_err(|error| bad(error.to_string()))?;
        if self.buffer == message.data {
            return Ok(());
        }
        let first = cells(&logged).into_iter().zip(cells(&replayed)).find(|((_, a), (_, b))| !a.is_same(b));
        // Bytes between the fields have no meaning.
        let Some(((field, logged_cell), (_, replayed_cell))) = first else { return Ok(()) };
        self.answer.different_steps += 1;
        if self.answer.first_difference.is_none() {
            self.answer.first_difference = Some(Difference {
                step: logged.step,
                tick: logged.tick,
                field,
                logged: logged_cell,
                replayed: replayed_cell,
            });
        }
        Ok(())
    }
}

fn malformed(topic: &str, number: u64, reason: String) -> SessionError {
    SessionError::Message { topic: topic.to_owned(), number, reason }
}
