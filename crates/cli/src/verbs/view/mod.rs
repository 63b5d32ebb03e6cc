//! `soilctl view LOG`: a log in the Rerun viewer, with what Rerun's own reader of logs does not show.

mod answer;
mod viewer;

use soilctl_app::Outcome;
use std::path::{Path, PathBuf};

pub(crate) use answer::ViewAnswer;
use soilctl_recording::{FOXGLOVE_LAYOUT, record};

use crate::bag_args::BagArgs;
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes a recording (.rrd) and opens it in the Rerun viewer, if that is installed: `pip install rerun-sdk` brings \
    it. The viewer runs on by itself. Exit code 3: the log is damaged, and what can be read of it is shown. docs/view.md tells what \
    is where."
)]
pub(crate) struct Args {
    /// A log (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag)
    log: PathBuf,

    #[command(flatten)]
    bag: BagArgs,

    /// The recording to write; left out: beside the log, ending in .rrd
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,

    /// Only write, open nothing
    #[arg(long, conflicts_with = "viewer")]
    no_open: bool,

    /// The viewer's program; left out: `rerun` on PATH
    #[arg(long, value_name = "PATH")]
    viewer: Option<PathBuf>,

    /// Write a layout for Foxglove too, which opens logs as they are (.json)
    #[arg(long, value_name = "FILE")]
    foxglove_layout: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let out = args.out.clone().unwrap_or_else(|| args.log.with_extension("rrd"));
    if out.extension().is_none_or(|ending| ending != "rrd") {
        return Err(CliError::Usage(format!("--out is {}; the name must end in .rrd", out.display())));
    }
    if same(&args.log, &out) {
        return Err(CliError::Usage(format!("{} is the log itself; give another --out", out.display())));
    }
    let settings = args.bag.settings()?;
    let spinner = output.spinner("reading the log");
    let recording = record(&args.log, &out, &settings);
    spinner.finish_and_clear();
    let recording = recording?;
    if let Some(path) = &args.foxglove_layout {
        soilctl_app::files::save(path, FOXGLOVE_LAYOUT.as_bytes())?;
    }
    for damage in &recording.damage {
        output.note(&format!("damaged: {damage}"));
    }
    for note in recording.foreign.iter().flat_map(|foreign| &foreign.notes) {
        output.note(note);
    }
    let opened = if args.no_open { None } else { viewer::open(args.viewer.as_deref(), &out)? };
    if opened.is_none() {
        output.note(&format!(
            "to look at it: `pip install rerun-sdk`, then `rerun {}` (Rerun 0.41 or later)",
            out.display()
        ));
    }
    let outcome = if recording.damage.is_empty() { Outcome::Done } else { Outcome::Partial };
    output.answer(&ViewAnswer::new(recording, &out, args.foxglove_layout.as_deref(), opened))?;
    Ok(outcome)
}

fn same(log: &Path, out: &Path) -> bool {
    matches!((log.canonicalize(), out.canonicalize()), (Ok(log), Ok(out)) if log == out)
}
