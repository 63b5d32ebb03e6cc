//! The messages of any topic as a table.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_bag::{BagError, Ending, Item, Readers, scan};
use soilctl_columns::{Cell, Form, Kind, TableWriter};

use crate::clock::Times;
use crate::inspect::all_columns;
use crate::look::{listed, look_through};
use crate::{Clock, MotionError};

/// Most columns of a table.
const MOST_COLUMNS: usize = 10_000;
/// Most rows of a table; their times are held in memory.
const MOST_ROWS: usize = 100_000_000;

/// A table that was shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Rows: messages of the topic that can be read.
    pub rows: u64,
    /// Columns.
    pub columns: usize,
    /// Messages that cannot be read, and are left out.
    pub malformed: u64,
    /// The clock of its times.
    pub clock: Clock,
    /// How the reading of the recording ended.
    pub ending: Ending,
}

/// Name and kind of each column, the first of them `time_s`.
pub type Header = [(String, Kind)];

/// Shows the messages of a topic as rows of a table: first the time in s on the recording's one clock, then the fields by
/// [`cells`](soilctl_bag::Reader::cells). All rows have the same columns: what a message does not have is NaN, or text without a letter.
/// `begin` gets the columns before the first row.
///
/// # Errors
/// [`MotionError::NoTopic`], [`MotionError::Unreadable`], [`MotionError::TooMany`], [`MotionError::Bag`] if the recording cannot be
/// read or to stop, and what `begin` and `visit` return.
pub fn table(
    path: &Path,
    topic: &str,
    stop: &AtomicBool,
    begin: &mut dyn FnMut(&Header) -> Result<(), MotionError>,
    visit: &mut dyn FnMut(&[Cell<'static>]) -> Result<(), MotionError>,
) -> Result<Table, MotionError> {
    let mut plan = Plan::default();
    let look = look_through(path, stop, &mut |item| {
        if let Item::Message(message) = item
            && message.channel.topic == topic
        {
            plan.note(message);
        }
    })?;
    if plan.times.is_empty() && plan.malformed == 0 {
        let known = listed(look.contents.topics.keys());
        return Err(MotionError::NoTopic { topic: topic.to_owned(), known });
    }
    if plan.times.is_empty() {
        return Err(MotionError::Unreadable { topic: topic.to_owned(), reason: plan.problem });
    }
    for (what, count, most) in
        [("messages", plan.times.len(), MOST_ROWS), ("columns", plan.header.len(), MOST_COLUMNS)]
    {
        if count > most {
            return Err(MotionError::TooMany { what, most });
        }
    }
    let (columns, _) = all_columns(path, &look, stop)?;
    let (clock, by_log) = match columns {
        Some(columns) => {
            let of_topic = columns.topics.iter().find(|of| of.topic == topic);
            (columns.clock, of_topic.is_some_and(|of| of.by_log))
        }
        None => {
            let told = |times: &Times| times.stamp_ns.unwrap_or(times.logged_ns);
            (Clock::beginning(plan.times.iter().map(told).min(), None), false)
        }
    };
    if by_log {
        plan.times.iter_mut().for_each(|times| times.stamp_ns = None);
    }
    let times_ns = clock.place(&plan.times).times_ns;
    let mut times = times_ns.into_iter().map(|ns| Cell::Float(clock.seconds(ns)));
    let header = plan.header();
    begin(&header)?;
    let (mut readers, mut rows) = (Readers::new(), 0);
    let mut ending = scan(path, &mut |item| -> Result<(), MotionError> {
        if stop.load(Ordering::Relaxed) {
            return Err(BagError::Stopped.into());
        }
        let Item::Message(message) = item else { return Ok(()) };
        if message.channel.topic != topic {
            return Ok(());
        }
        let Some(cells) = readers.reader(&message).ok().and_then(|reader| reader.cells(message.data).ok())
        else {
            return Ok(());
        };
        let Some(time) = times.next() else { return Ok(()) };
        let mut row: Vec<Cell<'static>> = header.iter().map(|(_, kind)| missing(*kind)).collect();
        if let Some(first) = row.first_mut() {
            *first = time;
        }
        for (name, cell) in cells {
            let place = plan.places.get(&column_name(name)).map(|place| place + 1);
            if let Some((place, (_, kind))) =
                place.and_then(|place| Some((row.get_mut(place)?, header.get(place)?)))
            {
                *place = match kind {
                    Kind::Text if cell != Cell::Missing => Cell::Text(cell.to_string().into()),
                    _ => cell,
                };
            }
        }
        rows += 1;
        visit(&row)
    })?;
    if plan.malformed > 0 {
        ending.damage.push(format!(
            "{topic}: {} messages cannot be read and are left out: {}",
            plan.malformed, plan.problem
        ));
    }
    Ok(Table { rows, columns: header.len(), malformed: plan.malformed, clock, ending })
}

/// Writes the messages of a topic as a table, as [`table`] shows them. After an error there may be a part of it.
///
/// # Errors
/// [`MotionError::Write`], and those of [`table`].
pub fn write_table(
    path: &Path,
    topic: &str,
    out: &Path,
    form: Form,
    stop: &AtomicBool,
) -> Result<Table, MotionError> {
    let failed = |reason: &dyn std::fmt::Display| MotionError::Write {
        file: out.display().to_string(),
        reason: reason.to_string(),
    };
    let writer = std::cell::RefCell::new(None);
    let found = table(
        path,
        topic,
        stop,
        &mut |header| {
            let file = File::create(out).map_err(|error| failed(&error))?;
            let columns = header.iter().map(|(name, kind)| (name.as_str(), *kind));
            let made = TableWriter::new(form, file, "log", columns).map_err(|error| failed(&error))?;
            *writer.borrow_mut() = Some(made);
            Ok(())
        },
        &mut |row| {
            let mut writer = writer.borrow_mut();
            writer.as_mut().map_or(Ok(()), |writer| writer.row(row.iter()).map_err(|error| failed(&error)))
        },
    )?;
    let made = writer.into_inner();
    made.map_or(Ok(()), |made| made.finish().map(|_| ()).map_err(|error| failed(&error)))?;
    Ok(found)
}

/// What the first pass over a topic tells.
#[derive(Default)]
struct Plan {
    readers: Readers,
    header: Vec<(String, Kind)>,
    /// How many messages have each column.
    filled: Vec<u64>,
    places: BTreeMap<String, usize>,
    times: Vec<Times>,
    malformed: u64,
    problem: String,
}

impl Plan {
    fn note(&mut self, message: &soilctl_bag::RawMessage<'_>) {
        let read = match self.readers.reader(message) {
            Ok(reader) => {
                reader.cells(message.data).map(|cells| (cells, reader.stamp_ns(message.data).ok().flatten()))
            }
            Err(problem) => Err(problem.to_owned()),
        };
        let (cells, stamp_ns) = match read {
            Ok(read) => read,
            Err(problem) => {
                if self.malformed == 0 {
                    self.problem = problem;
                }
                self.malformed += 1;
                return;
            }
        };
        let logged_ns = i64::try_from(message.log_time_ns).unwrap_or(i64::MAX);
        self.times.push(Times { stamp_ns, logged_ns });
        for (name, cell) in cells {
            let name = column_name(name);
            if let Some(&place) = self.places.get(&name) {
                if let (Some((_, kind)), Some(filled)) =
                    (self.header.get_mut(place), self.filled.get_mut(place))
                {
                    *filled += 1;
                    *kind = if kind.takes(&cell) { *kind } else { Kind::Text };
                }
            } else if self.header.len() <= MOST_COLUMNS {
                self.places.insert(name.clone(), self.header.len());
                self.header.push((name, cell.kind()));
                self.filled.push(1);
            }
        }
    }

    /// The columns, the time first.
    fn header(&self) -> Vec<(String, Kind)> {
        let rows = self.times.len() as u64;
        let time = [("time_s".to_owned(), Kind::Float)];
        let fields = self.header.iter().zip(&self.filled).map(|((name, kind), filled)| {
            // Whole numbers and flags have no value that says that there is none.
            let whole = *kind == Kind::Float || *filled == rows;
            (name.clone(), if whole { *kind } else { Kind::Text })
        });
        time.into_iter().chain(fields).collect()
    }
}

/// The first column is the table's own.
fn column_name(name: String) -> String {
    if name == "time_s" { "message_time_s".to_owned() } else { name }
}

/// What stands for a cell that a message does not have.
const fn missing(kind: Kind) -> Cell<'static> {
    if matches!(kind, Kind::Float) { Cell::Float(f64::NAN) } else { Cell::Missing }
}
