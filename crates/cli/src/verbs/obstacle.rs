//! `soilctl obstacle TOOL`: from what distance on the force of a tool says that something is buried ahead.

use std::path::PathBuf;

use soilctl_app::files::can_be_written;
use soilctl_app::obstacle::{self, Answer, Request, Verdict};
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::obstacle as pages;

use super::tool::tool_text;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The body is a block as wide as the tool: in plane strain it reaches as far to both sides as the tool does. Forces are along the motion, per metre of width; \
    ratios are to the force without the body. All bounds are proven with interval arithmetic. Exit code 3: bounds are missing, or the budget ended before the \
    gap was reached at some distance. Docs: docs/how/obstacles.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// Draws the ratio over the distance (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    plot: Option<PathBuf>,

    /// One HTML page with the figure, the table and the problem drawn
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    report: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    for path in [&args.plot, &args.report].into_iter().flatten() {
        can_be_written(path)?;
    }
    let found = obstacle::run(&args.request, output)?;
    output.answer(&found.answer)?;
    if let Some(path) = &args.plot {
        pages::save(&found.answer, path)?;
    }
    if let Some(path) = &args.report {
        soilctl_pages::write(&mut pages::page(&found)?, Some(path), None, output.command())?;
    }
    let outcome = found.answer.outcome();
    found.unsaved.map_or(Ok(outcome), |problem| Err(problem.into()))
}

impl Words for Answer {
    fn text(&self) -> String {
        let word = match self.answer {
            Verdict::Shows => "SHOWS",
            Verdict::Hidden => "HIDDEN",
            Verdict::Open => "OPEN",
        };
        let mut text = tool_text(&self.tool);
        text += &format!("{word}. {}\n\n", self.verdict);
        let header = ["ahead, m", "lower, N/m", "upper, N/m", "ratio lower", "ratio upper", "gap, %"];
        let mut rows = vec![header.map(str::to_owned).to_vec()];
        rows.push(vec![
            "no body".into(),
            number(self.without_lower_n_per_m),
            number(self.without_upper_n_per_m),
            "1".into(),
            "1".into(),
            "-".into(),
        ]);
        for one in &self.distances {
            let percent = one.gap.map_or_else(|| "-".to_owned(), |gap| format!("{:.2}", 100.0 * gap));
            rows.push(vec![
                number(one.ahead_m),
                number_or_dash(one.lower_n_per_m),
                number_or_dash(one.upper_n_per_m),
                number_or_dash(one.ratio_lower),
                number_or_dash(one.ratio_upper),
                percent,
            ]);
        }
        text += &columns(&rows);
        for one in &self.distances {
            if let Some(problem) = &one.problem {
                text += &format!("at {} m: {problem}\n", number(one.ahead_m));
            }
        }
        text += &format!("all bounds that are told are proven; {:.1} s\n", self.seconds);
        for note in &self.notes {
            text += &format!("note: {note}\n");
        }
        text
    }
}
