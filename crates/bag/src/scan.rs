use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_session::SessionError;
use soilctl_session::read::{Ending, Item, RawMessage, scan_from};

use crate::container::{self, Container};
use crate::damage::note;
use crate::packed::{self, Lenient};
use crate::{BagError, db3, folder, ros1};

/// Why a visitor ends a scan before the end of the recording.
#[derive(Debug)]
pub enum Early {
    /// It has seen enough.
    Enough,
    /// The scan failed.
    Failed(BagError),
}

impl From<BagError> for Early {
    fn from(error: BagError) -> Self {
        Self::Failed(error)
    }
}

/// Why a scan ends inside this crate.
#[derive(Debug)]
pub(crate) enum Halt {
    /// The visitor said so; its error is kept elsewhere.
    Visitor,
    Failed(BagError),
}

impl From<BagError> for Halt {
    fn from(error: BagError) -> Self {
        Self::Failed(error)
    }
}

impl From<SessionError> for Halt {
    fn from(error: SessionError) -> Self {
        Self::Failed(error.into())
    }
}

/// What is shown each item inside this crate.
pub(crate) type Visit<'a> = dyn FnMut(Item<'_>) -> Result<(), Halt> + 'a;

/// Shows every item of a recording to `visit`, which ends the scan by an error of its own, such as [`Early::Enough`]. What is damaged is
/// left out and noted.
///
/// # Errors
/// [`BagError::File`] if a file cannot be read, [`BagError::NotARecording`] if it is none, or what `visit` returns.
pub fn scan<E: From<BagError>>(
    path: &Path,
    visit: &mut dyn FnMut(Item<'_>) -> Result<(), E>,
) -> Result<Ending, E> {
    let mut said = None;
    let done = show(path, &mut |item| {
        visit(item).map_err(|error| {
            said = Some(error);
            Halt::Visitor
        })
    });
    match (done, said) {
        (_, Some(error)) => Err(error),
        (Err(Halt::Failed(error)), None) => Err(error.into()),
        (Err(Halt::Visitor), None) => Ok(Ending::default()),
        (Ok(ending), None) => Ok(ending),
    }
}

/// [`scan`] that ends when `stop` is set, by whatever thread.
///
/// # Errors
/// [`BagError::Stopped`], and those of [`scan`].
pub fn scan_until(
    path: &Path,
    stop: &AtomicBool,
    visit: &mut dyn FnMut(Item<'_>) -> Result<(), BagError>,
) -> Result<Ending, BagError> {
    scan(path, &mut |item| {
        if stop.load(Ordering::Relaxed) { Err(BagError::Stopped) } else { visit(item) }
    })
}

fn show(path: &Path, visit: &mut Visit<'_>) -> Result<Ending, Halt> {
    match container::look(path)? {
        (Container::Folder, _) => folder::show(path, visit),
        (container, packed) => show_file(path, container, packed, visit),
    }
}

/// Shows what one file holds; messages that the recorder compressed one by one are as they were.
pub(crate) fn show_file(
    path: &Path,
    container: Container,
    packed: bool,
    visit: &mut Visit<'_>,
) -> Result<Ending, Halt> {
    let (mut damage, mut any) = (Vec::new(), false);
    let mut visit = |item: Item<'_>| {
        let Item::Message(message) = item else { return visit(item) };
        match packed::message(&message.channel.message_encoding, message.data) {
            None => visit(item),
            Some(Ok(plain)) => {
                any = true;
                visit(Item::Message(RawMessage { data: &plain, ..message }))
            }
            Some(Err(problem)) => {
                note(&mut damage, format!("{problem}; it is left out of {}", message.channel.topic));
                Ok(())
            }
        }
    };
    let mut ending = match (container, packed) {
        (Container::Db3, false) => db3::show(path, path, &mut visit)?,
        (Container::Db3, true) => {
            let (plain, problem) = packed::unpacked(path)?;
            let mut ending = db3::show(plain.path(), path, &mut visit)?;
            ending.damage.extend(problem);
            ending
        }
        (_, false) => {
            let mut file = File::open(path).map_err(|error| BagError::file(path, &error))?;
            show_bytes(&mut file, path, container, &mut visit)?
        }
        (_, true) => {
            let source =
                File::open(path).and_then(packed::zstd).map_err(|error| BagError::file(path, &error))?;
            let mut source = Lenient { source, problem: None };
            let mut ending = show_bytes(&mut source, path, container, &mut visit)?;
            ending.damage.extend(source.problem);
            ending
        }
    };
    ending.damage.extend(damage);
    if any || packed {
        ending.compressions.insert("zstd".to_owned());
    }
    Ok(ending)
}

fn show_bytes(
    source: &mut dyn Read,
    path: &Path,
    container: Container,
    visit: &mut Visit<'_>,
) -> Result<Ending, Halt> {
    if container == Container::Ros1 {
        ros1::show(&mut BufReader::with_capacity(1 << 16, source), path, visit)
    } else {
        scan_from(source, path, visit)
    }
}
