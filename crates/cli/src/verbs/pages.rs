//! What the pages of all verbs have in common: their foot, and figures of theirs as files.

use std::path::{Path, PathBuf};

use soilctl_figure::HtmlReport;

use super::process::save;
use crate::error::CliError;
use crate::output::Output;

/// Files beside a page.
#[derive(Debug, Clone, Default, clap::Args)]
pub(crate) struct FigureFiles {
    /// Folder for every figure of the page as .svg, .png and .csv; made if it is not there
    #[arg(long, value_name = "DIR")]
    pub(crate) figures: Option<PathBuf>,
}

/// Writes a page, its figures, or both; the names of all files, the page first.
pub(crate) fn write(
    page: &mut HtmlReport,
    path: Option<&Path>,
    figures: &FigureFiles,
    output: &Output,
) -> Result<Vec<String>, CliError> {
    page.footer(format!("soilctl {}", env!("CARGO_PKG_VERSION")));
    page.command(output.command());
    let mut written = Vec::new();
    if let Some(path) = path {
        save(path, page.to_html().as_bytes())?;
        written.push(path.display().to_string());
    }
    if let Some(folder) = &figures.figures {
        written.extend(save_figures(page, folder)?);
    }
    Ok(written)
}

/// Every figure of a page in three forms, named by its number.
fn save_figures(page: &HtmlReport, folder: &Path) -> Result<Vec<String>, CliError> {
    std::fs::create_dir_all(folder)
        .map_err(|problem| CliError::File { path: folder.display().to_string(), problem })?;
    let mut written = Vec::new();
    for shown in page.shown() {
        let mut put = |form: &str, bytes: &[u8]| -> Result<(), CliError> {
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
