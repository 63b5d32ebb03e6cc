//! What the verbs that bound collapse loads share: the budget, progress, how levels are told, and what is shown of a
//! solution.

mod levels;
mod show;
mod why;

use std::path::PathBuf;

pub(crate) use levels::{LevelAnswer, level_page_table, level_table, note_doubts};
pub(crate) use show::{ResultsAnswer, Show, Shown, Told, bounds_table, proven};
use soilctl_limit_analysis::{Factorisation, Level, Options};
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

    /// Most elements of a mesh
    #[arg(long, value_name = "N", default_value_t = 20_000, value_parser = clap::value_parser!(u32).range(1000..=1_000_000))]
    max_elements: u32,

    /// Work that may be spent: elements of each mesh times steps of the solver on it, the same on every machine
    #[arg(long, value_name = "N", default_value_t = Options::MAX_WORK, value_parser = clap::value_parser!(u64).range(1..))]
    max_work: u64,

    /// Time that may be spent (s); where the run ends then depends on the machine, and the answer says so [default: any]
    #[arg(long, value_name = "S", value_parser = positive)]
    max_seconds: Option<f64>,

    /// Memory that may be used (MB): a mesh whose programs may need more is not made
    #[arg(long, value_name = "MB", value_parser = clap::value_parser!(u32).range(100..))]
    max_memory: Option<u32>,

    /// Threads; the bounds are the same for any number
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: u32,

    /// What factorises the systems of the solver's steps: bounds differ in their last digits; `auto` goes by the size of the
    /// programs
    #[arg(long, value_name = "WHICH", default_value = "auto")]
    factorisation: Choice,

    /// Solves with strength linearised to so many sides, from inside, instead of cones: for comparison, slower and wider
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(3..=1000))]
    segments: Option<u32>,

    /// Existing folder for programs on which the solver failed, to reproduce that from
    #[arg(long, value_name = "DIR")]
    dump: Option<PathBuf>,
}

/// What `--factorisation` may say.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Choice {
    /// By the size of each program
    Auto,
    /// Column by column: the same bits on every machine
    Qdldl,
    /// In blocks, for large meshes: the same bits on machines with the same processor
    Faer,
}

impl Budget {
    /// The same for the solver; Ctrl-C or SIGTERM ends the run with the best bounds so far.
    pub(crate) fn options(&self, output: &Output) -> Result<Options, CliError> {
        if let Some(dir) = self.dump.as_ref().filter(|dir| !dir.is_dir()) {
            return Err(CliError::Usage(format!(
                "--dump is {}, which is no folder; make it first, or leave the option out",
                dir.display()
            )));
        }
        Ok(Options {
            max_gap: self.max_gap,
            max_elements: self.max_elements as usize,
            max_work: self.max_work,
            max_seconds: self.max_seconds,
            max_memory_bytes: self.max_memory.map_or(u64::MAX, |mb| u64::from(mb) * 1_000_000),
            threads: self.threads as usize,
            factorisation: match self.factorisation {
                Choice::Auto => None,
                Choice::Qdldl => Some(Factorisation::Qdldl),
                Choice::Faer => Some(Factorisation::Faer),
            },
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
