use std::sync::Arc;

use soilctl_live::protocol::{ClientMessage, PROTOCOL_VERSION, Problem};

use super::Hub;
use crate::feed::{Rights, refuse};
use crate::messages::{PageMessage, text};
use crate::soil::Known;

/// A page at a session. Of states, surfaces and the link it takes the latest; the rest waits in its queue.
pub(crate) struct Operator {
    hub: Arc<Hub>,
    page: u64,
    greetings: u64,
    states: u64,
    soils: u64,
    links: u64,
    digs: u64,
    known: Known,
}

impl Operator {
    pub(crate) fn new(hub: Arc<Hub>) -> Self {
        let mut inner = hub.lock();
        let (page, states) = (inner.join(), inner.states.saturating_sub(1));
        drop(inner);
        Self { hub, page, greetings: 0, states, soils: 0, links: 0, digs: 0, known: Known::default() }
    }

    pub(crate) fn poll(&mut self, tell: &mut dyn FnMut(String)) {
        let mut inner = self.hub.lock();
        let waiting = inner.take(self.page);
        let fresh = self.greetings != inner.greetings;
        let greeting = fresh.then(|| (Arc::clone(&inner.greeting), inner.past()));
        let soil = (self.soils != inner.soils).then(|| inner.soil.clone()).flatten();
        let state = (self.states != inner.states).then(|| inner.state.clone()).flatten();
        let skipped = inner.states.saturating_sub(self.states + 1);
        inner.skip(skipped);
        let link = (self.links != inner.links).then(|| inner.link.clone()).flatten();
        let dig = (self.digs != inner.digs).then(|| inner.dig.clone()).flatten();
        (self.greetings, self.soils, self.states, self.links, self.digs) =
            (inner.greetings, inner.soils, inner.states, inner.links, inner.digs);
        drop(inner);
        if let Some((greeting, past)) = greeting {
            self.known = Known::default();
            greeting.iter().cloned().for_each(&mut *tell);
            // The queue's events are among those of the past.
            past.into_iter().for_each(&mut *tell);
            waiting
                .iter()
                .filter(|message| !message.contains(EVENT))
                .for_each(|message| tell((**message).to_owned()));
        } else {
            waiting.iter().for_each(|message| tell((**message).to_owned()));
        }
        if let Some((grid, heights)) = soil
            && let Some(patch) = self.known.update(grid, &heights)
        {
            tell(text(&PageMessage::Soil(patch)));
        }
        for message in [state, link, dig].into_iter().flatten() {
            tell((*message).to_owned());
        }
    }

    /// Which soil shall be dug next.
    pub(crate) fn choose(&self, id: u64, soil: &str, rights: &Rights) -> (Option<String>, Option<String>) {
        if !rights.authorized {
            return refuse(Some(id), Problem::Forbidden, "commands need the token; open the address with it");
        }
        match self.hub.choose(soil) {
            Ok(()) => (None, None),
            Err(message) => refuse(Some(id), Problem::Value, &message),
        }
    }

    pub(crate) fn obey(&self, message: ClientMessage, rights: &Rights) -> (Option<String>, Option<String>) {
        match message {
            ClientMessage::Hello { protocol: PROTOCOL_VERSION } => (None, None),
            ClientMessage::Hello { protocol } => {
                let message = format!("this monitor speaks protocol {PROTOCOL_VERSION}, not {protocol}");
                refuse(None, Problem::Protocol, &message)
            }
            ClientMessage::Describe {} => {
                refuse(None, Problem::Unavailable, "the scene says what the monitor knows")
            }
            ClientMessage::Command { id, .. } if rights.token.is_none() => {
                refuse(Some(id), Problem::Unavailable, "commands are off; start the monitor with --commands")
            }
            ClientMessage::Command { id, .. } if !rights.authorized => {
                refuse(Some(id), Problem::Forbidden, "commands need the token; open the address with it")
            }
            ClientMessage::Command { id, command } => match self.hub.command(self.page, id, command) {
                Ok(()) => (None, None),
                Err(message) => refuse(Some(id), Problem::Unavailable, &message),
            },
        }
    }
}

/// How an event begins.
const EVENT: &str = "\"type\":\"event\"";

impl Drop for Operator {
    fn drop(&mut self) {
        self.hub.lock().leave(self.page);
    }
}
