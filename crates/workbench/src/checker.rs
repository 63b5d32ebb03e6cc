//! Looks at problems on a thread of its own, so that a page whose problem has many cases can still stop a run.

use std::sync::mpsc::{Receiver, Sender, channel};

use serde_json::Value;
use soilctl_app::Unwatched;
use soilctl_app::solve::check;

use crate::messages::{Told, Wrong, problem};

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
                let answer = std::panic::catch_unwind(|| checked(id, value))
                    .unwrap_or_else(|_| broken(id, "the check broke off; this is a fault of the program"));
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

fn broken(id: u64, words: &str) -> String {
    wrong(id, None, Wrong::words(words))
}

fn wrong(id: u64, toml: Option<String>, error: Wrong) -> String {
    let error = Some(error);
    Told::Checked { id, toml, understood: None, answer: None, notes: Vec::new(), error }.text()
}

fn checked(id: u64, value: Value) -> String {
    let description = match problem(value) {
        Ok(description) => description,
        Err(error) => return wrong(id, None, error),
    };
    let toml = match description.to_toml() {
        Ok(toml) => Some(toml),
        Err(error) => return wrong(id, None, (&error).into()),
    };
    match check::of(description, &Unwatched) {
        Ok(found) => Told::Checked {
            id,
            toml,
            understood: Some(soilctl_pages::solve::understood(&found)),
            notes: found.answer.notes.iter().map(|note| Wrong::note(note)).collect(),
            answer: Some(&found.answer),
            error: None,
        }
        .text(),
        Err(error) => wrong(id, toml, (&error).into()),
    }
}
