//! What the pages of all verbs have in common.

use std::path::{Path, PathBuf};

use soilctl_figure::HtmlReport;

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
    Ok(soilctl_pages::write(page, path, figures.figures.as_deref(), output.command())?)
}
