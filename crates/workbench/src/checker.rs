//! Looks at problems on a thread of its own, so that a page whose problem has many cases can still stop a run.

use std::sync::mpsc::{Receiver, Sender, channel};

use serde_json::Value;

use crate::answers::{checked, unchecked};
use crate::messages::Wrong;

/// A thread that looks at problems.
pub(crate) struct Checker {
    ask: Sender<(u64, Value)>,
    told: Receiver<String>,
}

impl Checker {
    /// Starts the thread, which ends with this.
    pub(crate) fn start() -> std::io::Result<Self> {
        let (ask, asked) = channel::<(u64, Value)>();
        let (tell, told) = channel();
        std::thread::Builder::new().name("check".to_owned()).spawn(move || {
            while let Ok(mut latest) = asked.recv() {
                // Who types fast has no use for what was.
                while let Ok(later) = asked.try_recv() {
                    latest = later;
                }
                let (id, value) = latest;
                let answer = std::panic::catch_unwind(|| checked(id, value)).unwrap_or_else(|_| {
                    let words = "the check broke off; this is a fault of the program";
                    unchecked(id, None, Wrong::words(words))
                });
                if tell.send(answer).is_err() {
                    return;
                }
            }
        })?;
        Ok(Self { ask, told })
    }

    /// Asks for a look at a problem.
    pub(crate) fn ask(&self, id: u64, value: Value) {
        // A thread that has ended has told why.
        let _ = self.ask.send((id, value));
    }

    /// What was found since.
    pub(crate) fn poll(&self, tell: &mut dyn FnMut(String)) {
        self.told.try_iter().for_each(tell);
    }
}
