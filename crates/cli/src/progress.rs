//! How far long work is: shown as a bar, and counted for a host that looks.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Between two pictures of a line that moves.
const TICK: Duration = Duration::from_millis(100);

/// Steps of the work that a verb is at: cells, strokes, logs. Any thread may look at any time.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicU64,
    of: AtomicU64,
}

impl Progress {
    /// Steps done, and how many there are; (0, 0) as long as nothing is counted.
    #[must_use]
    pub fn get(&self) -> (u64, u64) {
        let of = self.of.load(Ordering::Acquire);
        (self.done.load(Ordering::Relaxed).min(of), of)
    }

    /// New work of so many steps.
    pub(crate) fn begin(&self, of: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.of.store(of, Ordering::Release);
    }

    /// Steps that were done before this run, or in it.
    pub(crate) fn add(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }
}

/// A bar on stderr, hidden where nobody could see it, whose steps are counted for a host, too.
pub(crate) struct Bar {
    shown: ProgressBar,
    counted: Arc<Progress>,
}

impl Bar {
    /// Steps called `name`; if nobody knows how many there are, a line that says `name`.
    pub(crate) fn new(steps: u64, name: &str, hidden: bool, counted: Arc<Progress>) -> Self {
        counted.begin(steps);
        if hidden {
            return Self { shown: ProgressBar::hidden(), counted };
        }
        if steps == 0 {
            let line = Self { shown: ProgressBar::new_spinner(), counted };
            line.say(name);
            return line;
        }
        let shown = ProgressBar::new(steps);
        let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {name}, {{eta}} left"));
        Self { shown: style.map_or_else(|_| shown.clone(), |style| shown.clone().with_style(style)), counted }
    }

    pub(crate) fn inc(&self, steps: u64) {
        self.shown.inc(steps);
        self.counted.add(steps);
    }

    /// Shows a line of text in place of the bar.
    pub(crate) fn say(&self, text: &str) {
        if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {msg}") {
            self.shown.set_style(style);
        }
        self.shown.set_message(text.to_owned());
        self.shown.enable_steady_tick(TICK);
    }

    /// Writes beside the bar.
    pub(crate) fn suspend(&self, write: impl FnOnce()) {
        self.shown.suspend(write);
    }

    pub(crate) fn finish(&self) {
        self.shown.finish_and_clear();
    }
}
