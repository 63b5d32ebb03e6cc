//! Databases in the states that recorders and accidents leave them in.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use std::path::Path;

use common::{data, expected, readings};
use rusqlite::Connection;
use soilctl_bag::{BagError, Ending, Item, scan};

fn copied(name: &str, to: &Path) -> Connection {
    std::fs::copy(data(name), to).unwrap();
    Connection::open(to).unwrap()
}

fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap()))
        .collect();
    all.sort();
    all
}

/// A recorder that is killed leaves the last messages in a log beside the file. They are read, and nothing is touched.
#[test]
fn messages_in_the_write_ahead_log() {
    let dir = tempfile::tempdir().unwrap();
    let live = dir.path().join("live.db3");
    let dead = dir.path().join("the dead ?%#");
    std::fs::create_dir(&dead).unwrap();
    let connection = copied("sqlite/sqlite.db3", &live);
    let mode: String = connection.query_row("PRAGMA journal_mode=WAL", [], |row| row.get(0)).unwrap();
    assert_eq!(mode, "wal");
    let whole = readings(&live).0;
    assert_eq!(whole, expected());
    connection
        .execute_batch("INSERT INTO messages SELECT id + 1000, topic_id, timestamp + 1000000000, data FROM messages WHERE id > 30")
        .unwrap();
    let path = dead.join("a.db3");
    std::fs::copy(&live, &path).unwrap();
    std::fs::copy(dir.path().join("live.db3-wal"), dead.join("a.db3-wal")).unwrap();
    let before = files(&dead);
    let (found, ending) = readings(&path);
    assert!(ending.is_whole(), "{ending:?}");
    assert_eq!(found[..whole.len()], whole);
    assert!(found.len() > whole.len() + 5);
    assert!(files(&dead) == before, "the folder is as it was");
    // Without the log only what is in the file itself is there.
    std::fs::remove_file(dead.join("a.db3-wal")).unwrap();
    assert_eq!(readings(&path).0, whole);
    assert_eq!(files(&dead).len(), 1);
}

#[test]
fn odd_rows_are_counted_and_left_out() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.db3");
    let connection = copied("sqlite/sqlite.db3", &path);
    connection
        .execute_batch(
            "INSERT INTO messages VALUES (NULL, 99, 5, x'00010000'); INSERT INTO messages VALUES (NULL, 1, -5, x'00010000');
             INSERT INTO messages VALUES (NULL, 1, 6, 'text'); INSERT INTO messages VALUES (NULL, 1, 'never', x'00010000');",
        )
        .unwrap();
    drop(connection);
    let (found, ending) = readings(&path);
    assert_eq!(found, expected());
    assert_eq!(
        ending.damage,
        ["4 messages cannot be read, the first because its time is -5 ns, before 1970"]
    );
    std::fs::write(dir.path().join("a.db3-journal"), "x").unwrap();
    assert!(readings(&path).1.damage.iter().any(|text| text.contains("journal")));
}

fn scanned(path: &Path) -> Result<(u64, Ending), BagError> {
    let mut messages = 0;
    let ending = scan::<BagError>(path, &mut |item| {
        messages += u64::from(matches!(item, Item::Message(_)));
        Ok(())
    });
    ending.map(|ending| (messages, ending))
}

/// Tables that are no tables, and would never end.
#[test]
fn databases_made_to_do_harm() {
    let dir = tempfile::tempdir().unwrap();
    let endless = "WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r)";
    for (name, sql) in [
        (
            "view",
            format!("CREATE TABLE topics(id, name, type, serialization_format); CREATE VIEW messages AS {endless} SELECT i AS id, 1 AS topic_id, i AS timestamp, x'00' AS data FROM r;"),
        ),
        (
            "virtual",
            "CREATE TABLE topics(id, name, type, serialization_format); CREATE VIRTUAL TABLE messages USING fts5(id, topic_id, timestamp, data);".to_owned(),
        ),
        ("empty", "CREATE TABLE something(id);".to_owned()),
        ("columns", "CREATE TABLE topics(x); CREATE TABLE messages(y); INSERT INTO topics VALUES (1); INSERT INTO messages VALUES (1);".to_owned()),
        (
            "generated",
            "CREATE TABLE topics(id, name, type, serialization_format); CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, data AS (zeroblob(200000000)));
             INSERT INTO topics VALUES (1, '/a', 'b', 'cdr'); INSERT INTO messages(topic_id, timestamp) VALUES (1, 1), (1, 2);".to_owned(),
        ),
    ] {
        let path = dir.path().join(name);
        Connection::open(&path).unwrap().execute_batch(&sql).unwrap();
        match scanned(&path) {
            Ok((messages, ending)) => assert!(messages == 0 && !ending.is_whole(), "{name}: {messages} {ending:?}"),
            Err(error) => assert!(error.to_string().contains("without a table"), "{name}: {error}"),
        }
    }
}

/// Pages of a tree that point at themselves or each other; SQLite alone would walk such a tree for years.
#[test]
fn trees_that_are_rings() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("ring.db3");
    let connection = Connection::open(&path).unwrap();
    connection
        .execute_batch(
            "PRAGMA page_size=1024; CREATE TABLE topics(id INTEGER PRIMARY KEY, name, type, serialization_format);
             CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB);
             INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/String', 'cdr');
             INSERT INTO messages WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r WHERE i < 200000)
             SELECT i, 1, i, x'0001000000' FROM r; VACUUM;",
        )
        .unwrap();
    drop(connection);
    let whole = std::fs::read(&path).unwrap();
    assert_eq!(scanned(&path).unwrap().0, 200_000);
    let pages = whole.len() / 1024;
    // Interior pages of tables begin with 5; all their children become the first child of the first of them.
    let interior: Vec<usize> = (1..pages).filter(|page| whole[page * 1024] == 5).collect();
    assert!(interior.len() > 10);
    let number = |page: usize| u32::try_from(page + 1).unwrap().to_be_bytes();
    let first_child = |page: usize| -> [u8; 4] {
        let place = page * 1024;
        let cell = usize::from(u16::from_be_bytes([whole[place + 12], whole[place + 13]]));
        whole[place + cell..place + cell + 4].try_into().unwrap()
    };
    let leaf = first_child(interior[1]);
    for depth in [0, 8, 30] {
        let mut bytes = whole.clone();
        for (i, &page) in interior.iter().enumerate() {
            // All children of a page become the next page, and after some levels a leaf.
            let target = if i < depth { number(interior[i + 1]) } else { leaf };
            let place = page * 1024;
            let cells = usize::from(u16::from_be_bytes([bytes[place + 3], bytes[place + 4]]));
            for i in 0..cells {
                let at = place + 12 + 2 * i;
                let cell = usize::from(u16::from_be_bytes([bytes[at], bytes[at + 1]]));
                bytes[place + cell..place + cell + 4].copy_from_slice(&target);
            }
        }
        std::fs::write(&path, bytes).unwrap();
        let (messages, ending) = scanned(&path).unwrap();
        assert!(!ending.is_whole() && messages < 1_000_000, "{depth}: {messages}");
    }
}
