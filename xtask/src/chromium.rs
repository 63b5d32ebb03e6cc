//! The browser that the report is tested in.

use crate::apt;
use crate::error::XtaskError;
use crate::workspace::on_path;

const PROGRAM: &str = "chromium";
const STEP: &str = "install chromium";

/// Makes sure that `chromium` can be started.
pub(crate) fn ensure() -> Result<(), XtaskError> {
    if on_path(PROGRAM) {
        return Ok(());
    }
    // The fonts are only recommended by the package, but without any there is no text to measure.
    apt::install(STEP, "the browser chromium", &["chromium", "fonts-dejavu-core"])?;
    if on_path(PROGRAM) {
        return Ok(());
    }
    Err(XtaskError::Missing {
        step: STEP.into(),
        what: "apt-get installed the package chromium, but there is no program of that name on PATH".into(),
        remedy: "install the browser by hand so that `chromium` starts it".into(),
    })
}
