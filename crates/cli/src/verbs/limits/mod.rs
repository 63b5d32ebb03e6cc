//! What the verbs that bound collapse loads share: the budget, progress, how levels are told, and what is shown of a
//! solution.

mod levels;
mod show;
mod why;

use std::path::PathBuf;

pub(crate) use levels::{LevelAnswer, ended, level_page_table, level_table, note_doubts};
pub(crate) use show::{ResultsAnswer, Show, Shown, Told, bounds_table, proven};
use soilctl_limit_analysis::{Level, Options};
pub(crate) use why::Watch;

use crate::args::finite;
use crate::error::CliError;
use crate::output::Output;

/// When to stop, and what may be spent.
#[derive(Debug, clap::Args)]
pub(crate) struct Budget {
    /// Gap (U - L) / ((U + L) / 2) at which to stop
    #[arg(long, value_name = "FRACTION", default_value_t = 0.01, value_parser = positive)]
    pub(crate) max_gap: f64,

    /// Time that may be spent (s)
    #[arg(long, value_name = "S", default_value_t = 60.0, value_parser = positive)]
    max_seconds: f64,

    /// Most elements of a mesh
    #[arg(long, value_name = "N", default_value_t = 20_000, value_parser = clap::value_parser!(u32).range(1000..=1_000_000))]
    max_elements: u32,

    /// Memory that may be used (MB): a mesh whose programs may need more is not made
    #[arg(long, value_name = "MB", value_parser = clap::value_parser!(u32).range(100..))]
    max_memory: Option<u32>,

    /// Threads; the bounds are the same for any number
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: u32,

    /// Solves with strength linearised to so many sides, from inside, instead of cones: for comparison, slower and wider
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(3..=1000))]
    segments: Option<u32>,

    /// Existing folder for programs on which the solver failed, to reproduce that from
    #[arg(long, value_name = "DIR")]
    dump: Option<PathBuf>,
}

impl Budget {
    /// The same for the solver; Ctrl-C ends the run with the best bounds so far.
    pub(crate) fn options(&self, output: &Output) -> Result<Options, CliError> {
        if let Some(dir) = self.dump.as_ref().filter(|dir| !dir.is_dir()) {
            return Err(CliError::Usage(format!(
                "--dump is {}, which is no folder; make it first, or leave the option out",
                dir.display()
            )));
        }
        Ok(Options {
            max_gap: self.max_gap,
            max_seconds: self.max_seconds,
            max_elements: self.max_elements as usize,
            max_memory_bytes: self.max_memory.map_or(u64::MAX, |mb| u64::from(mb) * 1_000_000),
            threads: self.threads as usize,
            segments: self.segments.map(|n| n as usize),
            dump: self.dump.clone(),
            stop: output.interrupt(),
        })
    }
}

pub(crate) fn positive(text: &str) -> Result<f64, String> {
    match finite(text)? {
        value if value > 0.0 => Ok(value),
        value => Err(format!("{value} is not above 0")),
    }
}

/// A level in a few words.
pub(crate) fn words(level: &Level, gap: Option<f64>) -> String {
    let elements = level.upper.elements;
    gap.map_or_else(
        || format!("{elements} elements, no bounds yet"),
        |gap| format!("{elements} elements, gap {:.2} %", 100.0 * gap.abs()),
    )
}
