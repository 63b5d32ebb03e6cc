//! What the verbs that serve a page share: they end at a signal, and open a browser.

use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::{SIGINT, SIGTERM};
use tempfile::NamedTempFile;

/// A flag that is set by Ctrl-C or SIGTERM.
pub(crate) fn signalled() -> std::io::Result<Arc<AtomicBool>> {
    let signalled = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // The second one is for whoever cannot wait.
        signal_hook::flag::register_conditional_shutdown(signal, 130, Arc::clone(&signalled))?;
        signal_hook::flag::register(signal, Arc::clone(&signalled))?;
    }
    Ok(signalled)
}

/// Opens the page. All users of a machine see with which arguments programs run: an address with a token goes through a file that
/// is its owner's, and the browser from there to the page.
pub(crate) fn open_page(url: &str, secret: bool) -> std::io::Result<Option<NamedTempFile>> {
    if !secret {
        open::that_detached(url)?;
        return Ok(None);
    }
    let mut file = tempfile::Builder::new().prefix("soilctl-page-").suffix(".html").tempfile()?;
    write!(
        file,
        "<!doctype html><meta http-equiv=\"refresh\" content=\"0; url={url}\"><title>soilctl</title>"
    )?;
    file.flush()?;
    open::that_detached(file.path())?;
    Ok(Some(file))
}
