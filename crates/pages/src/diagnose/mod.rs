//! Figures and page of a diagnosis.

mod figures;
mod page;
mod traces;

use std::path::Path;

use soilctl_app::diagnose::Diagnosed;

use crate::PageError;

/// Writes the page, `report.html` beside the model file, and its figures into a folder, if one is given; the answer then names the
/// page. `command` is the command line in the foot of the page.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn or a file not be written.
pub fn write(found: &mut Diagnosed, figures: Option<&Path>, command: &str) -> Result<(), PageError> {
    let path = Path::new(&found.answer.patch).with_file_name("report.html");
    crate::write(&mut page::page(found)?, Some(&path), figures, command)?;
    found.answer.report = Some(path.display().to_string());
    Ok(())
}
