//! Everything that is written: the answer to stdout, notes and errors to stderr.

use std::io::{IsTerminal, Write};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, OnceLock};

use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};
use signal_hook::consts::{SIGINT, SIGTERM};
use soilctl_app::{Interrupted, Watch};

use crate::error::CliError;
use crate::progress::{Bar, Progress};

/// Form of the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    Text,
    /// One JSON document
    Json,
}

/// What a verb answers, in words.
pub(crate) trait Words: soilctl_app::Answer {
    /// The answer for people, ending in a line feed.
    fn text(&self) -> String;
}

/// Where answers and notes go.
pub(crate) struct Output {
    format: Format,
    quiet: bool,
    host: Host,
    /// Set by Ctrl-C and SIGTERM; made when it is first asked for, and the same for all work of this run.
    stop: OnceLock<Arc<AtomicBool>>,
    /// How far the work is.
    progress: Arc<Progress>,
    /// The bar of work that a use case has begun.
    bar: Mutex<Option<Bar>>,
    /// The command line, as pages show it.
    command: String,
}

/// What runs the verb.
enum Host {
    /// The program: the answer goes to stdout, Ctrl-C and SIGTERM set a flag.
    Program,
    /// Another program, in its process: it keeps the answer, and sets the flag by itself.
    Library { answer: Vec<u8>, stop: Arc<AtomicBool> },
}

/// Tells the user something beside the answer, from any thread.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Notes {
    quiet: bool,
}

impl Notes {
    pub(crate) fn note(self, text: &str) {
        if !self.quiet {
            // A closed stderr must not change the answer.
            let _ = writeln!(std::io::stderr(), "{text}");
        }
    }
}

impl Output {
    pub(crate) fn new(format: Format, quiet: bool) -> Self {
        Self {
            format,
            quiet,
            host: Host::Program,
            stop: OnceLock::new(),
            progress: Arc::default(),
            bar: Mutex::new(None),
            command: String::new(),
        }
    }

    /// Keeps the answer in JSON, writes nothing, and counts what is done in `progress`.
    pub(crate) const fn kept(stop: Arc<AtomicBool>, progress: Arc<Progress>) -> Self {
        let host = Host::Library { answer: Vec::new(), stop };
        Self {
            format: Format::Json,
            quiet: true,
            host,
            stop: OnceLock::new(),
            progress,
            bar: Mutex::new(None),
            command: String::new(),
        }
    }

    /// Says which command line this is the output of.
    pub(crate) fn of_command(mut self, line: String) -> Self {
        self.command = line;
        self
    }

    /// The command line, as pages show it.
    pub(crate) fn command(&self) -> &str {
        &self.command
    }

    /// The answer that was kept; empty for a program.
    pub(crate) fn into_kept(self) -> Vec<u8> {
        match self.host {
            Host::Program => Vec::new(),
            Host::Library { answer, .. } => answer,
        }
    }

    /// Writes the one answer of this run.
    pub(crate) fn answer<A: Words>(&mut self, answer: &A) -> Result<(), CliError> {
        let text = match self.format {
            Format::Text => {
                soilctl_app::check_finite(answer)?;
                answer.text()
            }
            Format::Json => soilctl_app::document(answer)?,
        };
        self.raw(text.as_bytes())
    }

    /// Writes bytes to stdout, or keeps them.
    pub(crate) fn raw(&mut self, bytes: &[u8]) -> Result<(), CliError> {
        if let Host::Library { answer, .. } = &mut self.host {
            answer.extend_from_slice(bytes);
            return Ok(());
        }
        let mut stdout = std::io::stdout().lock();
        stdout.write_all(bytes)?;
        Ok(stdout.flush()?)
    }

    /// Whether answers are for programs.
    pub(crate) fn is_json(&self) -> bool {
        self.format == Format::Json
    }

    /// Whether notes are kept from the user.
    pub(crate) const fn is_quiet(&self) -> bool {
        self.quiet
    }

    /// Tells the user something beside the answer.
    pub(crate) fn note(&self, text: &str) {
        self.notes().note(text);
    }

    /// The same for other threads.
    pub(crate) const fn notes(&self) -> Notes {
        Notes { quiet: self.quiet }
    }

    /// Tells the user what went wrong in the middle of an answer.
    pub(crate) fn problem(&self, text: &str) {
        let _ = writeln!(std::io::stderr(), "error: {text}");
    }

    /// Tells the user why there is no answer.
    pub(crate) fn error(&self, error: &CliError) {
        let _ = writeln!(std::io::stderr(), "error: {error}");
    }

    /// A line on stderr that says what goes on; hidden like a progress bar.
    pub(crate) fn spinner(&self, message: &'static str) -> ProgressBar {
        if self.quiet || !std::io::stderr().is_terminal() {
            return ProgressBar::hidden();
        }
        let spinner = ProgressBar::new_spinner().with_message(message);
        spinner.enable_steady_tick(std::time::Duration::from_millis(100));
        match ProgressStyle::with_template("{spinner} {elapsed} {msg}") {
            Ok(style) => spinner.with_style(style),
            Err(_) => spinner,
        }
    }

    /// A progress bar on stderr over steps that are called `name`; hidden if that is no terminal, or nobody wants to see it.
    pub(crate) fn bar(&self, steps: u64, name: &str) -> Bar {
        Bar::new(steps, name, self.quiet || !std::io::stderr().is_terminal(), Arc::clone(&self.progress))
    }
}

impl Watch for Output {
    fn stop(&self, interrupted: Interrupted) -> Arc<AtomicBool> {
        match &self.host {
            Host::Program if interrupted == Interrupted::KeepsResults => {
                let stop = self.stop.get_or_init(|| {
                    let stop = Arc::new(AtomicBool::new(false));
                    for signal in [SIGINT, SIGTERM] {
                        // If the handler cannot be set, the signal ends the program.
                        let _ = signal_hook::flag::register(signal, Arc::clone(&stop));
                    }
                    stop
                });
                Arc::clone(stop)
            }
            // There is nothing to keep: a signal just ends the program.
            Host::Program => Arc::new(AtomicBool::new(false)),
            Host::Library { stop, .. } => Arc::clone(stop),
        }
    }

    fn begin(&self, steps: u64, name: &str) {
        self.with_bar(|bar| *bar = Some(self.bar(steps, name)));
    }

    fn advance(&self, steps: u64) {
        self.with_bar(|bar| bar.iter().for_each(|bar| bar.inc(steps)));
    }

    fn say(&self, text: &str) {
        self.with_bar(|bar| bar.iter().for_each(|bar| bar.say(text)));
    }

    fn end(&self) {
        self.with_bar(|bar| bar.take().iter().for_each(Bar::finish));
    }

    fn note(&self, text: &str) {
        self.with_bar(|bar| match bar {
            Some(bar) => bar.suspend(|| self.notes().note(text)),
            None => self.notes().note(text),
        });
    }
}

impl Output {
    /// Nobody panics while holding the bar, and if so it is as good as before.
    fn with_bar(&self, act: impl FnOnce(&mut Option<Bar>)) {
        act(&mut self.bar.lock().unwrap_or_else(std::sync::PoisonError::into_inner));
    }
}
