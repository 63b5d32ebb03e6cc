//! `soilctl log`: what is in a log, whether it is well, saving what can be saved, and tables.

mod answer;

use std::path::{Path, PathBuf};

pub(crate) use answer::LogAnswer;
use clap::Subcommand;
use soilctl_session::{TableForm, export_until, info_until, recover_until, topics};

use super::Outcome;
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Exit code 1: doctor found problems in a whole file. Exit code 3: the file is damaged, and the answer is \
    about what could be read of it. What a log holds is described in docs/logs.md."
)]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Says what is in a log
    Info {
        /// A log (.mcap)
        log: PathBuf,
    },
    /// Checks a log: whole, checksums, types, quality of service, missing steps, key frames
    Doctor {
        /// A log (.mcap)
        log: PathBuf,
    },
    /// Copies what can be read of a damaged log into a new, whole one
    Recover {
        /// The damaged log (.mcap)
        log: PathBuf,
        /// File to write (.mcap)
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
    /// Writes the messages of a topic as a table, one row a message
    Export {
        /// A log (.mcap)
        log: PathBuf,
        /// File to write (.csv or .parquet)
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
        /// The topic: /controller/step, /joint_states, /motor_states, /wrench, /truth/joint_states or /truth/soil
        #[arg(long, value_name = "TOPIC", default_value = topics::STEP)]
        topic: String,
    },
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let spinner = output.spinner("reading the log");
    // Nothing that is half done can be kept.
    let stop = output.interrupt_keeping(false);
    let info = |log: &Path| info_until(log, &stop);
    let (answer, outcome) = match &args.action {
        Action::Info { log } => (LogAnswer::info(info(log)?), Outcome::Done),
        Action::Doctor { log } => {
            let answer = LogAnswer::doctor(info(log)?);
            let outcome = if answer.is_well() { Outcome::Done } else { Outcome::Negative };
            (answer, outcome)
        }
        Action::Recover { log, out } => {
            differ(log, out)?;
            let saved = recover_until(log, out, &stop)?;
            (LogAnswer::recover(info(out)?, saved, out), Outcome::Done)
        }
        Action::Export { log, out, topic } => {
            differ(log, out)?;
            (LogAnswer::export(export_until(log, topic, out, form(out)?, &stop)?, topic, out), Outcome::Done)
        }
    };
    spinner.finish_and_clear();
    output.answer(&answer)?;
    Ok(if answer.is_whole() { outcome } else { Outcome::Partial })
}

fn form(out: &Path) -> Result<TableForm, CliError> {
    match out.extension().and_then(|ending| ending.to_str()) {
        Some("csv") => Ok(TableForm::Csv),
        Some("parquet") => Ok(TableForm::Parquet),
        _ => {
            Err(CliError::Usage(format!("--out is {}; the name must end in .csv or .parquet", out.display())))
        }
    }
}

/// A log must not be overwritten by what is made of it.
fn differ(log: &Path, out: &Path) -> Result<(), CliError> {
    let same = match (log.canonicalize(), out.canonicalize()) {
        (Ok(log), Ok(out)) => log == out,
        _ => false,
    };
    if same {
        return Err(CliError::Usage(format!(
            "--out is {}, the log itself; give another name",
            out.display()
        )));
    }
    Ok(())
}
