use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use soilctl_live::protocol::{Event, ServerMessage, StateMessage};

/// Events that are kept.
const KEPT: usize = 1000;

/// What the session has said, for whoever waits for it.
#[derive(Debug, Clone, Default)]
pub(super) struct Board(Arc<(Mutex<Content>, Condvar)>);

/// What stands on the board.
#[derive(Debug, Default)]
pub(super) struct Content {
    /// The last state.
    pub(super) state: Option<StateMessage>,
    /// States so far.
    pub(super) states: u64,
    /// The last events.
    pub(super) events: VecDeque<Event>,
    /// Events so far.
    pub(super) event_count: u64,
    /// Answers that nobody has taken: done, or what is wrong.
    answers: BTreeMap<u64, Result<u64, String>>,
    /// Why there will be no more.
    pub(super) ended: Option<String>,
}

/// How waiting ended.
pub(super) enum Waited<T> {
    Found(T),
    Ended(String),
    TimedOut,
}

impl Board {
    /// Notes a message.
    pub(super) fn note(&self, message: &ServerMessage) {
        let mut content = self.content();
        match message {
            ServerMessage::State(state) => {
                content.state = Some((**state).clone());
                content.states += 1;
            }
            ServerMessage::Event(event) => {
                content.events.push_back(event.clone());
                content.event_count += 1;
                if content.events.len() > KEPT {
                    content.events.pop_front();
                }
            }
            ServerMessage::Ack { id, tick } => {
                content.answers.insert(*id, Ok(*tick));
            }
            ServerMessage::Error { id: Some(id), message, .. } => {
                content.answers.insert(*id, Err(message.clone()));
            }
            ServerMessage::End { reason } => content.ended = Some(reason.clone()),
            ServerMessage::Error { id: None, .. }
            | ServerMessage::Hello(_)
            | ServerMessage::Configuration(_) => {}
        }
        self.0.1.notify_all();
    }

    /// There will be no more.
    pub(super) fn close(&self, reason: String) {
        self.content().ended.get_or_insert(reason);
        self.0.1.notify_all();
    }

    pub(super) fn content(&self) -> MutexGuard<'_, Content> {
        self.0.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until `find` finds something.
    pub(super) fn wait<T>(
        &self,
        timeout: Duration,
        mut find: impl FnMut(&mut Content) -> Option<T>,
    ) -> Waited<T> {
        let deadline = Instant::now() + timeout;
        let mut content = self.content();
        loop {
            if let Some(found) = find(&mut content) {
                return Waited::Found(found);
            }
            if let Some(reason) = &content.ended {
                return Waited::Ended(reason.clone());
            }
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Waited::TimedOut;
            }
            (content, _) = self.0.1.wait_timeout(content, left).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Waits for the answer to a command.
    pub(super) fn answer(&self, id: u64, timeout: Duration) -> Waited<Result<u64, String>> {
        self.wait(timeout, |content| content.answers.remove(&id))
    }
}
