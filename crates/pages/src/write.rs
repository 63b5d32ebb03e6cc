//! Figures and pages into files.

use std::path::Path;

use soilctl_app::AppError;
use soilctl_app::files::save;
use soilctl_figure::{Figure, HtmlReport, Size};

use crate::PageError;

/// Writes a figure into a file, in the form that its name asks for.
///
/// # Errors
/// [`PageError::Nothing`] for another ending, [`PageError`] if it cannot be drawn or written.
pub fn save_figure(figure: &Figure, path: &Path, size: Size) -> Result<(), PageError> {
    let bytes = match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => figure.to_svg(size)?.into_bytes(),
        Some("png") => figure.to_png(size)?,
        Some("csv") => figure.to_csv().into_bytes(),
        _ => {
            return Err(PageError::Nothing(format!(
                "--plot is {}; the name must end in .svg, .png or .csv",
                path.display()
            )));
        }
    };
    Ok(save(path, &bytes)?)
}

/// Writes a page, a folder with its figures, or both; the names of all files, the page first. `command` is the command line that
/// the foot of the page shows; empty if it was made by none.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn or a file not be written.
pub fn write(
    page: &mut HtmlReport,
    path: Option<&Path>,
    figures: Option<&Path>,
    command: &str,
) -> Result<Vec<String>, PageError> {
    page.footer(format!("soilctl {}", env!("CARGO_PKG_VERSION")));
    page.command(command);
    let mut written = Vec::new();
    if let Some(path) = path {
        save(path, page.to_html().as_bytes())?;
        written.push(path.display().to_string());
    }
    if let Some(folder) = figures {
        written.extend(save_figures(page, folder)?);
    }
    Ok(written)
}

/// Every figure of a page in three forms, named by its number.
fn save_figures(page: &HtmlReport, folder: &Path) -> Result<Vec<String>, PageError> {
    std::fs::create_dir_all(folder)
        .map_err(|problem| AppError::File { path: folder.display().to_string(), problem })?;
    let mut written = Vec::new();
    for shown in page.shown() {
        let mut put = |form: &str, bytes: &[u8]| -> Result<(), PageError> {
            let path = folder.join(format!("figure-{}.{form}", shown.number));
            save(&path, bytes)?;
            written.push(path.display().to_string());
            Ok(())
        };
        put("svg", shown.figure.to_svg(shown.size)?.as_bytes())?;
        put("png", &shown.figure.to_png(shown.size)?)?;
        put("csv", shown.figure.to_csv().as_bytes())?;
    }
    Ok(written)
}
