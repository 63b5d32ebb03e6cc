//! `soilctl design FILE`: the least of something that is enough.

use soilctl_app::design::{self, Answer, Request, Verdict};
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Each value is decided by proof: it is enough if the lower bound of all cases of the file reaches --wanted, and not enough if the \
    upper bound of one does not. Values between two that were tried are not proven. Examples: soilctl design cut.toml --parameter member.nail.tensile_kn_per_m --from 0 --to 80 --wanted 1.3; \
    soilctl design flat.toml steep.toml --wanted 1.25. Exit codes: 0 found, 1 no end is enough, 3 the bounds leave more open than --within. \
    Docs: docs/problem-file.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = design::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = self.title.as_ref().map_or_else(String::new, |t| format!("{t}\n"));
        text += &format!("{}\n", self.quantity.words());
        text += &format!("{}\n\n", self.verdict);
        let head = self.parameter.clone().unwrap_or_else(|| "part of the way".into());
        let has_cases = self.tried.iter().any(|one| one.case.is_some());
        let mut header = vec![head, "lower".into(), "upper".into(), "enough".into()];
        header.extend(has_cases.then(|| "case".to_owned()));
        let mut rows = vec![header];
        for one in &self.tried {
            let enough = match one.verdict {
                Verdict::Enough => "yes",
                Verdict::NotEnough => "no",
                Verdict::Open => "?",
            };
            let mut row = vec![
                number(one.value),
                number_or_dash(one.lower),
                number_or_dash(one.upper),
                enough.to_owned(),
            ];
            row.extend(has_cases.then(|| one.case.clone().unwrap_or_default()));
            rows.push(row);
        }
        text += &columns(&rows);
        for one in &self.tried {
            if let Some(why) = &one.why {
                text += &format!("at {}: {why}\n", number(one.value));
            }
        }
        text + &format!("bounds that are told are proven; {:.1} s\n", self.seconds)
    }
}
