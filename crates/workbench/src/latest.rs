//! Answers questions on a thread of its own, so that a page that has asked for something long is still heard; of several questions that
//! wait only the last is answered.

use std::panic::AssertUnwindSafe;
use std::sync::mpsc::{Receiver, Sender, channel};

/// A thread that answers questions of one kind.
pub(crate) struct Latest<Q> {
    ask: Sender<(u64, Q)>,
    told: Receiver<String>,
}

impl<Q: Send + 'static> Latest<Q> {
    /// Starts the thread, which ends with this. `broken` is told where `answer` breaks off, which is a fault of the program.
    pub(crate) fn start(
        name: &str,
        answer: fn(u64, Q) -> String,
        broken: fn(u64, &str) -> String,
    ) -> Result<Self, String> {
        let (ask, asked) = channel::<(u64, Q)>();
        let (tell, told) = channel();
        let work = move || {
            while let Ok(mut latest) = asked.recv() {
                // Who types fast has no use for what was.
                while let Ok(later) = asked.try_recv() {
                    latest = later;
                }
                let (id, question) = latest;
                let answer = std::panic::catch_unwind(AssertUnwindSafe(|| answer(id, question)));
                let answer =
                    answer.unwrap_or_else(|_| broken(id, "this broke off, which is a fault of the program"));
                if tell.send(answer).is_err() {
                    return;
                }
            }
        };
        let thread = std::thread::Builder::new().name(name.to_owned()).spawn(work);
        thread.map_err(|problem| format!("there is no thread to {name}: {problem}"))?;
        Ok(Self { ask, told })
    }

    /// Asks.
    pub(crate) fn ask(&self, id: u64, question: Q) {
        // A thread that has ended has told why.
        let _ = self.ask.send((id, question));
    }

    /// What was found since.
    pub(crate) fn poll(&self, tell: &mut dyn FnMut(String)) {
        self.told.try_iter().for_each(tell);
    }
}
