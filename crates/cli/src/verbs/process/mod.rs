//! `soilctl process`: logs in, failure forces out.

mod words;

use std::path::PathBuf;

use soilctl_app::process::{self, Request};
use soilctl_app::{Answer as _, AppError, Outcome};
use soilctl_pages::process::{Kind, figure, page};
use soilctl_pages::save_figure;

use super::pages::{self, FigureFiles};
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "A log of soilctl says itself where its strokes are, with which arm and how they were meant. Of any \
    other ROS 2 bag (.mcap) joint states and wrenches are used; it needs --surface-z and --width, and --urdf if the bag \
    holds none. /truth is never read.\n\n\
    With --out, campaign.json and traces.csv are written beside the table, and manifest.jsonl says what became of each \
    log. The same command again goes on where it was stopped and reads only logs that are new or changed.\n\n\
    Exit codes: 1 no stroke has a failure force; 2 no log can be used; 3 some log is bad or damaged, or the work was \
    stopped.",
    mut_arg("figures", |figures| figures.conflicts_with("shard"))
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// One HTML page with figures and what they mean
    #[arg(long, value_name = "FILE", conflicts_with = "shard")]
    report: Option<PathBuf>,

    #[command(flatten)]
    figures: FigureFiles,

    /// A figure (.svg, .png) or its data (.csv)
    #[arg(long, value_name = "FILE", requires = "plot_kind", conflicts_with = "shard")]
    plot: Option<PathBuf>,

    /// Which figure
    #[arg(long, value_enum, requires = "plot")]
    plot_kind: Option<Kind>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let mut answer = match process::run(&args.request, output) {
        // Notes have said what is wrong with each.
        Err(AppError::NoLog { logs, .. }) if !output.is_quiet() => {
            return Err(CliError::Usage(format!("none of {logs} logs can be used")));
        }
        answer => answer?,
    };
    if let (Some(path), Some(kind)) = (&args.plot, args.plot_kind) {
        let figure = figure(kind, &answer.analysis, &answer.strokes)?;
        save_figure(&figure, path, soilctl_figure::Size::default())?;
        answer.written.push(path.display().to_string());
    }
    if args.report.is_some() || args.figures.figures.is_some() {
        let written = pages::write(&mut page(&answer)?, args.report.as_deref(), &args.figures, output)?;
        answer.written.extend(written);
    }
    output.answer(&answer)?;
    Ok(answer.outcome())
}
