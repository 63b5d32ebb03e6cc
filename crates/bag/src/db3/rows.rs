use rusqlite::types::ValueRef;
use rusqlite::{Params, Row, Statement};
use soilctl_session::read::{Item, RawMessage};

use super::open::Database;
use super::topics::Channels;
use crate::damage::note;
use crate::scan::{Halt, Visit};

/// Shows all messages by their times, and those of one time in the order of writing. First only the times are read, so that sorting them,
/// where there is no index, takes little memory; then each message by its number.
pub(super) fn show(
    database: &Database,
    channels: &Channels,
    damage: &mut Vec<String>,
    visit: &mut Visit<'_>,
) -> Result<(), Halt> {
    let connection = &database.connection;
    let mut fetch = match connection.prepare("SELECT topic_id, timestamp, data FROM messages WHERE id = ?1") {
        Ok(fetch) => fetch,
        Err(error) => {
            note(damage, format!("the messages cannot be read: {error}"));
            return Ok(());
        }
    };
    let mut all = Messages {
        database,
        channels,
        damage,
        last: None,
        rows: 0,
        // No file holds more rows or more bytes of messages than it has bytes.
        rows_left: database.bytes / 4,
        bytes_left: database.bytes,
        lost: 0,
        reason: String::new(),
    };
    let ordered = "SELECT id, timestamp FROM messages ORDER BY timestamp, id";
    let mut stopped = all.pass(ordered, [], &mut fetch, visit)?;
    if let Some(reason) = &stopped {
        note(
            all.damage,
            format!(
                "the order of the messages cannot be read any further: {reason}; the others are shown as they were written"
            ),
        );
        let (time, id) = all.last.unwrap_or((i64::MIN, i64::MIN));
        let rest = "SELECT id, timestamp FROM messages NOT INDEXED WHERE timestamp > ?1 OR (timestamp = ?1 AND id > ?2)";
        stopped = all.pass(rest, [time, id], &mut fetch, visit)?;
        if let Some(reason) = &stopped {
            note(all.damage, format!("the messages cannot be read any further: {reason}"));
        }
    }
    if stopped.is_none() {
        all.count();
    }
    if all.lost > 0 {
        let problem = format!("{} messages cannot be read, the first because {}", all.lost, all.reason);
        note(all.damage, problem);
    }
    Ok(())
}

struct Messages<'a> {
    database: &'a Database,
    channels: &'a Channels,
    damage: &'a mut Vec<String>,
    /// Time and number of the last row.
    last: Option<(i64, i64)>,
    rows: u64,
    rows_left: u64,
    bytes_left: u64,
    lost: u64,
    /// Why the first of them was lost.
    reason: String,
}

impl Messages<'_> {
    /// Shows the messages of a query for numbers and times. Returns why it ended before its end, if it did.
    fn pass(
        &mut self,
        query: &str,
        params: impl Params,
        fetch: &mut Statement<'_>,
        visit: &mut Visit<'_>,
    ) -> Result<Option<String>, Halt> {
        let told = |error: rusqlite::Error| Ok(Some(words(&error)));
        self.database.refill();
        let mut order = match self.database.connection.prepare(query) {
            Ok(order) => order,
            Err(error) => return told(error),
        };
        let mut rows = match order.query(params) {
            Ok(rows) => rows,
            Err(error) => return told(error),
        };
        loop {
            self.database.refill();
            let row = match rows.next() {
                Ok(Some(row)) => row,
                Ok(None) => return Ok(None),
                Err(error) => return told(error),
            };
            if self.rows_left == 0 || self.bytes_left == 0 {
                return Ok(Some("there are more of them than the file can hold".to_owned()));
            }
            self.rows_left -= 1;
            self.rows += 1;
            match (row.get::<_, i64>(0), row.get::<_, i64>(1)) {
                (Ok(id), Ok(time)) if self.last == Some((time, id)) => {
                    self.lose(format!("number {id} is there twice"));
                }
                (Ok(id), Ok(time)) => {
                    self.last = Some((time, id));
                    self.message(id, fetch, visit)?;
                }
                _ => self.lose("its number or its time is no whole number".to_owned()),
            }
        }
    }

    fn message(&mut self, id: i64, fetch: &mut Statement<'_>, visit: &mut Visit<'_>) -> Result<(), Halt> {
        self.database.refill();
        let mut rows = match fetch.query([id]) {
            Ok(rows) => rows,
            Err(error) => {
                self.lose(words(&error));
                return Ok(());
            }
        };
        match rows.next() {
            Ok(Some(row)) => match self.raw(row) {
                Ok(message) => {
                    self.bytes_left = self.bytes_left.saturating_sub(message.data.len() as u64);
                    return visit(Item::Message(message));
                }
                Err(problem) => self.lose(problem),
            },
            Ok(None) => self.lose(format!("number {id} is in the index, but not in the table")),
            Err(error) => self.lose(words(&error)),
        }
        Ok(())
    }

    fn raw<'r>(&self, row: &'r Row<'_>) -> Result<RawMessage<'r>, String>
    where
        Self: 'r,
    {
        let topic: i64 = row.get(0).map_err(|error| error.to_string())?;
        let (channel_id, channel) = self
            .channels
            .get(&topic)
            .ok_or_else(|| format!("it is on topic {topic}, which is not described"))?;
        let time: i64 = row.get(1).map_err(|error| error.to_string())?;
        let time = u64::try_from(time).map_err(|_| format!("its time is {time} ns, before 1970"))?;
        let data = match row.get_ref(2) {
            Ok(ValueRef::Blob(data)) => data,
            Ok(_) => return Err("its data are no bytes".to_owned()),
            Err(error) => return Err(error.to_string()),
        };
        Ok(RawMessage {
            channel_id: *channel_id,
            channel,
            sequence: 0,
            log_time_ns: time,
            publish_time_ns: time,
            data,
        })
    }

    fn lose(&mut self, reason: String) {
        if self.lost == 0 {
            self.reason = reason;
        }
        self.lost += 1;
    }

    /// Compares the rows of the index with those of the table: a damaged index may leave out any number of them without a word.
    fn count(&mut self) {
        self.database.refill();
        let count = self.database.connection.query_row(
            "SELECT count(timestamp) FROM messages NOT INDEXED",
            [],
            |row| row.get::<_, i64>(0),
        );
        match count {
            Ok(count) if count.unsigned_abs() == self.rows => {}
            Ok(count) => note(
                self.damage,
                format!("the table has {count} messages, but its index shows {} of them", self.rows),
            ),
            Err(error) => note(self.damage, format!("the messages cannot be counted: {}", words(&error))),
        }
    }
}

/// What SQLite says; it was interrupted only where the budget was spent.
fn words(error: &rusqlite::Error) -> String {
    if error.sqlite_error_code() == Some(rusqlite::ErrorCode::OperationInterrupted) {
        return "it takes longer than a file of its size can, as if its pages formed a ring".to_owned();
    }
    error.to_string()
}
