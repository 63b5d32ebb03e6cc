//! `soilctl stability REGION PROBLEM`: whether a problem stands for every soil that explains the strokes, or that was published.

use soilctl_app::stability::{self, Answer, Request, Trial, Verdict};
use soilctl_app::text::{columns, number};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    // Another one than that of single bounds; it is the one of requests, as a test says.
    mut_arg("max_gap", |gap| gap.default_value("0.03")),
    after_help = "REGION is what `soilctl estimate STROKES --friction-law --format json` or `soilctl soils NAME --format json` prints, PROBLEM a problem \
    file (docs/problem-file.md) that asks for strength-reduction, load, unit-weight or structure. The friction of the chosen soil is that of the strokes at the stresses \
    of the problem, its weight that of the strokes under --gravity; of a published soil cohesion too. Exit codes: 0 it stands for every such soil, 1 it fails for each, 3 it depends. Docs: docs/stability.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = stability::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = self.title.as_ref().map_or_else(String::new, |t| format!("{t}\n"));
        let word = match self.answer {
            Verdict::Stands => "STANDS",
            Verdict::Fails => "FAILS",
            Verdict::Depends => "DEPENDS",
        };
        text += &format!("{word}. {}\n\n", self.verdict);
        let mut rows = vec![["phi (deg)", "lower", "upper"].map(String::from).to_vec()];
        let cell = |bound: Option<f64>| bound.map_or_else(|| "-".to_owned(), number);
        for Trial { phi_deg, lower, upper } in &self.trials {
            rows.push(vec![format!("{phi_deg:.2}"), cell(*lower), cell(*upper)]);
        }
        text += &columns(&rows);
        let [low, high] = self.density_kg_m3;
        text += &format!(
            "bounds hold for all densities from {low:.0} to {high:.0} kg/m3; each is proven; {:.1} s\n",
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
        let command = Args::augment_args(Command::new("stability"));
        let words = ["stability", "region.json", "problem.toml"];
        let args = Args::from_arg_matches(&command.get_matches_from(words)).unwrap();
        assert_eq!(args.request.budget.max_gap, Request::default().budget.max_gap);
    }
}
