//! `soilctl console`: operates a live session, or plays a log.

mod board;
mod editor;
mod live;
mod panel;
mod play;

use soilctl_app::Outcome;
use soilctl_app::request::finite;
use std::io::{BufRead, IsTerminal};
use std::path::PathBuf;

use crate::error::CliError;
use crate::output::Output;
use editor::Prompt;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Commands come from a prompt with completion and history, from --script, or from a pipe, one a line; `help` lists \
    them, `#` begins a comment. A script or pipe ends at the first command that is refused, with exit code 1. With --format \
    json every message of the session is one line of JSON (docs/live.md). Exit code 3: the played log is damaged, and what can be read \
    of it was played."
)]
pub(crate) struct Args {
    /// Socket of a running session
    #[arg(long, value_name = "PATH", required_unless_present = "play", conflicts_with = "play")]
    connect: Option<PathBuf>,

    /// A log to play (.mcap)
    #[arg(long, value_name = "LOG")]
    play: Option<PathBuf>,

    /// File with commands
    #[arg(long, value_name = "FILE", conflicts_with = "watch")]
    script: Option<PathBuf>,

    /// Show joints, forces, state and events, and nothing else, until the end
    #[arg(long)]
    watch: bool,

    /// Where a played log begins (s)
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = finite, requires = "play")]
    from: f64,

    /// How fast it is watched, as a multiple of real time
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = finite, requires = "play")]
    speed: f64,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    if !(args.speed > 0.0 && args.speed <= 1000.0) {
        return Err(CliError::Usage(format!(
            "--speed is {}; it must be above 0 and at most 1000",
            args.speed
        )));
    }
    match (&args.connect, &args.play) {
        (Some(socket), _) => live::run(args, socket, output),
        (None, Some(log)) => play::run(args, log, output),
        (None, None) => Err(CliError::Usage("give --connect or --play".to_owned())),
    }
}

/// Where commands come from.
enum Source {
    /// A person.
    Prompt(Box<Prompt>),
    /// A file or a pipe.
    Lines(Box<dyn Iterator<Item = std::io::Result<String>>>),
}

impl Source {
    fn of(args: &Args, words: &'static [&'static str]) -> Result<Self, CliError> {
        let failed = |path: &PathBuf, problem| CliError::File { path: path.display().to_string(), problem };
        Ok(match &args.script {
            Some(path) => {
                let file = std::fs::File::open(path).map_err(|problem| failed(path, problem))?;
                Self::Lines(Box::new(std::io::BufReader::new(file).lines()))
            }
            None if std::io::stdin().is_terminal() => Self::Prompt(Box::new(Prompt::new(words)?)),
            None => Self::Lines(Box::new(std::io::stdin().lines())),
        })
    }

    /// Whether a wrong command is no reason to end.
    const fn is_prompt(&self) -> bool {
        matches!(self, Self::Prompt(_))
    }

    /// The next command without comment; none at the end.
    fn next(&mut self) -> Result<Option<String>, CliError> {
        loop {
            let line = match self {
                Self::Prompt(prompt) => prompt.read()?,
                Self::Lines(lines) => lines.next().transpose()?,
            };
            let Some(line) = line else { return Ok(None) };
            let line = line.split('#').next().unwrap_or_default().trim();
            if !line.is_empty() {
                return Ok(Some(line.to_owned()));
            }
        }
    }
}
