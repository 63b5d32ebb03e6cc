use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::Read;

use soilctl_session::read::{Channel, Ending, Item, RawMessage, decompress};

use super::MOST_BYTES;
use super::record::{self, Header, op};
use crate::damage::note;
use crate::scan::{Halt, Visit};

/// Bytes of all definitions together that are kept.
const MOST_HELD: usize = 256 << 20;

/// What a scan remembers: connections by their number.
#[derive(Debug, Default)]
pub(super) struct Content {
    connections: BTreeMap<u32, (u16, Channel)>,
    held: usize,
}

impl Content {
    pub(super) fn chunk(
        &mut self,
        header: Header<'_>,
        data: &[u8],
        ending: &mut Ending,
        visit: &mut Visit<'_>,
    ) -> Result<(), Halt> {
        let compression = header.text("compression").unwrap_or_default();
        let size = header.u32("size").unwrap_or(0);
        let unpacked = if size > MOST_BYTES {
            Err(format!("of {size} bytes is too large; the largest allowed is {MOST_BYTES}"))
        } else {
            unpack(&compression, data, size as usize)
        };
        let content = match unpacked {
            Ok(content) => content,
            Err(problem) => {
                note(&mut ending.damage, format!("a chunk {problem}; its messages are left out"));
                return Ok(());
            }
        };
        if compression != "none" && !ending.compressions.contains(&compression) {
            ending.compressions.insert(compression);
        }
        let mut rest = &*content;
        loop {
            match record::next(&mut rest) {
                Ok(Some((header, data))) => self.record(header, data, &mut ending.damage, visit)?,
                Ok(None) => return Ok(()),
                Err(problem) => {
                    note(&mut ending.damage, problem);
                    return Ok(());
                }
            }
        }
    }

    /// Connections and messages, inside chunks or not. Indexes and unknown records are passed over.
    pub(super) fn record(
        &mut self,
        header: Header<'_>,
        data: &[u8],
        damage: &mut Vec<String>,
        visit: &mut Visit<'_>,
    ) -> Result<(), Halt> {
        match header.op() {
            Some(op::CONNECTION) => match header.u32("conn") {
                Some(number) => self.connection(number, header, Header(data), damage),
                None => note(damage, "a connection has no number".to_owned()),
            },
            Some(op::MESSAGE) => {
                let (Some(number), Some(ns)) = (header.u32("conn"), header.ns("time")) else {
                    note(damage, "a message has no time or no connection".to_owned());
                    return Ok(());
                };
                let Some((channel_id, channel)) = self.connections.get(&number) else {
                    note(damage, format!("messages on connection {number}, which is not described"));
                    return Ok(());
                };
                return visit(Item::Message(RawMessage {
                    channel_id: *channel_id,
                    channel,
                    sequence: 0,
                    log_time_ns: ns,
                    publish_time_ns: ns,
                    data,
                }));
            }
            Some(_) => {}
            None => note(damage, "a record does not say what it is".to_owned()),
        }
        Ok(())
    }

    fn connection(&mut self, number: u32, outer: Header<'_>, inner: Header<'_>, damage: &mut Vec<String>) {
        const KNOWN: [&str; 3] = ["topic", "type", "message_definition"];
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let channel = Channel {
            topic: outer.text("topic").or_else(|| inner.text("topic")).unwrap_or_default(),
            message_type: inner.text("type").unwrap_or_default(),
            message_encoding: "ros1".to_owned(),
            schema_encoding: "ros1msg".to_owned(),
            schema: inner.get("message_definition").unwrap_or_default().to_vec(),
            metadata: inner
                .fields()
                .filter(|(name, _)| !KNOWN.iter().any(|known| known.as_bytes() == *name))
                .map(|(name, value)| (text(name), text(value)))
                .collect(),
        };
        // All connections stand once more at the end of the file.
        if let Some((_, known)) = self.connections.get(&number) {
            if *known != channel {
                note(damage, format!("connection {number} is both {} and {}", known.topic, channel.topic));
            }
            return;
        }
        let size = inner.0.len();
        match u16::try_from(self.connections.len()) {
            Ok(id) if self.held + size <= MOST_HELD => {
                self.held += size;
                self.connections.insert(number, (id, channel));
            }
            _ => note(damage, format!("there are too many connections; {} is left out", channel.topic)),
        }
    }
}

/// The records inside a chunk.
///
/// # Errors
/// In words, as the end of a sentence about the chunk.
fn unpack<'a>(compression: &str, data: &'a [u8], size: usize) -> Result<Cow<'a, [u8]>, String> {
    let content = match compression {
        "none" => Cow::Borrowed(data),
        "lz4" => decompress("lz4", data, size)?,
        "bz2" => {
            let mut plain = Vec::new();
            bzip2::read::BzDecoder::new(data)
                .take(size as u64 + 1)
                .read_to_end(&mut plain)
                .map_err(|error| format!("cannot be decompressed: {error}"))?;
            Cow::Owned(plain)
        }
        other => return Err(format!("is compressed with `{other}`; only bz2 and lz4 are known")),
    };
    if content.len() == size {
        Ok(content)
    } else {
        Err(format!("has {} bytes instead of {size}", content.len()))
    }
}
