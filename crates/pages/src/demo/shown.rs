//! A figure that there may be, on the page.

use soilctl_figure::{Figure, HtmlReport, Size};

use crate::PageError;

pub(super) fn show(page: &mut HtmlReport, figure: Option<&Figure>, caption: &str) -> Result<(), PageError> {
    if let Some(figure) = figure {
        page.figure(figure, Size::default(), caption)?;
    }
    Ok(())
}
