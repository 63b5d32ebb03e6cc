use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;

use soilctl_web::{Counts, Port, Serving, random_hex};

use crate::BagSettings;
use crate::MonitorError;
use crate::feed::Feed;
use crate::film::Film;
use crate::live::{Hub, Operator, Upstream};
use crate::site::Shown;

/// What is shown.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A live session at this Unix socket.
    Session(PathBuf),
    /// A log.
    Log {
        /// The file.
        path: PathBuf,
        /// Where pages begin, in s; beyond the ends of the log: at its ends.
        from_s: f64,
        /// What is to be taken of a log of another program.
        bag: BagSettings,
    },
}

/// How a monitor serves.
pub struct Settings {
    /// Where it listens. Port 0: any free port.
    pub listen: SocketAddr,
    /// Further host names by which pages may be opened; addresses and `localhost` need none.
    pub hosts: Vec<String>,
    /// Whether pages that know the token may send commands to a session.
    pub commands: bool,
    /// Takes notes, such as what was refused, from any thread.
    pub note: Box<dyn Fn(&str) + Send + Sync>,
}

/// A monitor that serves.
pub struct Monitor {
    serving: Serving,
    stop: Arc<AtomicBool>,
    token: Option<Arc<str>>,
    hub: Option<Arc<Hub>>,
    damage: Vec<String>,
    notes: Vec<String>,
    threads: Vec<JoinHandle<()>>,
}

impl Monitor {
    /// Connects to the session or reads the log, and serves the page.
    ///
    /// # Errors
    /// [`MonitorError::Web`], [`MonitorError::Live`] if the session is not there, [`MonitorError::Session`] or
    /// [`MonitorError::Bag`] for the log, [`MonitorError::Scene`], [`MonitorError::Thread`].
    pub fn start(source: Source, settings: Settings) -> Result<Self, MonitorError> {
        Self::start_with(source, settings, Arc::new(Hub::default()))
    }

    /// The same with what lies between a session and its pages, which somebody else knows too.
    pub(crate) fn start_with(
        source: Source,
        settings: Settings,
        shared: Arc<Hub>,
    ) -> Result<Self, MonitorError> {
        let Settings { listen, hosts, commands, note } = settings;
        let port = Port::listen(listen)?;
        let stop = Arc::new(AtomicBool::new(false));
        let mut threads = Vec::new();
        let (mut hub, mut damage, mut notes, mut meshes) = (None, Vec::new(), Vec::new(), Vec::new());
        let (feed, greeting): (Box<dyn Fn() -> _ + Send + Sync>, _) = match source {
            Source::Session(path) => {
                hub = Some(Arc::clone(&shared));
                let (theirs, stop) = (Arc::clone(&shared), Arc::clone(&stop));
                threads.push(Upstream::start(path, commands, theirs, stop)?);
                (Box::new(move || Ok(Feed::Session(Operator::new(Arc::clone(&shared))))), Vec::new())
            }
            Source::Log { path, from_s, bag } => {
                let film = Film::load(&path, &bag)?;
                let greeting = film.greeting(&path);
                (damage, notes) = (film.damage().to_vec(), film.notes().to_vec());
                meshes = film.meshes();
                (Box::new(move || Ok(Feed::Log(Box::new(film.player(from_s)?)))), greeting)
            }
        };
        let token: Option<Arc<str>> = if commands { Some(random_hex::<16>()?.into()) } else { None };
        let shown = Shown { token: token.clone(), feed, greeting, meshes, may_dig: hub.is_some() };
        let served = port.serve(shown, soilctl_web::Settings { hosts, note, stop: Arc::clone(&stop) });
        let serving = served.inspect_err(|_| stop.store(true, Ordering::Relaxed))?;
        Ok(Self { serving, stop, token, hub, damage, notes, threads })
    }

    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.serving.address()
    }

    /// The token that allows commands, if they are on.
    #[must_use]
    pub fn token(&self) -> Option<&str> {
        self.token.as_deref()
    }

    /// The address for a browser on this machine, with the token in the part that browsers keep to themselves.
    #[must_use]
    pub fn url(&self) -> String {
        self.serving.url(self.token())
    }

    /// The same of a page at a path.
    pub(crate) fn url_of(&self, path: &str) -> String {
        let token = self.token().map(|token| format!("#token={token}")).unwrap_or_default();
        format!("{}{path}{token}", self.serving.url(None).trim_end_matches('/'))
    }

    /// What is wrong with the log that is played; it is left out.
    #[must_use]
    pub fn damage(&self) -> &[String] {
        &self.damage
    }

    /// What was odd about another program's recording, or could not be used.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// What it has counted so far.
    #[must_use]
    pub fn counts(&self) -> Counts {
        let waiting = self.hub.as_ref().map_or(0, |hub| hub.lock().dropped());
        let counts = self.serving.counts();
        Counts { dropped: counts.dropped + waiting, ..counts }
    }

    /// Says good-bye to all pages and ends.
    #[must_use]
    pub fn stop(mut self) -> Counts {
        self.end();
        self.counts()
    }

    fn end(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        self.serving.end();
        for thread in self.threads.drain(..) {
            let _ = thread.join();
        }
    }
}

impl Drop for Monitor {
    fn drop(&mut self) {
        self.end();
    }
}
