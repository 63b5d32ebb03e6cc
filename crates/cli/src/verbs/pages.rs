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

/// A page and its figures, of answers that have them made only where they are asked for.
#[derive(Debug, Clone, Default, clap::Args)]
pub(crate) struct PageFiles {
    /// One HTML page with figures and what they mean
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,

    #[command(flatten)]
    figures: FigureFiles,
}

impl PageFiles {
    /// Makes the page and writes what is asked for.
    pub(crate) fn write<E>(
        &self,
        page: impl FnOnce() -> Result<HtmlReport, E>,
        output: &Output,
    ) -> Result<(), CliError>
    where
        CliError: From<E>,
    {
        if self.report.is_some() || self.figures.figures.is_some() {
            write(&mut page()?, self.report.as_deref(), &self.figures, output)?;
        }
        Ok(())
    }
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
