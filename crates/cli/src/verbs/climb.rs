//! `soilctl climb REGION`: slopes that a wheel climbs on every soil that explains the strokes, or that was published.

use soilctl_app::stability::climb::{self, Answer, Request, Trial};
use soilctl_app::text::{columns, number};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    // Another one than that of single bounds; it is the one of requests, as a test says.
    mut_arg("max_gap", |gap| gap.default_value("0.1")),
    after_help = "REGION is what `soilctl estimate STROKES --format json` or `soilctl soils NAME --format json` prints. The wheel is a rigid strip on \
    the slope, as wide as the wheel is long in contact, whose load leans by the slope; what the ground bears is proven. Exit codes: 0 it climbs, 1 the ground gives way, \
    3 it depends, or the bounds are too far apart. Docs: docs/how/rover.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = climb::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.verdict);
        let mut rows = vec![["slope (deg)", "bears at least", "at most"].map(String::from).to_vec()];
        let cell = |bound: Option<f64>| {
            bound.map_or_else(|| "-".to_owned(), |times| format!("{} times", number(times)))
        };
        for Trial { slope_deg, lower, upper } in &self.trials {
            rows.push(vec![format!("{slope_deg:.2}"), cell(*lower), cell(*upper)]);
        }
        text += &columns(&rows);
        let [low, high] = self.density_kg_m3;
        text += &format!(
            "of its load, for all densities from {low:.0} to {high:.0} kg/m3; each is proven; {:.1} s\n",
            self.seconds
        );
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use clap::{Args as _, Command, FromArgMatches as _};

    use super::*;

    #[test]
    fn the_gap_is_that_of_requests() {
        let command = Args::augment_args(Command::new("climb"));
        let words =
            ["climb", "region.json", "--wheel-load", "1", "--contact-length", "1", "--wheel-width", "1"];
        let args = Args::from_arg_matches(&command.get_matches_from(words)).unwrap();
        assert_eq!(args.request.budget.max_gap, Request::default().budget.max_gap);
    }
}
