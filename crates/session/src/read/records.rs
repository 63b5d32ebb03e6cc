use std::collections::{BTreeMap, BTreeSet};

use mcap::records::{self, Record};

use super::{Channel, Item, MOST_BYTES, RawMessage, chunk, parse};

/// What a scan remembers: schemas and channels by their number.
#[derive(Debug, Default)]
pub(super) struct Log {
    pub(super) has_header: bool,
    schemas: BTreeMap<u16, (String, String, Vec<u8>)>,
    channels: BTreeMap<u16, Channel>,
    /// Bytes of all schemas that the channels hold, each its own.
    held: usize,
    pub(super) compressions: BTreeSet<String>,
}

impl Log {
    /// Looks at one record of the file; what is wrong is added to `damage`.
    ///
    /// # Errors
    /// What `visit` returns.
    pub(super) fn record<E>(
        &mut self,
        opcode: u8,
        data: &[u8],
        damage: &mut Vec<String>,
        visit: &mut dyn FnMut(Item<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        match parse(opcode, data) {
            Ok(Record::Header(header)) => {
                self.has_header = true;
                visit(Item::Header { profile: &header.profile, library: &header.library })
            }
            Ok(Record::Chunk { header, data }) => self.chunk(&header, &data, damage, visit),
            Ok(Record::Metadata(record)) => {
                visit(Item::Metadata { name: &record.name, content: &record.metadata })
            }
            Ok(Record::Attachment { header, data, .. }) => visit(Item::Attachment {
                name: &header.name,
                media_type: &header.media_type,
                log_time_ns: header.log_time,
                create_time_ns: header.create_time,
                data: &data,
            }),
            Ok(record) => self.content(record, damage, visit),
            Err(problem) => {
                note(damage, problem);
                Ok(())
            }
        }
    }

    fn chunk<E>(
        &mut self,
        header: &records::ChunkHeader,
        data: &[u8],
        damage: &mut Vec<String>,
        visit: &mut dyn FnMut(Item<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        self.compressed(&header.compression);
        let content = match chunk::unpack(header, data) {
            Ok(content) => content,
            Err(problem) => {
                let [from, to] =
                    [header.message_start_time, header.message_end_time].map(|time| time / 1_000_000);
                note(damage, format!("{problem}; its messages of {from} to {to} ms are left out"));
                return Ok(());
            }
        };
        let mut rest = &*content;
        loop {
            let record = chunk::next(&mut rest)
                .and_then(|next| next.map(|(opcode, data)| parse(opcode, data)).transpose());
            match record {
                Ok(Some(record)) => self.content(record, damage, visit)?,
                Ok(None) => return Ok(()),
                Err(problem) => {
                    note(damage, problem);
                    return Ok(());
                }
            }
        }
    }

    fn compressed(&mut self, name: &str) {
        // A damaged file may have another name in every chunk.
        const MOST: usize = 8;
        if !name.is_empty() && self.compressions.len() < MOST && !self.compressions.contains(name) {
            self.compressions.insert(name.chars().take(32).collect());
        }
    }

    /// Schemas, channels and messages, inside chunks or not. Indexes, statistics and unknown records are passed over.
    fn content<E>(
        &mut self,
        record: Record<'_>,
        damage: &mut Vec<String>,
        visit: &mut dyn FnMut(Item<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        match record {
            Record::Schema { header, data } => {
                self.schemas.insert(header.id, (header.name, header.encoding, data.into_owned()));
            }
            Record::Channel(channel) => {
                let (message_type, schema_encoding, schema) =
                    self.schemas.get(&channel.schema_id).cloned().unwrap_or_default();
                let channel_id = channel.id;
                let channel = Channel {
                    topic: channel.topic,
                    message_type,
                    message_encoding: channel.message_encoding,
                    schema_encoding,
                    schema,
                    metadata: channel.metadata,
                };
                match self.channels.get(&channel_id) {
                    Some(known) if *known != channel => note(
                        damage,
                        format!("channel {channel_id} is both {} and {}", known.topic, channel.topic),
                    ),
                    Some(_) => {}
                    // A file of some megabytes may name one large schema for thousands of channels.
                    None if self.held + channel.schema.len() > MOST_BYTES => {
                        note(damage, format!("the schemas are too large; {} is left out", channel.topic));
                    }
                    None => {
                        self.held += channel.schema.len();
                        self.channels.insert(channel_id, channel);
                    }
                }
            }
            Record::Message { header, data } => match self.channels.get(&header.channel_id) {
                Some(channel) => visit(Item::Message(RawMessage {
                    channel_id: header.channel_id,
                    channel,
                    sequence: header.sequence,
                    log_time_ns: header.log_time,
                    publish_time_ns: header.publish_time,
                    data: &data,
                }))?,
                None => {
                    note(damage, format!("messages on channel {}, which is not described", header.channel_id))
                }
            },
            _ => {}
        }
        Ok(())
    }
}

/// Notes a problem once, and not more of them than anybody reads.
fn note(damage: &mut Vec<String>, problem: String) {
    const MOST: usize = 100;
    if damage.len() < MOST && damage.last() != Some(&problem) {
        damage.push(problem);
    }
}

/// Bytes before the content of an attachment: two times, two texts with their length, the length of the content.
pub(super) fn attachment_header_length(data: &[u8]) -> Option<usize> {
    let mut place = 16_usize;
    for _ in 0..2 {
        let length = data.get(place..)?.first_chunk::<4>()?;
        place = place.checked_add(4)?.checked_add(usize::try_from(u32::from_le_bytes(*length)).ok()?)?;
    }
    place.checked_add(8).filter(|&end| end <= data.len())
}
