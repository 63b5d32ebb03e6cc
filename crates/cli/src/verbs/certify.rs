//! `soilctl certify FILE`: proves the bounds of a saved solution anew.

use soilctl_app::certify::{self, Answer, Request};
use soilctl_app::{Answer as _, Outcome};

use super::limits::{Show, Written};
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The checker shares no code with the solver and trusts nothing in the file. Exit code 1: a claim \
    is not proven. Bounds are in the units of the file: force per unit width times the structure's velocity."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    show: Show,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    args.show.check()?;
    let mut found = certify::run(&args.request, output)?;
    let mut written = Written::default();
    if args.show.any() {
        written = match found.fields() {
            Ok(fields) => args.show.write(&fields, || soilctl_pages::certify::page(&found, &fields), output),
            // What is refused may be nothing that can be drawn; the refusals are the answer all the same.
            Err(problem) => written.with_solution(Some(problem)),
        };
        found.answer.files = std::mem::take(&mut written.files);
    }
    output.answer(&found.answer)?;
    written.end(found.answer.outcome(), output)
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = String::new();
        for (name, checked) in [("lower", &self.lower), ("upper", &self.upper)] {
            text += &checked.as_ref().map_or_else(String::new, |c| c.line(name));
        }
        let proven = [&self.lower, &self.upper].into_iter().flatten().all(|c| c.proven.is_some());
        text += if proven {
            "\nthey are bounds of this, as it was proven:\n"
        } else {
            "\nthe file states this:\n"
        };
        for said in &self.statement {
            text += &format!("  {:<8} {}\n", said.of, said.says);
        }
        if let Some(title) = &self.description {
            text += &format!("\nthe file calls it, which nothing proves: {title:?}\n");
        }
        for file in &self.files {
            text += &format!("written: {file}\n");
        }
        text
    }
}
