//! `soilctl certify FILE`: proves the bounds of a saved solution anew.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{CertificateError, Solution, prove_lower, prove_upper};

use super::Outcome;
use crate::error::CliError;
use crate::output::{Answer, Output};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The checker shares no code with the solver and trusts nothing in the file. Exit code 1: a claim \
    is not proven. Bounds are in the units of the file: force per unit width times the structure's velocity."
)]
pub(crate) struct Args {
    /// A solution saved with `soilctl bound --save`
    file: PathBuf,
}

/// What a saved solution proves.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct CertifyAnswer {
    /// Whether every claim in the file is proven.
    certified: bool,
    /// The lower bound; null if the file has none.
    lower: Option<Checked>,
    /// The upper bound; null if the file has none.
    upper: Option<Checked>,
    /// What the problem is, in the words of the file.
    description: Option<String>,
}

/// One bound.
#[derive(Debug, Serialize, JsonSchema)]
struct Checked {
    /// What the file claims.
    claimed: f64,
    /// What is proven, whatever is claimed; null if the field proves nothing.
    proven: Option<f64>,
    /// Whether the proof reaches the claim.
    confirmed: bool,
    /// Why the field proves nothing; null if it does.
    refusal: Option<String>,
}

impl Checked {
    fn new(claimed: f64, proof: Result<f64, CertificateError>, reaches: impl Fn(f64) -> bool) -> Self {
        match proof {
            Ok(proven) => Self { claimed, proven: Some(proven), confirmed: reaches(proven), refusal: None },
            Err(why) => Self { claimed, proven: None, confirmed: false, refusal: Some(why.to_string()) },
        }
    }

    fn line(&self, name: &str) -> String {
        let claimed = self.claimed;
        match (self.proven, &self.refusal) {
            (Some(proven), _) if self.confirmed => format!("{name}  {proven}  proven (claimed {claimed})\n"),
            (Some(proven), _) => {
                format!("{name}  {proven}  proven, but {claimed} is claimed: not confirmed\n")
            }
            (None, Some(why)) => format!("{name}  refused, {claimed} is not proven: {why}\n"),
            (None, None) => String::new(),
        }
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let solution = Solution::read(&args.file)?;
    let statement = &solution.statement;
    let lower = solution
        .lower
        .as_ref()
        .map(|c| Checked::new(c.claimed, prove_lower(statement, &c.field), |proven| c.claimed <= proven));
    let upper = solution
        .upper
        .as_ref()
        .map(|c| Checked::new(c.claimed, prove_upper(statement, &c.field), |proven| c.claimed >= proven));
    if lower.is_none() && upper.is_none() {
        return Err(CliError::Usage(format!(
            "{} has neither a lower nor an upper bound; save one with `soilctl bound --save FILE`",
            args.file.display()
        )));
    }
    let certified = [&lower, &upper].into_iter().flatten().all(|c| c.confirmed);
    let answer = CertifyAnswer { certified, lower, upper, description: solution.scale.description };
    output.answer(&answer)?;
    Ok(if certified { Outcome::Done } else { Outcome::Negative })
}

impl Answer for CertifyAnswer {
    const SCHEMA: &'static str = "soilctl.certify/1";

    fn text(&self) -> String {
        let mut text = self.description.as_ref().map_or_else(String::new, |d| format!("{d}\n"));
        for (name, checked) in [("lower", &self.lower), ("upper", &self.upper)] {
            text += &checked.as_ref().map_or_else(String::new, |c| c.line(name));
        }
        text
    }
}
