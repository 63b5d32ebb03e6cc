//! Everything that is written: the answer to stdout, notes and errors to stderr.

use std::io::{IsTerminal, Write};

use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};
use schemars::JsonSchema;
use serde::Serialize;

use crate::error::CliError;
use crate::finite;

/// Form of the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    Text,
    /// One JSON document
    Json,
}

/// What a verb answers: data for JSON, and the same in words.
pub(crate) trait Answer: Serialize {
    /// Schema id, `soilctl.<verb>/1`.
    const SCHEMA: &'static str;

    /// The answer for people, ending in a line feed.
    fn text(&self) -> String;
}

/// An answer with what every JSON document starts with.
#[derive(Serialize, JsonSchema)]
pub(crate) struct Document<'a, A> {
    /// Id of this schema.
    schema: &'a str,
    /// Version of the program.
    version: &'a str,
    #[serde(flatten)]
    answer: &'a A,
}

/// Where answers and notes go.
pub(crate) struct Output {
    format: Format,
    quiet: bool,
}

impl Output {
    pub(crate) const fn new(format: Format, quiet: bool) -> Self {
        Self { format, quiet }
    }

    /// Writes the one answer of this run.
    pub(crate) fn answer<A: Answer>(&mut self, answer: &A) -> Result<(), CliError> {
        finite::check(answer)?;
        let document = Document { schema: A::SCHEMA, version: env!("CARGO_PKG_VERSION"), answer };
        let text = match self.format {
            Format::Text => answer.text(),
            Format::Json => serde_json::to_string_pretty(&document)? + "\n",
        };
        self.raw(text.as_bytes())
    }

    /// Writes bytes to stdout.
    pub(crate) fn raw(&mut self, bytes: &[u8]) -> Result<(), CliError> {
        let mut stdout = std::io::stdout().lock();
        stdout.write_all(bytes)?;
        Ok(stdout.flush()?)
    }

    /// Whether answers are for programs.
    pub(crate) fn is_json(&self) -> bool {
        self.format == Format::Json
    }

    /// Tells the user something beside the answer.
    pub(crate) fn note(&self, text: &str) {
        if !self.quiet {
            // A closed stderr must not change the answer.
            let _ = writeln!(std::io::stderr(), "{text}");
        }
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

    /// A progress bar on stderr; hidden if that is no terminal, or nobody wants to see it.
    pub(crate) fn progress(&self, steps: u64) -> ProgressBar {
        self.progress_of(steps, "cells")
    }

    /// The same for steps that are called something else.
    pub(crate) fn progress_of(&self, steps: u64, name: &str) -> ProgressBar {
        if self.quiet || !std::io::stderr().is_terminal() {
            return ProgressBar::hidden();
        }
        let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {name}, {{eta}} left"));
        let bar = ProgressBar::new(steps);
        match style {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }
}
