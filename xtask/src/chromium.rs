//! The browser that the report is tested in.

use crate::apt;
use crate::error::XtaskError;
use crate::workspace::on_path;

/// Makes sure that `chromium` can be started.
pub(crate) fn ensure() -> Result<(), XtaskError> {
    if on_path("chromium") {
        return Ok(());
    }
    // The fonts are only recommended by the package, but without any there is no text to measure.
    apt::install("install chromium", "the browser chromium", &["chromium", "fonts-dejavu-core"])
}
