//! `soilctl workbench`: a page on which problems are drawn, solved and saved.

use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::time::Duration;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_app::Outcome;
use soilctl_workbench::{Settings, Workbench};

use super::serve;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Prints the page's address, serves it on this machine only, and ends at Ctrl-C. The page draws and edits what a problem \
    file says, checks it as it is typed, and bounds it with proof as `soilctl solve` does. FILE is the only file that it reads or writes; \
    one that is not there yet is begun. The address carries a token, without which FILE is neither shown nor saved. \
    Its button Plate leads to the plate's bench: forces by each model, and strokes (docs/bench.md). docs/workbench.md tells keys, messages and limits."
)]
pub(crate) struct Args {
    /// Problem file to edit, .toml or .json; without one the page downloads what is drawn
    file: Option<PathBuf>,

    /// Port on this machine; 0 takes any free one
    #[arg(long, value_name = "N", default_value_t = 8471)]
    port: u16,

    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

/// Where a workbench serves.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct WorkbenchAnswer {
    /// Address of the page, with the token.
    url: String,
    /// Where it listens.
    listen: String,
    /// The file that it reads and saves, as it was given; null without one.
    file: Option<String>,
}

impl soilctl_app::Answer for WorkbenchAnswer {
    const SCHEMA: &'static str = "soilctl.workbench/1";
}

impl Words for WorkbenchAnswer {
    fn text(&self) -> String {
        format!("{}\n", self.url)
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let signalled = serve::signalled()?;
    let notes = output.notes();
    let settings = Settings { port: args.port, note: Box::new(move |text| notes.note(text)) };
    let workbench = Workbench::start(args.file.as_deref(), settings)?;
    let answer = WorkbenchAnswer {
        url: workbench.url(),
        listen: workbench.address().to_string(),
        file: args.file.as_ref().map(|file| file.display().to_string()),
    };
    output.answer(&answer)?;
    output.note("Ctrl-C ends");
    // Kept as long as the workbench.
    let opened = args.open.then(|| serve::open_page(&answer.url, true));
    if matches!(opened, Some(Err(_))) {
        output.note("no browser could be started; open the address by hand");
    }
    while !signalled.load(Ordering::Relaxed) {
        std::thread::sleep(Duration::from_millis(50));
    }
    let counts = workbench.stop();
    output.note(&format!("pages: {}, refused: {}", counts.pages, counts.refused));
    Ok(Outcome::Done)
}
