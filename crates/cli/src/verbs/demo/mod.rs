//! `soilctl demo`: a simulated campaign from the soil to the estimate, compared with the truth, on one page.

mod words;

use soilctl_app::demo::{self, Request};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes into DIR: plan.toml, a log for each preparation of the soil, strokes.csv, traces.csv, campaign.json, \
    measurements.csv, the estimates as JSON, figures/ and report.html, which needs no network. Ctrl-C keeps what is finished; \
    the same command goes on. The same soil, seed and model give the same bytes for any number of threads.\n\n\
    Exit codes: 1 no soil explains the forces; 3 strokes were lost, or the work was stopped."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// Opens the page in the browser
    #[arg(long)]
    open: bool,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let mut found = demo::run(&args.request, output)?;
    if found.work.is_some() {
        output.note("4 of 4: the page");
        soilctl_pages::demo::write(&mut found, output.command())?;
    }
    let answer = found.answer;
    if let (true, Some(page)) = (args.open, &answer.files.report)
        && let Err(problem) = open::that_detached(page)
    {
        output.note(&format!("the page could not be opened ({problem}); open {page} yourself"));
    }
    output.answer(&answer)?;
    Ok(answer.outcome())
}
