use std::collections::{BTreeMap, BTreeSet};

use rusqlite::types::ValueRef;
use rusqlite::{Connection, Row};
use soilctl_session::read::Channel;

use super::open::Database;
use crate::damage::note;

/// Bytes of all definitions together that are kept.
const MOST_HELD: usize = 256 << 20;

/// Channels by the number of their topic, with numbers of their own.
pub(super) type Channels = BTreeMap<i64, (u16, Channel)>;

/// Names of the tables, without views and virtual tables, which could do anything.
pub(super) fn tables(connection: &Connection) -> rusqlite::Result<BTreeSet<String>> {
    let mut names = BTreeSet::new();
    let mut query = connection.prepare(
        "SELECT name FROM sqlite_schema WHERE type = 'table' AND name IN ('topics', 'messages', 'message_definitions') \
         AND sql NOT LIKE 'CREATE VIRTUAL%'",
    )?;
    let mut rows = query.query([])?;
    while let Some(row) = rows.next()? {
        names.insert(row.get(0)?);
    }
    Ok(names)
}

/// The topics of a bag as channels.
pub(super) fn channels(database: &Database, defined: bool, damage: &mut Vec<String>) -> Channels {
    let mut definitions = BTreeMap::new();
    if defined {
        let query = "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions";
        let mut held = 0;
        each(database, query, damage, "the definitions of messages", |row, damage| {
            let [name, encoding, text] = [text(row, 0), text(row, 1), text(row, 2)];
            held += text.len();
            if held > MOST_HELD {
                note(damage, format!("there are too many definitions; that of {name} is left out"));
            } else {
                definitions.entry(name).or_insert((encoding, text));
            }
        });
    }
    let mut channels = Channels::new();
    let mut held = 0;
    each(database, "SELECT * FROM topics", damage, "the topics", |row, damage| {
        let place = |name: &str| row.as_ref().column_index(name).ok();
        let named = |name: &str| place(name).map(|place| text(row, place)).unwrap_or_default();
        let topic = named("name");
        let Some(id) = place("id").and_then(|place| row.get::<_, i64>(place).ok()) else {
            note(damage, format!("the topic {topic} has no number"));
            return;
        };
        let message_type = named("type");
        let (schema_encoding, schema) = definitions.get(&message_type).cloned().unwrap_or_default();
        held += schema.len();
        let Some(number) = u16::try_from(channels.len()).ok().filter(|_| held <= MOST_HELD) else {
            note(damage, format!("there are too many topics; {topic} is left out"));
            return;
        };
        let channel = Channel {
            topic,
            message_type,
            message_encoding: named("serialization_format"),
            schema_encoding,
            schema: schema.into_bytes(),
            metadata: BTreeMap::from([("offered_qos_profiles".to_owned(), named("offered_qos_profiles"))]),
        };
        channels.entry(id).or_insert((number, channel));
    });
    channels
}

fn each(
    database: &Database,
    query: &str,
    damage: &mut Vec<String>,
    what: &str,
    mut visit: impl FnMut(&Row<'_>, &mut Vec<String>),
) {
    let mut read = || {
        database.refill();
        let mut query = database.connection.prepare(query)?;
        let mut rows = query.query([])?;
        // A row takes some bytes of the file; a ring of pages would show them again and again.
        let mut left = database.bytes / 4;
        while let Some(row) = rows.next()? {
            visit(row, damage);
            left = left.saturating_sub(1);
            if left == 0 {
                note(damage, format!("{what} are more than the file can hold"));
                break;
            }
        }
        Ok(())
    };
    let read: rusqlite::Result<()> = read();
    if let Err(error) = read {
        note(damage, format!("{what} cannot be read: {error}"));
    }
}

/// A text, or bytes that should be one.
fn text(row: &Row<'_>, place: usize) -> String {
    match row.get_ref(place) {
        Ok(ValueRef::Text(text) | ValueRef::Blob(text)) => String::from_utf8_lossy(text).into_owned(),
        _ => String::new(),
    }
}
