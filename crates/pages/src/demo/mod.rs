//! Figures and page of a demonstration.

mod figures;
mod findings;
mod page;
mod shown;

use std::path::Path;

use soilctl_app::demo::Demonstration;

use crate::PageError;

/// Writes the figures and the page of a demonstration into its folder; the answer then names them. `command` is the command line in
/// the foot of the page. Nothing is written of one that was stopped.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn or a file not be written.
pub fn write(found: &mut Demonstration, command: &str) -> Result<(), PageError> {
    let Demonstration { answer, work: Some(work) } = found else { return Ok(()) };
    let drawn = figures::all(answer, work)?;
    let folder = Path::new(&answer.files.folder);
    let path = folder.join("report.html");
    answer.files.figures = figures::save_all(&drawn, folder)?;
    answer.files.report = Some(path.display().to_string());
    crate::write(&mut page::page(answer, work, &drawn)?, Some(&path), None, command)?;
    Ok(())
}
