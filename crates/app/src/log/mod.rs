//! What is in a log, whether it is well, saving what can be saved, and tables: a use case each, with one form of answer.

mod answer;
pub mod doctor;
pub mod export;
mod foreign;
pub mod info;
pub mod recover;

use std::path::Path;
use std::sync::atomic::AtomicBool;

pub use answer::{Answer, Content, Found, Gap, Topic, Written};

use crate::{AppError, Interrupted, Watch};

/// Work on a log, which says how long it may go on.
fn watched(
    watch: &dyn Watch,
    work: impl FnOnce(&AtomicBool) -> Result<Answer, AppError>,
) -> Result<Answer, AppError> {
    watch.begin(0, "reading the log");
    let answer = work(&watch.stop(Interrupted::LeavesNothing));
    watch.end();
    answer
}

/// A log must not be overwritten by what is made of it.
fn differ(log: &Path, out: &Path) -> Result<(), AppError> {
    let same = match (log.canonicalize(), out.canonicalize()) {
        (Ok(log), Ok(out)) => log == out,
        _ => false,
    };
    if same {
        return Err(AppError::Request(format!(
            "--out is {}, the log itself; give another name",
            out.display()
        )));
    }
    Ok(())
}
