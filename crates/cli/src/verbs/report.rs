//! `soilctl report`: one HTML page with the estimate, its figures and what they mean.

use soilctl_app::{Answer as _, Outcome, report};
use soilctl_pages::report::page;

use super::pages::{self, FigureFiles};
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(flatten)]
    request: report::Request,

    #[command(flatten)]
    figures: FigureFiles,

    /// Opens the page in the browser
    #[arg(long)]
    open: bool,
}

impl Words for report::Answer {
    fn text(&self) -> String {
        format!("{}\nreport: {}\n", self.estimate.text(), self.report)
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let report = report::run(&args.request, output)?;
    let out = &args.request.out;
    pages::write(&mut page(&report)?, Some(out), &args.figures, output)?;
    if args.open
        && let Err(problem) = open::that_detached(out)
    {
        output.note(&format!("the page could not be opened ({problem}); open {} yourself", out.display()));
    }
    let answer = report.into_answer(out);
    output.answer(&answer)?;
    Ok(answer.outcome())
}
