//! Writing Rerun's file format (`.rrd`, version 2 of the frame): a header of 12 bytes, then messages, each with its kind
//! and its length. Messages are protocol buffers; data travel in them as Arrow streams compressed by LZ4. The index at the
//! end is optional and left out.

mod chunk;
mod column;
mod proto;

use std::collections::BTreeMap;
use std::io::Write;

use arrow_schema::ArrowError;

use chunk::Times;
pub(crate) use column::{Column, Component, Values};
use proto::{Kind, Message};

/// Name of the application in the viewer; layouts belong to it.
const APPLICATION: &str = "soilctl";
/// Name of the time line: seconds since the log's clock began.
const TIMELINE: &str = "time";
/// The version of Rerun whose files these are.
const VERSION: [u8; 4] = [0, 41, 0, 0];
/// Rows of an entity that are written together.
const CHUNK_ROWS: usize = 4096;

const STORE_INFO: u64 = 1;
const ARROW: u64 = 2;
const ACTIVATION: u64 = 3;

/// The number of a row or of a chunk; later ones are larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Id(u64);

impl Id {
    /// Where other writers put the time of day.
    const fn high(self) -> u64 {
        1
    }

    const fn low(self) -> u64 {
        self.0
    }
}

/// Why a file could not be written.
#[derive(Debug)]
pub(crate) enum WriteError {
    Io(std::io::Error),
    Arrow(ArrowError),
}

impl From<std::io::Error> for WriteError {
    fn from(error: std::io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<ArrowError> for WriteError {
    fn from(error: ArrowError) -> Self {
        Self::Arrow(error)
    }
}

/// Rows that wait to be written.
#[derive(Debug)]
struct Waiting {
    times_ns: Vec<i64>,
    rows: Vec<Id>,
    columns: Vec<Column>,
}

/// A file that is being written.
pub(crate) struct Writer<W> {
    file: W,
    recording: Message,
    id: String,
    last: u64,
    waiting: BTreeMap<String, Waiting>,
    written: BTreeMap<String, u64>,
}

impl<W: Write> Writer<W> {
    /// Begins a recording of this id; the viewer takes recordings with one id for the same.
    pub(crate) fn new(mut file: W, id: &str) -> Result<Self, WriteError> {
        const LZ4_AND_PROTOBUF: [u8; 4] = [1, 2, 0, 0];
        file.write_all(b"RRF2")?;
        file.write_all(&VERSION)?;
        file.write_all(&LZ4_AND_PROTOBUF)?;
        let mut writer = Self {
            file,
            recording: proto::store(Kind::Recording, id),
            id: id.to_owned(),
            last: 0,
            waiting: BTreeMap::new(),
            written: BTreeMap::new(),
        };
        let row = writer.next();
        let info = proto::set_store_info(row, &writer.recording);
        writer.message(STORE_INFO, &info)?;
        Ok(writer)
    }

    /// One row that always holds.
    pub(crate) fn fixed(&mut self, entity: &str, columns: &[Column]) -> Result<(), WriteError> {
        let (chunk, row) = (self.next(), self.next());
        let ipc = chunk::ipc(entity, chunk, &[row], Times::Static, columns)?;
        let message = proto::arrow(&self.recording, chunk, true, &ipc);
        self.message(ARROW, &message)
    }

    /// One row at a time of the log. Rows of an entity have the same columns.
    pub(crate) fn row(&mut self, entity: &str, time_ns: i64, columns: Vec<Column>) -> Result<(), WriteError> {
        let row = self.next();
        let full = match self.waiting.get_mut(entity) {
            None => {
                let waiting = Waiting { times_ns: vec![time_ns], rows: vec![row], columns };
                self.waiting.insert(entity.to_owned(), waiting);
                false
            }
            Some(waiting) => {
                waiting.times_ns.push(time_ns);
                waiting.rows.push(row);
                waiting.columns.iter_mut().zip(columns).for_each(|(all, one)| all.append(one));
                waiting.rows.len() >= CHUNK_ROWS
            }
        };
        if full { self.flush(entity) } else { Ok(()) }
    }

    fn flush(&mut self, entity: &str) -> Result<(), WriteError> {
        let Some(waiting) = self.waiting.remove(entity) else { return Ok(()) };
        *self.written.entry(entity.to_owned()).or_default() += waiting.rows.len() as u64;
        let chunk = self.next();
        let ipc = chunk::ipc(entity, chunk, &waiting.rows, Times::Log(&waiting.times_ns), &waiting.columns)?;
        let message = proto::arrow(&self.recording, chunk, false, &ipc);
        self.message(ARROW, &message)
    }

    /// The layout: entities of its own with one row each.
    pub(crate) fn layout(&mut self, entities: &[(String, Vec<Column>)]) -> Result<(), WriteError> {
        let layout = proto::store(Kind::Blueprint, &format!("{}-layout", self.id));
        let row = self.next();
        self.message(STORE_INFO, &proto::set_store_info(row, &layout))?;
        for (entity, columns) in entities {
            let (chunk, row) = (self.next(), self.next());
            let ipc = chunk::ipc(entity, chunk, &[row], Times::Blueprint, columns)?;
            self.message(ARROW, &proto::arrow(&layout, chunk, false, &ipc))?;
        }
        self.message(ACTIVATION, &proto::activate(&layout))
    }

    /// Writes what waits; tells how many rows there are by entity, without those that always hold.
    pub(crate) fn finish(mut self) -> Result<BTreeMap<String, u64>, WriteError> {
        for entity in self.waiting.keys().cloned().collect::<Vec<_>>() {
            self.flush(&entity)?;
        }
        self.file.flush()?;
        Ok(self.written)
    }

    fn message(&mut self, kind: u64, message: &Message) -> Result<(), WriteError> {
        let bytes = message.as_bytes();
        self.file.write_all(&kind.to_le_bytes())?;
        self.file.write_all(&(bytes.len() as u64).to_le_bytes())?;
        Ok(self.file.write_all(bytes)?)
    }

    const fn next(&mut self) -> Id {
        self.last += 1;
        Id(self.last)
    }
}
