//! Digging by hand: sessions in real time, one after the other, each with the soil that was chosen and a log of its own, and a page on
//! which the plate is dragged.

mod message;
mod page;
mod sessions;

use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;

use soilctl_web::Counts;

pub(crate) use message::{DigMessage, Dug};
pub(crate) use page::{DIG_PATH, at};
use sessions::Sessions;

use crate::live::Hub;
use crate::{Monitor, MonitorError, Settings, Source};

/// What is dug, and where the logs go.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DigSettings {
    /// Name of the first soil, one of [`presets`](soilctl_campaign::presets).
    pub soil: String,
    /// Seed of noise and scatter.
    pub seed: u64,
    /// The first log. Later ones get a number, as does a first one whose name is taken: nothing is overwritten.
    pub log: PathBuf,
    /// Where operators connect.
    pub socket: PathBuf,
    /// Where a device that leads the plate may connect.
    pub device: Option<PathBuf>,
}

/// How a session went.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DugSession {
    /// Name of the soil.
    pub soil: String,
    /// The log.
    pub log: PathBuf,
    /// Steps in it.
    pub steps: u64,
    /// What went wrong; empty if nothing did.
    pub problems: Vec<String>,
}

/// Sessions that are dug, and the page for it.
pub struct Dig {
    monitor: Monitor,
    stop: Arc<AtomicBool>,
    over: Arc<AtomicBool>,
    thread: Option<JoinHandle<Vec<DugSession>>>,
}

impl Dig {
    /// Starts the first session and serves its page.
    ///
    /// # Errors
    /// [`MonitorError::Campaign`] if there is no such soil, [`MonitorError::File`] for the log, [`MonitorError::Live`] for the session, and
    /// otherwise as [`Monitor::start`].
    pub fn start(dig: DigSettings, settings: Settings) -> Result<Self, MonitorError> {
        let hub = Arc::new(Hub::default());
        let (stop, over) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicBool::new(false)));
        let socket = dig.socket.clone();
        let sessions = Sessions::begin(dig, Arc::clone(&hub), Arc::clone(&stop), Arc::clone(&over))?;
        let thread = std::thread::Builder::new()
            .name("sessions".to_owned())
            .spawn(move || sessions.run())
            .map_err(|reason| MonitorError::Thread { thread: "sessions", reason })?;
        let monitor = Monitor::start_with(Source::Session(socket), settings, hub);
        let monitor = match monitor {
            Ok(monitor) => monitor,
            Err(error) => {
                stop.store(true, Ordering::Relaxed);
                let _ = thread.join();
                return Err(error);
            }
        };
        Ok(Self { monitor, stop, over, thread: Some(thread) })
    }

    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.monitor.address()
    }

    /// The address for a browser on this machine, with the token in the part that browsers keep to themselves.
    #[must_use]
    pub fn url(&self) -> String {
        self.monitor.url_of(DIG_PATH)
    }

    /// Whether a session has ended by itself, so that there is nothing left to dig.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.over.load(Ordering::Acquire)
    }

    /// Ends the session, closes its log, and says good-bye to all pages.
    #[must_use]
    pub fn stop(mut self) -> (Vec<DugSession>, Counts) {
        let dug = self.end();
        (dug, self.monitor.counts())
    }

    fn end(&mut self) -> Vec<DugSession> {
        self.stop.store(true, Ordering::Relaxed);
        self.thread.take().and_then(|thread| thread.join().ok()).unwrap_or_default()
    }
}

impl Drop for Dig {
    fn drop(&mut self) {
        self.end();
    }
}
