use std::collections::BTreeMap;

use soilctl_session::read::{Channel, RawMessage};

use super::{Kind, Reader, Reading};

/// Readers of the channels of a recording, each made once.
#[derive(Debug, Default)]
pub struct Readers {
    known: Vec<(Channel, Result<Reader, String>)>,
    /// Places in `known` by the numbers of the channels.
    places: BTreeMap<u16, usize>,
}

impl Readers {
    /// None so far.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// What the messages of a channel tell, if it can be read and is of a kind.
    pub fn kind(&mut self, channel: &Channel) -> Option<Kind> {
        let place = self.place(channel);
        self.at(place).ok().and_then(Reader::kind)
    }

    /// What a message says; nothing if its channel is of no kind or cannot be read at all.
    pub fn read(&mut self, message: &RawMessage<'_>) -> Option<Result<Reading, String>> {
        self.reader(message).ok()?.read(message.data)
    }

    /// The reader of a message.
    ///
    /// # Errors
    /// Why its channel cannot be read, in words.
    pub fn reader(&mut self, message: &RawMessage<'_>) -> Result<&Reader, &str> {
        let channel = message.channel;
        let place = match self.places.get(&message.channel_id) {
            // Numbers of channels mean something within one recording only.
            Some(&place) if self.known.get(place).is_some_and(|(known, _)| is_same(known, channel)) => place,
            _ => {
                let place = self.place(channel);
                self.places.insert(message.channel_id, place);
                place
            }
        };
        self.at(place)
    }

    fn at(&self, place: usize) -> Result<&Reader, &str> {
        match self.known.get(place) {
            Some((_, reader)) => reader.as_ref().map_err(String::as_str),
            None => Err("its channel is not known"),
        }
    }

    fn place(&mut self, channel: &Channel) -> usize {
        if let Some(place) = self.known.iter().position(|(known, _)| is_same(known, channel)) {
            return place;
        }
        self.known.push((channel.clone(), Reader::of(channel)));
        self.known.len() - 1
    }
}

/// Whether messages of both are read in the same way.
fn is_same(a: &Channel, b: &Channel) -> bool {
    a.message_type == b.message_type
        && a.message_encoding == b.message_encoding
        && a.schema_encoding == b.schema_encoding
        && a.schema == b.schema
}
