use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use mcap::records::{MessageHeader, Metadata};
use mcap::write::NoSeek;
use mcap::{Attachment, McapError};
use soilctl_jobs::Beside;

use crate::error::reason;
use crate::read::{Ending, Item, RawMessage, scan_until};
use crate::write::options;
use crate::{SessionError, topics};

/// Messages between two flushes of a recovered file: about as many as in one second.
const FLUSH_MESSAGES: u64 = 2500;

/// What could be saved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recovery {
    /// Messages in the new file.
    pub messages: u64,
    /// Steps of the controller among them.
    pub steps: u64,
    /// How the reading of the damaged file ended; whole if nothing is lost.
    pub ending: Ending,
}

/// Copies what can be read of a log into a new, whole file with all indexes.
///
/// The new file is written beside its final name and moved there when it is done.
///
/// # Errors
/// Those of [`scan`](crate::read::scan), [`SessionError::NotALog`] if nothing can be saved, [`SessionError::File`] if the new file cannot
/// be written.
pub fn recover(path: &Path, out: &Path) -> Result<Recovery, SessionError> {
    recover_until(path, out, &AtomicBool::new(false))
}

/// [`recover`] that ends when `stop` is set; then there is no new file.
///
/// # Errors
/// [`SessionError::Stopped`], and those of [`recover`].
pub fn recover_until(path: &Path, out: &Path, stop: &AtomicBool) -> Result<Recovery, SessionError> {
    let beside = Beside::new(out);
    let recovery = copy(path, beside.path(), stop)?;
    beside.keep().map_err(|error| SessionError::file(out, &error))?;
    Ok(recovery)
}

fn copy(path: &Path, out: &Path, stop: &AtomicBool) -> Result<Recovery, SessionError> {
    let file = File::create(out).map_err(|error| SessionError::file(out, &error))?;
    let failed = |error: &McapError| SessionError::file(out, &reason(error));
    let mut copy = Copy {
        file: options().create(NoSeek::new(BufWriter::new(file))).map_err(|error| failed(&error))?,
        channels: BTreeMap::new(),
        items: 0,
        messages: 0,
        steps: 0,
    };
    let ending = scan_until(path, stop, &mut |item| copy.item(item).map_err(|error| failed(&error)))?;
    if copy.items == 0 {
        let reason = ending.damage.first().cloned().unwrap_or_else(|| "it is empty".to_owned());
        return Err(SessionError::NotALog { file: path.display().to_string(), reason });
    }
    copy.file.finish().map_err(|error| failed(&error))?;
    Ok(Recovery { messages: copy.messages, steps: copy.steps, ending })
}

struct Copy {
    file: mcap::Writer<NoSeek<BufWriter<File>>>,
    channels: BTreeMap<u16, u16>,
    items: u64,
    messages: u64,
    steps: u64,
}

impl Copy {
    fn item(&mut self, item: Item<'_>) -> Result<(), McapError> {
        match item {
            Item::Header { .. } => return Ok(()),
            Item::Message(message) => self.message(&message)?,
            Item::Metadata { name, content } => {
                let record = Metadata { name: name.to_owned(), metadata: content.clone() };
                self.file.write_metadata(&record)?;
            }
            Item::Attachment { name, media_type, log_time_ns, create_time_ns, data } => {
                self.file.attach(&Attachment {
                    log_time: log_time_ns,
                    create_time: create_time_ns,
                    name: name.to_owned(),
                    media_type: media_type.to_owned(),
                    data: data.into(),
                })?
            }
        }
        self.items += 1;
        Ok(())
    }

    fn message(&mut self, message: &RawMessage<'_>) -> Result<(), McapError> {
        let channel = message.channel;
        let channel_id = match self.channels.get(&message.channel_id) {
            Some(&known) => known,
            None => {
                let schema = if channel.message_type.is_empty() {
                    0
                } else {
                    self.file.add_schema(&channel.message_type, &channel.schema_encoding, &channel.schema)?
                };
                let (topic, encoding) = (&channel.topic, &channel.message_encoding);
                let new = self.file.add_channel(schema, topic, encoding, &channel.metadata)?;
                self.channels.insert(message.channel_id, new);
                new
            }
        };
        let header = MessageHeader {
            channel_id,
            sequence: message.sequence,
            log_time: message.log_time_ns,
            publish_time: message.publish_time_ns,
        };
        self.file.write_to_known_channel(&header, message.data)?;
        self.messages += 1;
        self.steps += u64::from(channel.topic == topics::STEP);
        if self.messages.is_multiple_of(FLUSH_MESSAGES) {
            self.file.flush()?;
        }
        Ok(())
    }
}
