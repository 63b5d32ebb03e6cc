use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_session::SessionError;
use soilctl_session::read::{Ending, Item};

use crate::BagError;

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
    soilctl_session::read::scan(path, visit)
}
