use std::collections::{BTreeMap, VecDeque};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use soilctl_campaign::SoilPreset;
use soilctl_live::Commander;
use soilctl_live::protocol::{Command, Event, Problem, ServerMessage, StateMessage};

use crate::messages::{History, PageMessage, text};
use crate::soil::Surface;

/// Messages that wait for a page; what does not fit is left out and counted.
const MOST_WAITING: usize = 256;
/// Curves and events that a new page gets.
const MOST_STATES: usize = 3750;
const MOST_POINTS: usize = 1500;
const MOST_EVENTS: usize = 200;
/// Commands that wait for their answers.
const MOST_PENDING: usize = 64;

/// Between the session and the pages. Whoever locks it does so for microseconds, and the session is not among them.
#[derive(Debug, Default)]
pub(crate) struct Hub {
    inner: Mutex<Inner>,
    commander: Mutex<Option<Commander>>,
    /// Name of the soil that a page has chosen to be dug next.
    choice: Mutex<Option<String>>,
}

/// What is known of the session.
#[derive(Debug, Default)]
pub(crate) struct Inner {
    /// Hello and scene; they change with the session.
    pub(crate) greeting: Arc<[String]>,
    pub(crate) greetings: u64,
    /// The last state as text, and how many there were.
    pub(crate) state: Option<Arc<str>>,
    pub(crate) states: u64,
    /// The surface, its grid, and how often it has changed.
    pub(crate) soil: Option<([usize; 2], Arc<[i32]>)>,
    pub(crate) soils: u64,
    /// Whether the session is there, in words for the page, and how often that has changed.
    pub(crate) link: Option<Arc<str>>,
    pub(crate) links: u64,
    /// What is dug, where soils can be chosen, and how often that has changed.
    pub(crate) dig: Option<Arc<str>>,
    pub(crate) digs: u64,
    recent: VecDeque<StateMessage>,
    events: VecDeque<Event>,
    queues: BTreeMap<u64, VecDeque<Arc<str>>>,
    next_page: u64,
    /// Messages that pages did not take in time, which are gone or not.
    dropped: u64,
    /// Page and its id of each command, by the id under which it was sent.
    pending: BTreeMap<u64, (u64, u64)>,
}

impl Hub {
    pub(crate) fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A page chooses the soil that is dug next.
    ///
    /// # Errors
    /// In words, if there is nothing to choose or no such soil.
    pub(crate) fn choose(&self, soil: &str) -> Result<(), String> {
        if self.lock().dig.is_none() {
            return Err(
                "the soil of this session is that of its plan; `soilctl dig` has soils to choose".to_owned()
            );
        }
        let known = SoilPreset::named(soil).map_err(|error| error.to_string())?;
        *self.choice.lock().unwrap_or_else(PoisonError::into_inner) = Some(known.name);
        Ok(())
    }

    /// The soil that was chosen since somebody looked.
    pub(crate) fn take_choice(&self) -> Option<String> {
        self.choice.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    /// The session is there; commands go to `commander`.
    pub(crate) fn connect(&self, commander: Option<Commander>) {
        *self.commander.lock().unwrap_or_else(PoisonError::into_inner) = commander;
    }

    /// Sends a command of a page; says what is wrong if it cannot.
    pub(crate) fn command(&self, page: u64, id: u64, command: Command) -> Result<(), String> {
        let mut commander = self.commander.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(commander) = commander.as_mut() else {
            return Err("the session is not there; wait until it is".to_owned());
        };
        // Locked until it is noted: the answer may come at once. As few commands as may wait fit into the socket's buffer.
        let mut inner = self.lock();
        if inner.pending.len() >= MOST_PENDING {
            return Err("too many commands wait for their answers; wait for some".to_owned());
        }
        let sent = commander.send(command).map_err(|error| error.to_string())?;
        inner.pending.insert(sent, (page, id));
        Ok(())
    }
}

impl Inner {
    /// A new page, by number.
    pub(crate) fn join(&mut self) -> u64 {
        let page = self.next_page;
        self.next_page += 1;
        self.queues.insert(page, VecDeque::new());
        page
    }

    /// A page is gone.
    pub(crate) fn leave(&mut self, page: u64) {
        self.pending.retain(|_, (of, _)| *of != page);
        self.queues.remove(&page);
    }

    /// What waits for a page.
    pub(crate) fn take(&mut self, page: u64) -> VecDeque<Arc<str>> {
        self.queues.get_mut(&page).map(std::mem::take).unwrap_or_default()
    }

    /// A page took so many states too late.
    pub(crate) const fn skip(&mut self, states: u64) {
        self.dropped += states;
    }

    /// Messages that pages did not take in time.
    pub(crate) const fn dropped(&self) -> u64 {
        self.dropped
    }

    /// For all pages.
    pub(crate) fn tell_all(&mut self, message: &str) {
        let message: Arc<str> = message.into();
        for queue in self.queues.values_mut() {
            self.dropped += u64::from(!push(queue, &message));
        }
    }

    /// The page and its id of the command that was sent under an id.
    pub(crate) fn answered(&mut self, sent: u64) -> Option<(u64, u64)> {
        self.pending.remove(&sent)
    }

    /// The session is gone, or has not understood some command: the answers that are still open will not all come.
    pub(crate) fn give_up(&mut self, problem: Problem, message: &str) {
        for (page, id) in std::mem::take(&mut self.pending).into_values() {
            let message = message.to_owned();
            self.tell(page, &text(&ServerMessage::Error { id: Some(id), problem, message }));
        }
    }

    /// For one page.
    pub(crate) fn tell(&mut self, page: u64, message: &str) {
        if let Some(queue) = self.queues.get_mut(&page) {
            self.dropped += u64::from(!push(queue, &message.into()));
        }
    }

    /// Forgets what came from a session that is gone.
    pub(crate) fn begin(&mut self, greeting: Arc<[String]>) {
        self.state = None;
        self.recent.clear();
        self.events.clear();
        self.greet(greeting);
    }

    /// Greets all pages again; curves and events so far follow.
    pub(crate) fn greet(&mut self, greeting: Arc<[String]>) {
        self.greeting = greeting;
        self.greetings += 1;
        // With the surface, of which a page knows nothing after a greeting.
        self.soils += 1;
    }

    pub(crate) fn set_soil(&mut self, surface: &Surface) {
        let heights = surface.heights();
        if self.soil.as_ref().is_none_or(|(_, old)| **old != *heights) {
            (self.soil, self.soils) = (Some((surface.grid(), heights.into())), self.soils + 1);
        }
    }

    pub(crate) fn note_event(&mut self, event: Event) {
        self.events.push_back(event);
        if self.events.len() > MOST_EVENTS {
            self.events.pop_front();
        }
    }

    pub(crate) fn note_state(&mut self, state: StateMessage, words: String) {
        self.state = Some(words.into());
        self.states += 1;
        self.recent.push_back(state);
        if self.recent.len() > MOST_STATES {
            self.recent.pop_front();
        }
    }

    /// Curves and events so far, as messages.
    pub(crate) fn past(&self) -> Vec<String> {
        let mut history = History { replace: true, ..History::default() };
        let stride = (self.recent.len() / MOST_POINTS).max(1);
        for state in self.recent.iter().step_by(stride) {
            history.push(state);
        }
        let mut messages = vec![text(&PageMessage::History(history))];
        let event = |event: &Event| text(&ServerMessage::Event(event.clone()));
        messages.extend(self.events.iter().map(event));
        messages
    }

    pub(crate) fn set_dig(&mut self, message: String) {
        (self.dig, self.digs) = (Some(message.into()), self.digs + 1);
    }

    pub(crate) fn set_link(&mut self, connected: bool, message: String) {
        let link = text(&PageMessage::Link { connected, message });
        if self.link.as_deref() != Some(&link) {
            self.link = Some(link.into());
            self.links += 1;
        }
    }
}

/// Adds a message if there is room.
fn push(queue: &mut VecDeque<Arc<str>>, message: &Arc<str>) -> bool {
    let room = queue.len() < MOST_WAITING;
    if room {
        queue.push_back(Arc::clone(message));
    }
    room
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_that_takes_nothing_costs_bounded_memory_and_nobody_else_a_message() {
        let hub = Hub::default();
        let slow = hub.lock().join();
        let quick = hub.lock().join();
        let mut seen = 0;
        for number in 0..10_000 {
            hub.lock().tell_all(&number.to_string());
            seen += hub.lock().take(quick).len();
        }
        assert_eq!(seen, 10_000);
        assert_eq!(hub.lock().take(slow).len(), MOST_WAITING);
        assert_eq!(hub.lock().dropped(), 10_000 - MOST_WAITING as u64);
    }
}
