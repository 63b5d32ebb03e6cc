//! A workbench without a server, as it works in a browser.

use std::sync::Arc;

use soilctl_app::solve::Solved;

use crate::answers;
use crate::messages::{Request, Told, Wrong, problem};
use crate::watched::{Watched, request};

/// Answers the messages of one page, one after another, in the thread that brings them: what [`Workbench`](crate::Workbench) answers over
/// its connection, but for a file and its token. A run ends when it is done; who wants to stop it ends the thread, as browsers can.
pub struct Desk {
    tell: fn(String),
    found: Option<Box<Solved>>,
}

impl Desk {
    /// A desk that tells its page something by `tell`, now its greeting.
    #[must_use]
    pub fn open(tell: fn(String)) -> Self {
        tell(answers::hello(None));
        Self { tell, found: None }
    }

    /// Does what a message asks for.
    pub fn obey(&mut self, line: &str) {
        let tell = self.tell;
        match serde_json::from_str::<Request>(line) {
            Err(problem) => tell(Told::refusal(&format!("this is no message of a page: {problem}"))),
            Ok(Request::Authorize { .. }) => {
                tell(Told::File { text: None, problem: None, error: None }.text())
            }
            Ok(Request::Check { id, problem }) => tell(answers::checked(id, problem)),
            Ok(Request::Read { id, text }) => tell(answers::read(id, &text)),
            Ok(Request::Draw { id, name, text }) => tell(answers::drawn(id, &name, &text)),
            Ok(Request::Drawing { id, problem }) => tell(answers::drawing(id, problem)),
            Ok(Request::Solve { id, problem: value, budget }) => {
                self.found = None;
                let description = match problem(value) {
                    Ok(description) => description,
                    Err(error) => return tell(Told::Failed { id, error }.text()),
                };
                tell(Told::Begun { id }.text());
                let watch = Watched::new(id, Arc::default(), Box::new(tell));
                let (ended, found) = answers::solved(id, description, &request(budget, 1), &watch);
                self.found = found;
                tell(ended);
            }
            Ok(Request::Stop {}) => {}
            Ok(Request::Save { id, .. }) => {
                let error = Wrong::words("there is no server to save a file; download the problem instead");
                tell(Told::NotSaved { id, error, changed: false }.text());
            }
            Ok(Request::Certificate { id }) => tell(answers::certificate(id, self.found.as_deref())),
            Ok(Request::Report { id, name }) => tell(answers::report(id, self.found.as_deref(), &name)),
            Ok(Request::Probe { id, from, to }) => {
                tell(answers::probed(id, self.found.as_deref(), from, to));
            }
            Ok(Request::Certify { id, name, text }) => tell(answers::certified(id, &name, &text)),
            Ok(Request::Plate { id, plate }) => tell(answers::plate(id, &plate)),
            Ok(Request::Strokes { id, strokes }) => tell(answers::strokes(id, strokes)),
            Ok(Request::Next { id, next }) => tell(answers::next(id, next)),
        }
    }
}
