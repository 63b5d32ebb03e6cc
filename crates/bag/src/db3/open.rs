use std::ffi::OsString;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use rusqlite::config::DbConfig;
use rusqlite::limits::Limit;
use rusqlite::{Connection, OpenFlags};

use crate::BagError;
use crate::packed::MOST_BYTES;

/// Steps of SQLite's machine between two looks at the budget.
const LOOK: i32 = 10_000;

/// An open database.
pub(super) struct Database {
    pub(super) connection: Connection,
    /// Bytes of its files.
    pub(super) bytes: u64,
    /// Steps of SQLite's machine that the next call may take.
    left: Arc<AtomicU64>,
}

impl Database {
    /// Allows the next call as many steps as the whole file can ask for, sorting included. Without an end a damaged tree, or a made
    /// up one, can keep SQLite busy for years.
    pub(super) fn refill(&self) {
        self.left.store(self.bytes.saturating_mul(8).saturating_add(10_000_000), Ordering::Relaxed);
    }
}

/// Opens a database to be read, with what its write-ahead log adds. Neither is changed.
///
/// # Errors
/// [`BagError::NotARecording`].
pub(super) fn open(file: &Path, path: &Path, damage: &mut Vec<String>) -> Result<Database, BagError> {
    let size = |ending: &str| {
        let mut name = OsString::from(file);
        name.push(ending);
        std::fs::metadata(name).map_or(0, |about| about.len())
    };
    let (log, bytes) = (size("-wal"), size("") + size("-wal"));
    if size("-journal") > 0 {
        damage.push(
            "a journal lies beside it: the recorder was killed while it wrote, and some pages may be half written; \
             open it once with `sqlite3` to undo that"
                .to_owned(),
        );
    }
    if log == 0
        && let Some(told) = told_size(file)
        && told > bytes
    {
        damage.push(format!("the file was cut: it has {bytes} bytes of the {told} that it should have"));
    }
    let failed = |error: rusqlite::Error| BagError::not_a_recording(path, error.to_string());
    let connection = connect(file, log > 0).map_err(failed)?;
    let left = Arc::new(AtomicU64::new(0));
    let mine = Arc::clone(&left);
    let step = LOOK.unsigned_abs().into();
    connection
        .progress_handler(
            LOOK,
            Some(move || {
                let now = mine.load(Ordering::Relaxed);
                mine.store(now.saturating_sub(step), Ordering::Relaxed);
                now < step
            }),
        )
        .map_err(failed)?;
    // No value is longer than the file.
    let longest = i32::try_from(bytes.min(MOST_BYTES as u64).max(1 << 16)).unwrap_or(i32::MAX);
    connection.set_limit(Limit::SQLITE_LIMIT_LENGTH, longest).map_err(failed)?;
    let database = Database { connection, bytes, left };
    database.refill();
    Ok(database)
}

/// Bytes that the file should have by its header, where that is up to date (<https://sqlite.org/fileformat2.html#database_header>).
/// SQLite takes pages that are not there for empty ones.
fn told_size(file: &Path) -> Option<u64> {
    let mut header = Vec::new();
    File::open(file).ok()?.take(100).read_to_end(&mut header).ok()?;
    let number = |place: usize| header.get(place..)?.first_chunk().map(|bytes| u32::from_be_bytes(*bytes));
    if number(24)? != number(92)? {
        return None;
    }
    let size = match u16::from_be_bytes(*header.get(16..)?.first_chunk()?) {
        1 => 65_536,
        size => u64::from(size),
    };
    Some(size * u64::from(number(28)?))
}

/// For a database with a log: it is read without anybody's locks.
const WITHOUT_LOCKS: &str =
    if cfg!(windows) { "?mode=ro&vfs=win32-longpath-none" } else { "?mode=ro&vfs=unix-none" };

#[cfg(unix)]
fn bytes(path: &Path) -> Vec<u8> {
    std::os::unix::ffi::OsStrExt::as_bytes(path.as_os_str()).to_vec()
}

/// `C:\folder` is `/C:/folder` in an address. A name that is not Unicode is not found then.
#[cfg(not(unix))]
fn bytes(path: &Path) -> Vec<u8> {
    format!("/{}", path.display()).replace('\\', "/").into_bytes()
}

fn connect(file: &Path, has_log: bool) -> rusqlite::Result<Connection> {
    let absolute = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let mut uri = "file:".to_owned();
    for byte in bytes(&absolute) {
        if byte.is_ascii_alphanumeric() || b"/._-".contains(&byte) {
            uri.push(byte.into());
        } else {
            uri += &format!("%{byte:02x}");
        }
    }
    // Nobody else's locks are waited for, and none is left behind. An immutable file is read without its log.
    uri += if has_log { WITHOUT_LOCKS } else { "?immutable=1" };
    let flags =
        OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_URI | OpenFlags::SQLITE_OPEN_NO_MUTEX;
    let connection = Connection::open_with_flags(uri, flags)?;
    if has_log {
        // The index of the log is then kept in memory instead of in a file beside it.
        connection.pragma_update(None, "locking_mode", "EXCLUSIVE")?;
        connection.set_db_config(DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, true)?;
    }
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_DEFENSIVE, true)?;
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_TRUSTED_SCHEMA, false)?;
    connection.set_db_config(DbConfig::SQLITE_DBCONFIG_ENABLE_VIEW, false)?;
    Ok(connection)
}
