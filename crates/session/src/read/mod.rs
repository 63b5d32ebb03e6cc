//! Reading logs from beginning to end in bounded memory, whatever state they are in.

mod chunk;
mod records;

use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use mcap::records::{Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};

pub use self::chunk::decompress;

use crate::SessionError;
use crate::error::reason;

/// Largest record, and largest chunk after decompression, in bytes. Our own chunks have some megabytes.
const MOST_BYTES: usize = 256 << 20;
/// Bytes read at a time.
const READ_BYTES: usize = 1 << 16;

/// A channel of a log with its type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Channel {
    /// The topic.
    pub topic: String,
    /// Type of the messages; empty if the log does not say.
    pub message_type: String,
    /// How the messages are encoded.
    pub message_encoding: String,
    /// How the type's definition is written.
    pub schema_encoding: String,
    /// The type's definition.
    pub schema: Vec<u8>,
    /// Metadata of the channel.
    pub metadata: BTreeMap<String, String>,
}

/// A message as it stands in a log.
#[derive(Debug, Clone, Copy)]
pub struct RawMessage<'a> {
    /// Number of the channel in this file.
    pub channel_id: u16,
    /// The channel.
    pub channel: &'a Channel,
    /// Sequence number on its channel.
    pub sequence: u32,
    /// Log time in ns.
    pub log_time_ns: u64,
    /// Publishing time in ns.
    pub publish_time_ns: u64,
    /// The encoded message.
    pub data: &'a [u8],
}

/// What a scan meets, in the order of the file.
#[derive(Debug, Clone, Copy)]
pub enum Item<'a> {
    /// Profile and library of the file.
    Header {
        /// The profile, for example `ros2`.
        profile: &'a str,
        /// What wrote the file.
        library: &'a str,
    },
    /// A message.
    Message(RawMessage<'a>),
    /// A metadata record.
    Metadata {
        /// Its name.
        name: &'a str,
        /// Its content.
        content: &'a BTreeMap<String, String>,
    },
    /// An attachment.
    Attachment {
        /// Its name.
        name: &'a str,
        /// Its media type.
        media_type: &'a str,
        /// Log time in ns.
        log_time_ns: u64,
        /// Time at which it was made in ns.
        create_time_ns: u64,
        /// Its content.
        data: &'a [u8],
    },
}

/// How a scan ended.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Ending {
    /// Everything that is wrong, in words; empty for a whole file whose checksums hold.
    pub damage: Vec<String>,
    /// Bytes of the file that were read.
    pub bytes: u64,
    /// How parts of the file are compressed, by the names of the format; empty for a file that is not.
    pub compressions: BTreeSet<String>,
}

impl Ending {
    /// Whether the file is whole and its checksums hold.
    #[must_use]
    pub const fn is_whole(&self) -> bool {
        self.damage.is_empty()
    }
}

/// Why a visitor ends a scan before the end of the file.
#[derive(Debug)]
pub enum Early {
    /// It has seen enough.
    Enough,
    /// The scan failed.
    Failed(SessionError),
}

impl From<SessionError> for Early {
    fn from(error: SessionError) -> Self {
        Self::Failed(error)
    }
}

/// Shows every item of a log to `visit`, which ends the scan by an error of its own, such as [`Early::Enough`]. A damaged chunk is left out and noted; what comes after a broken record cannot
/// be found and is lost. Items are only shown once their checksums were compared, where they have one of their own.
///
/// # Errors
/// [`SessionError::File`] if the file cannot be read, [`SessionError::NotALog`] if it does not begin like a log, or what
/// `visit` returns.
pub fn scan<E: From<SessionError>>(
    path: &Path,
    visit: &mut dyn FnMut(Item<'_>) -> Result<(), E>,
) -> Result<Ending, E> {
    let mut file = File::open(path).map_err(|error| SessionError::file(path, &error))?;
    scan_from(&mut file, path, visit)
}

/// [`scan`] that ends when `stop` is set, by whatever thread.
///
/// # Errors
/// [`SessionError::Stopped`], and those of [`scan`].
pub fn scan_until(
    path: &Path,
    stop: &AtomicBool,
    visit: &mut dyn FnMut(Item<'_>) -> Result<(), SessionError>,
) -> Result<Ending, SessionError> {
    scan(path, &mut |item| {
        if stop.load(Ordering::Relaxed) { Err(SessionError::Stopped) } else { visit(item) }
    })
}

/// [`scan`] of any source of bytes; `path` is named in messages.
///
/// # Errors
/// Those of [`scan`].
pub fn scan_from<E: From<SessionError>>(
    source: &mut dyn Read,
    path: &Path,
    visit: &mut dyn FnMut(Item<'_>) -> Result<(), E>,
) -> Result<Ending, E> {
    let not_a_log = |reason: String| SessionError::NotALog { file: path.display().to_string(), reason };
    let options = LinearReaderOptions::default()
        .with_emit_chunks(true)
        .with_validate_data_section_crc(true)
        .with_validate_summary_section_crc(true)
        .with_check_finishes_after_end_magic(true)
        .with_record_length_limit(MOST_BYTES);
    let mut reader = LinearReader::new_with_options(options);
    let mut log = records::Log::default();
    let mut ending = Ending::default();
    while let Some(event) = reader.next_event() {
        match event {
            Ok(LinearReadEvent::ReadRequest(need)) => {
                // A length that is wrong must not reserve more than the file has.
                let room = reader.insert(need.min(READ_BYTES));
                let read = read_some(source, room).map_err(|error| SessionError::file(path, &error))?;
                ending.bytes += read as u64;
                reader.notify_read(read);
            }
            Ok(LinearReadEvent::Record { opcode, data }) => {
                if !log.has_header && opcode != op::HEADER {
                    return Err(not_a_log("it does not begin with a header".to_owned()).into());
                }
                let before = ending.damage.len();
                log.record(opcode, data, &mut ending.damage, visit)?;
                if !log.has_header {
                    let reason = ending.damage.get(before).cloned().unwrap_or_default();
                    return Err(not_a_log(reason).into());
                }
            }
            Err(error) if !log.has_header => return Err(not_a_log(reason(&error)).into()),
            Err(error) => {
                ending.damage.push(match error {
                    mcap::McapError::UnexpectedEof => {
                        format!(
                            "the file ends after {} bytes in the middle, as after a kill or a crash",
                            ending.bytes
                        )
                    }
                    other => format!("within the first {} bytes: {}", ending.bytes, reason(&other)),
                });
                break;
            }
        }
    }
    ending.compressions = log.compressions;
    Ok(ending)
}

/// Reads until something came, the end, or a failure that does not pass.
fn read_some(source: &mut dyn Read, room: &mut [u8]) -> std::io::Result<usize> {
    loop {
        match source.read(room) {
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            other => return other,
        }
    }
}

/// Parses a record without trusting it.
pub(crate) fn parse(opcode: u8, data: &[u8]) -> Result<Record<'_>, String> {
    // The library takes for granted that an attachment is longer than its header.
    if opcode == op::ATTACHMENT && records::attachment_header_length(data).is_none_or(|n| n + 4 > data.len())
    {
        return Err("an attachment is malformed".to_owned());
    }
    mcap::parse_record(opcode, data).map_err(|error| reason(&error))
}
