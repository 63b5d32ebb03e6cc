use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};

use super::guard::Guard;
use crate::MonitorError;
use crate::feed::Feed;

/// What all connections share.
pub(crate) struct Shared {
    pub(crate) guard: Guard,
    /// The token that allows commands; none if they are off.
    pub(crate) token: Option<Arc<str>>,
    /// Makes the feed of a new page.
    pub(crate) feed: Box<dyn Fn() -> Result<Feed, MonitorError> + Send + Sync>,
    /// What a page is greeted with, beside its feed.
    pub(crate) greeting: Vec<String>,
    /// Meshes by their numbers.
    pub(crate) meshes: Vec<Arc<[u8]>>,
    /// Takes notes for the operator.
    pub(crate) note: Box<dyn Fn(&str) + Send + Sync>,
    pub(crate) stop: Arc<AtomicBool>,
    pub(crate) open: AtomicUsize,
    pub(crate) pages: AtomicU64,
    pub(crate) refused: AtomicU64,
    pub(crate) dropped: AtomicU64,
}

impl Shared {
    /// Counts and notes something refused.
    pub(super) fn refuse(&self, peer: SocketAddr, what: &str) {
        let count = self.refused.fetch_add(1, Ordering::Relaxed) + 1;
        // Whoever floods the server shall not flood the notes.
        if count <= 100 || count.is_power_of_two() {
            // What came from outside may hold anything.
            let what: String = what.chars().filter(|c| !c.is_control()).take(300).collect();
            (self.note)(&format!("refused ({count}): {peer}: {what}"));
        }
    }
}
