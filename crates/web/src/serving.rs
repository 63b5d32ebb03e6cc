//! The port, and serving on it.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::thread::JoinHandle;

use crate::server::Server;
use crate::{Guard, Site, WebError};

/// An address that is listened at, before anything is served there.
#[derive(Debug)]
pub struct Port {
    listener: TcpListener,
    address: SocketAddr,
}

/// How a site is served.
pub struct Settings {
    /// Further host names by which pages may be opened; addresses and `localhost` need none.
    pub hosts: Vec<String>,
    /// Takes notes, such as what was refused, from any thread.
    pub note: Box<dyn Fn(&str) + Send + Sync>,
    /// Ends all when it is set.
    pub stop: Arc<AtomicBool>,
}

/// What a server has counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counts {
    /// Pages that connected.
    pub pages: u64,
    /// Requests and messages that were refused.
    pub refused: u64,
    /// Messages that pages did not take in time.
    pub dropped: u64,
}

/// A site that is served.
pub struct Serving {
    address: SocketAddr,
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

/// What all connections share.
pub(crate) struct Shared {
    pub(crate) site: Box<dyn Site>,
    pub(crate) guard: Guard,
    note: Box<dyn Fn(&str) + Send + Sync>,
    pub(crate) stop: Arc<AtomicBool>,
    pub(crate) open: AtomicUsize,
    pub(crate) pages: AtomicU64,
    refused: AtomicU64,
    pub(crate) dropped: AtomicU64,
}

impl Shared {
    /// Takes a note for the operator.
    pub(crate) fn note(&self, text: &str) {
        (self.note)(text);
    }

    /// Counts and notes something refused.
    pub(crate) fn refuse(&self, peer: SocketAddr, what: &str) {
        let count = self.refused.fetch_add(1, Ordering::Relaxed) + 1;
        // Whoever floods the server shall not flood the notes.
        if count <= 100 || count.is_power_of_two() {
            // What came from outside may hold anything.
            let what: String = what.chars().filter(|c| !c.is_control()).take(300).collect();
            self.note(&format!("refused ({count}): {peer}: {what}"));
        }
    }
}

impl Port {
    /// Listens at an address. Port 0: any free port.
    ///
    /// # Errors
    /// [`WebError::Listen`].
    pub fn listen(address: SocketAddr) -> Result<Self, WebError> {
        let failed = |reason| WebError::Listen { address, reason };
        let listener = TcpListener::bind(address).map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        Ok(Self { listener, address })
    }

    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Serves a site until it is told to stop.
    ///
    /// # Errors
    /// [`WebError::Thread`].
    pub fn serve(self, site: impl Site, settings: Settings) -> Result<Serving, WebError> {
        let Settings { hosts, note, stop } = settings;
        let shared = Arc::new(Shared {
            site: Box::new(site),
            guard: Guard::new(self.address, hosts),
            note,
            stop,
            open: AtomicUsize::new(0),
            pages: AtomicU64::new(0),
            refused: AtomicU64::new(0),
            dropped: AtomicU64::new(0),
        });
        let server = Server { listener: self.listener, shared: Arc::clone(&shared) };
        let thread = std::thread::Builder::new().name("server".to_owned()).spawn(move || server.run());
        let thread = thread.map_err(WebError::Thread)?;
        Ok(Serving { address: self.address, shared, thread: Some(thread) })
    }
}

impl Serving {
    /// Where it listens.
    #[must_use]
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// The address for a browser on this machine, with the token in the part that browsers keep to themselves.
    #[must_use]
    pub fn url(&self, token: Option<&str>) -> String {
        let mut address = self.address;
        match address.ip() {
            IpAddr::V4(ip) if ip.is_unspecified() => address.set_ip(Ipv4Addr::LOCALHOST.into()),
            IpAddr::V6(ip) if ip.is_unspecified() => address.set_ip(Ipv6Addr::LOCALHOST.into()),
            _ => {}
        }
        let token = token.map(|token| format!("#token={token}")).unwrap_or_default();
        format!("http://{address}/{token}")
    }

    /// What it has counted so far.
    #[must_use]
    pub fn counts(&self) -> Counts {
        Counts {
            pages: self.shared.pages.load(Ordering::Relaxed),
            refused: self.shared.refused.load(Ordering::Relaxed),
            dropped: self.shared.dropped.load(Ordering::Relaxed),
        }
    }

    /// Says good-bye to all pages and ends.
    pub fn end(&mut self) {
        self.shared.stop.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        self.end();
    }
}
