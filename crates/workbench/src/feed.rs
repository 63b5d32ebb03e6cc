//! What one page is told, and what it asks.

use std::sync::Arc;
use std::sync::atomic::AtomicUsize;
use std::time::Instant;

use serde_json::Value;
use soilctl_app::solve::Solved;
use soilctl_limit_analysis::Description;
use soilctl_web::{Feed, Heard, is_same};

use crate::file::ProblemFile;
use crate::latest::Latest;
use crate::messages::{Request, Spend, Told, Wrong, problem};
use crate::run::Run;
use crate::{WorkbenchError, answers, plate, strokes};

/// Tokens that a page may try.
const MOST_WRONG_TOKENS: u32 = 5;

/// A page.
pub(crate) struct Page {
    file: Option<Arc<ProblemFile>>,
    token: Arc<str>,
    running: Arc<AtomicUsize>,
    checks: Latest<Value>,
    plates: Latest<plate::Given>,
    strokes: Latest<strokes::Given>,
    next: Latest<strokes::Given>,
    run: Option<Run>,
    found: Option<Box<Solved>>,
    greeted: bool,
    authorized: bool,
    wrong_tokens: u32,
}

impl Page {
    pub(crate) fn new(
        file: Option<Arc<ProblemFile>>,
        token: Arc<str>,
        running: Arc<AtomicUsize>,
    ) -> Result<Self, String> {
        let unchecked = |id, words: &str| answers::unchecked(id, None, Wrong::words(words));
        let checks = Latest::start("check", answers::checked, unchecked)?;
        let plates = Latest::start("plate", |id, plate| answers::plate(id, &plate), answers::no_plate)?;
        let strokes = Latest::start("estimate", answers::strokes, answers::no_strokes)?;
        let next = Latest::start("choose", answers::next, answers::no_next)?;
        Ok(Self {
            file,
            token,
            running,
            checks,
            plates,
            strokes,
            next,
            run: None,
            found: None,
            greeted: false,
            authorized: false,
            wrong_tokens: 0,
        })
    }

    fn authorize(&mut self, given: &str) -> Heard {
        if !is_same(self.token.as_bytes(), given.as_bytes()) {
            self.wrong_tokens += 1;
            let away = (self.wrong_tokens > MOST_WRONG_TOKENS).then_some("too many wrong tokens");
            let words = "the token is wrong; open the address that the workbench printed";
            return Heard { send_away: away, ..self.refuse(words, false) };
        }
        self.authorized = true;
        let Some(file) = &self.file else {
            return answer(&Told::File { text: None, problem: None, error: None });
        };
        let text = match file.text() {
            Ok(text) => text,
            Err(problem) => {
                let error = Some(Wrong::words(problem.to_string()));
                return answer(&Told::File { text: None, problem: None, error });
            }
        };
        let read = text.as_deref().map(Description::from_toml).transpose();
        let error = read.as_ref().err().map(Wrong::from);
        answer(&Told::File { text, problem: read.ok().flatten().as_ref(), error })
    }

    fn solve(&mut self, id: u64, value: Value, spend: Spend) -> Heard {
        // A page has one run: the one before ends without an answer.
        self.run = None;
        self.found = None;
        match problem(value).and_then(|description| Run::start(id, description, spend, &self.running)) {
            Ok(run) => {
                self.run = Some(run);
                answer(&Told::Begun { id })
            }
            Err(error) => answer(&Told::Failed { id, error }),
        }
    }

    fn save(&self, id: u64, text: &str, anyway: bool) -> Heard {
        let saved = match (&self.file, self.authorized) {
            (Some(_), false) => {
                let words = "this page may not save, since it does not know the token; open the address that the workbench printed";
                let told = Told::NotSaved { id, error: Wrong::words(words), changed: false };
                return Heard { refused: Some(words.to_owned()), ..answer(&told) };
            }
            (Some(file), true) => file.save(text, anyway).map(|()| file.name()),
            (None, _) => Err(WorkbenchError::NoFile),
        };
        match saved {
            Ok(name) => answer(&Told::Saved { id, name }),
            Err(problem) => {
                let changed =
                    matches!(problem, WorkbenchError::Changed { .. } | WorkbenchError::Strange { .. });
                answer(&Told::NotSaved { id, error: Wrong::words(problem.to_string()), changed })
            }
        }
    }
}

fn answer(told: &Told) -> Heard {
    said(told.text())
}

fn said(text: String) -> Heard {
    Heard { answer: Some(text), ..Heard::default() }
}

impl Feed for Page {
    fn poll(&mut self, _: Instant, tell: &mut dyn FnMut(String)) {
        if !self.greeted {
            self.greeted = true;
            let file = self.file.as_ref().map(|file| file.name());
            tell(answers::hello(file));
        }
        self.checks.poll(tell);
        self.plates.poll(tell);
        self.strokes.poll(tell);
        self.next.poll(tell);
        if self.run.as_ref().is_some_and(|run| run.poll(tell, &mut self.found)) {
            self.run = None;
        }
    }

    fn obey(&mut self, line: &str) -> Heard {
        match serde_json::from_str::<Request>(line) {
            Err(problem) => self.refuse(&format!("this is no message of a page: {problem}"), false),
            Ok(Request::Authorize { token }) => self.authorize(&token),
            Ok(Request::Check { id, problem }) => {
                self.checks.ask(id, problem);
                Heard::default()
            }
            Ok(Request::Plate { id, plate }) => {
                self.plates.ask(id, plate);
                Heard::default()
            }
            Ok(Request::Strokes { id, strokes }) => {
                self.strokes.ask(id, strokes);
                Heard::default()
            }
            Ok(Request::Next { id, next }) => {
                self.next.ask(id, next);
                Heard::default()
            }
            Ok(Request::Read { id, text }) => said(answers::read(id, &text)),
            Ok(Request::Draw { id, name, text }) => said(answers::drawn(id, &name, &text)),
            Ok(Request::Drawing { id, problem }) => said(answers::drawing(id, problem)),
            Ok(Request::Solve { id, problem, budget }) => self.solve(id, problem, budget),
            Ok(Request::Stop {}) => {
                self.run.iter().for_each(Run::stop);
                Heard::default()
            }
            Ok(Request::Save { id, text, anyway }) => self.save(id, &text, anyway),
            Ok(Request::Certificate { id }) => said(answers::certificate(id, self.found.as_deref())),
            Ok(Request::Report { id, name }) => said(answers::report(id, self.found.as_deref(), &name)),
            Ok(Request::Probe { id, from, to }) => said(answers::probed(id, self.found.as_deref(), from, to)),
            Ok(Request::Certify { id, name, text }) => said(answers::certified(id, &name, &text)),
        }
    }

    fn refuse(&self, what: &str, _: bool) -> Heard {
        Heard { refused: Some(what.to_owned()), ..said(Told::refusal(what)) }
    }
}
