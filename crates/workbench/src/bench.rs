use std::net::{Ipv4Addr, SocketAddr};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize};

use soilctl_web::{Content, Counts, Feed, Port, Serving, Site, WebError, random_hex};

use crate::WorkbenchError;
use crate::feed::Page;
use crate::file::ProblemFile;
use crate::page;

/// Most bytes of a message: the longest problem file with all that JSON adds to it.
const MOST_MESSAGE_BYTES: usize = 4 << 20;

/// How a workbench serves.
pub struct Settings {
    /// The port on loopback. 0: any free one.
    pub port: u16,
    /// Takes notes, such as what was refused, from any thread.
    pub note: Box<dyn Fn(&str) + Send + Sync>,
}

/// A workbench that serves.
pub struct Workbench {
    serving: Serving,
    token: Arc<str>,
}

/// What all pages share.
struct Bench {
    file: Option<Arc<ProblemFile>>,
    token: Arc<str>,
    running: Arc<AtomicUsize>,
}

impl Workbench {
    /// Serves the page, for a problem file if one is given; it need not be there yet.
    ///
    /// # Errors
    /// [`WorkbenchError`] if the port is taken or the file cannot be read.
    pub fn start(file: Option<&Path>, settings: Settings) -> Result<Self, WorkbenchError> {
        let file = file.map(ProblemFile::open).transpose()?.map(Arc::new);
        let port = Port::listen(SocketAddr::from((Ipv4Addr::LOCALHOST, settings.port)))?;
        let token: Arc<str> = random_hex::<16>()?.into();
        let bench = Bench { file, token: Arc::clone(&token), running: Arc::default() };
        let settings = soilctl_web::Settings {
            hosts: Vec::new(),
            note: settings.note,
            stop: Arc::new(AtomicBool::new(false)),
        };
        Ok(Self { serving: port.serve(bench, settings)?, token })
    }

    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.serving.address()
    }

    /// The token with which pages may read and save the file.
    #[must_use]
    pub fn token(&self) -> &str {
        &self.token
    }

    /// The address for a browser on this machine, with the token in the part that browsers keep to themselves.
    #[must_use]
    pub fn url(&self) -> String {
        self.serving.url(Some(&self.token))
    }

    /// What it has counted so far.
    #[must_use]
    pub fn counts(&self) -> Counts {
        self.serving.counts()
    }

    /// Says good-bye to all pages and ends.
    #[must_use]
    pub fn stop(mut self) -> Counts {
        self.serving.end();
        self.counts()
    }
}

impl Site for Bench {
    fn name(&self) -> &'static str {
        "workbench"
    }

    fn at(&self, path: &str) -> Result<Option<Content<'_>>, WebError> {
        Ok(page::at(path))
    }

    fn feed(&self) -> Result<Box<dyn Feed>, String> {
        let page = Page::new(self.file.clone(), Arc::clone(&self.token), Arc::clone(&self.running))?;
        Ok(Box::new(page))
    }

    fn most_message_bytes(&self) -> usize {
        MOST_MESSAGE_BYTES
    }
}
