use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread::JoinHandle;

use soilctl_session::messages::ControllerStep;
use soilctl_session::read::{Early, Item, scan};
use soilctl_session::{SessionError, topics};

use crate::LiveError;
use crate::protocol::{Event, Memory, StateMessage};

/// Steps between two states: some 31 a second.
const STATE_STEPS: u64 = 16;
/// What waits for the reader of a playback: some seconds, so that memory stays bounded.
const AHEAD: usize = 256;

/// A log as a session would have told it: states and events in their order.
#[derive(Debug)]
pub struct Playback {
    path: PathBuf,
    items: Receiver<Played>,
    thread: Option<JoinHandle<Result<(), SessionError>>>,
}

/// Something in a played log.
#[derive(Debug, Clone, PartialEq)]
pub enum Played {
    /// How things are.
    State(Box<StateMessage>),
    /// Something happened.
    Event(Event),
    /// Something is wrong with the file, in words; after all else.
    Damage(String),
}

impl Playback {
    /// Plays a log from a time in s on.
    ///
    /// # Errors
    /// [`LiveError::Thread`]; what is wrong with the log comes at the end, from [`Playback::next_item`].
    pub fn start(path: &Path, from_s: f64) -> Result<Self, LiveError> {
        let (sender, items) = sync_channel(AHEAD);
        let file = path.to_owned();
        let thread = std::thread::Builder::new()
            .name("playback".to_owned())
            .spawn(move || play(&file, from_s, &|item| sender.send(item).is_ok()))
            .map_err(|reason| LiveError::Thread { thread: "playback", reason })?;
        Ok(Self { path: path.to_owned(), items, thread: Some(thread) })
    }

    /// Begins anew at another time in s.
    ///
    /// # Errors
    /// As [`Playback::start`].
    pub fn seek(&mut self, time_s: f64) -> Result<(), LiveError> {
        // The reader of the old place ends when it finds nobody listening.
        *self = Self::start(&self.path, time_s)?;
        Ok(())
    }

    /// What comes next; none at the end of the log.
    ///
    /// # Errors
    /// [`LiveError::Session`] if the log cannot be read, or no further; [`LiveError::Lost`].
    pub fn next_item(&mut self) -> Result<Option<Played>, LiveError> {
        if let Ok(item) = self.items.recv() {
            return Ok(Some(item));
        }
        match self.thread.take().map(JoinHandle::join) {
            None => Ok(None),
            Some(Ok(done)) => Ok(done.map(|()| None)?),
            Some(Err(_)) => Err(LiveError::Lost("playback")),
        }
    }
}

/// Reads the log and hands out what there is from `from_s` on, until nobody takes it any more.
fn play(path: &Path, from_s: f64, take: &dyn Fn(Played) -> bool) -> Result<(), SessionError> {
    let mut memory = Memory::default();
    let mut steps = 0_u64;
    let mut last = None;
    let scanned = scan(path, &mut |item| {
        let Item::Message(message) = item else { return Ok(()) };
        if message.channel.topic != topics::STEP {
            return Ok(());
        }
        let take = |played| if take(played) { Ok(()) } else { Err(Early::Enough) };
        let step = soilctl_session::messages::decode::<ControllerStep>(message.data).map_err(|reason| {
            SessionError::Message { topic: topics::STEP.to_owned(), number: steps, reason }
        })?;
        memory.step(&step);
        let due = steps.is_multiple_of(STATE_STEPS);
        steps += 1;
        if crate::protocol::seconds(step.tick) < from_s {
            return Ok(());
        }
        for event in &step.events {
            take(Played::Event(Event::new(step.tick, event)))?;
        }
        if due {
            take(Played::State(Box::new(StateMessage::new(&step, &memory))))?;
            last = None;
        } else {
            last = Some(step);
        }
        Ok(())
    });
    let ending = match scanned {
        Ok(ending) => ending,
        Err(Early::Enough) => return Ok(()),
        Err(Early::Failed(error)) => return Err(error),
    };
    // The last state, whether it is due or not.
    let last = last.map(|step| Played::State(Box::new(StateMessage::new(&step, &memory))));
    let damage = ending.damage.into_iter().map(Played::Damage);
    // Nobody listens any more? Then there is nobody to tell.
    let _ = last.into_iter().chain(damage).all(take);
    Ok(())
}
