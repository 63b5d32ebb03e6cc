use std::collections::BTreeMap;

use soilctl_session::read::{Channel, Item, RawMessage};

use crate::damage::note;
use crate::scan::{Halt, Visit};

/// Makes one recording of several files: a channel has one number in all of them, and there is one header.
#[derive(Debug, Default)]
pub(super) struct Join {
    channels: Vec<Channel>,
    /// Numbers of the channels of a topic.
    by_topic: BTreeMap<String, Vec<u16>>,
    /// Numbers in this part, and those in the whole.
    part: BTreeMap<u16, u16>,
    has_header: bool,
    pub(super) damage: Vec<String>,
}

impl Join {
    pub(super) fn next_part(&mut self) {
        self.part.clear();
    }

    pub(super) fn item(&mut self, item: Item<'_>, visit: &mut Visit<'_>) -> Result<(), Halt> {
        match item {
            Item::Header { .. } if std::mem::replace(&mut self.has_header, true) => Ok(()),
            Item::Message(message) => match self.number(&message) {
                Some(channel_id) => visit(Item::Message(RawMessage { channel_id, ..message })),
                None => Ok(()),
            },
            other => visit(other),
        }
    }

    fn number(&mut self, message: &RawMessage<'_>) -> Option<u16> {
        if let Some(number) = self.part.get(&message.channel_id) {
            return Some(*number);
        }
        let channel = message.channel;
        let same = self.by_topic.entry(channel.topic.clone()).or_default();
        let number =
            match same.iter().find(|&&number| self.channels.get(usize::from(number)) == Some(channel)) {
                Some(number) => *number,
                None => {
                    let Ok(number) = u16::try_from(self.channels.len()) else {
                        note(
                            &mut self.damage,
                            format!("there are too many channels; {} is left out", channel.topic),
                        );
                        return None;
                    };
                    self.channels.push(channel.clone());
                    same.push(number);
                    number
                }
            };
        self.part.insert(message.channel_id, number);
        Some(number)
    }
}
