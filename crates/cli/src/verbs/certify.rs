//! `soilctl certify FILE`: proves the bounds of a saved solution anew.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{CertificateError, Solution, prove_lower, prove_upper};
use soilctl_figure::CalloutKind;
use soilctl_limit_analysis::results::Units;

use super::Outcome;
use super::limits::{ResultsAnswer, Show, Shown, Told, bounds_table};
use crate::error::CliError;
use crate::output::{Output, Words};
use crate::text::number_or_dash;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The checker shares no code with the solver and trusts nothing in the file. Exit code 1: a claim \
    is not proven. Bounds are in the units of the file: force per unit width times the structure's velocity."
)]
pub(crate) struct Args {
    /// A solution saved with `soilctl bound --save`
    file: PathBuf,

    #[command(flatten)]
    show: Show,
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
    /// Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
    files: Vec<String>,
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
    args.show.check()?;
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
    let mut answer = CertifyAnswer {
        certified,
        lower,
        upper,
        description: solution.scale.description.clone(),
        files: Vec::new(),
    };
    if args.show.any() {
        let shown = shown(&solution)?;
        let mut results = ResultsAnswer::new(&shown, args.show.write(&shown, output)?)?;
        args.show.report(&shown, &mut results, answer.told()?, output)?;
        answer.files = results.into_files();
    }
    output.answer(&answer)?;
    Ok(if certified { Outcome::Done } else { Outcome::Negative })
}

/// The fields of a solution, in its own coordinates, in metres if it says how long one of its units is.
fn shown(solution: &Solution) -> Result<Shown, CliError> {
    let statement = &solution.statement;
    // What follows tells about units.
    let title = solution.scale.description.as_ref().and_then(|d| d.split(';').next());
    let known = solution.scale.length_m.zip(solution.scale.unit_weight_n_per_m3);
    let (length, stress, names) =
        known.map_or((1.0, 1.0, ["L", "γL"]), |(l, w)| (l, 1e-3 * l * w, ["m", "kPa"]));
    let [length_name, stress_name] = names.map(str::to_owned);
    let units = Units { origin: [0.0; 2], length, length_name, stress, stress_name };
    Shown::new(
        solution.upper.as_ref().map(|c| (statement, &c.field)),
        solution.lower.as_ref().map(|c| (statement, &c.field)),
        units,
        title.unwrap_or_default().to_owned(),
    )
}

impl CertifyAnswer {
    /// What the page tells.
    fn told(&self) -> Result<Told, CliError> {
        let mut bounds = bounds_table();
        let row = |of: fn(&Checked) -> Option<f64>| {
            [&self.lower, &self.upper].map(|c| number_or_dash(c.as_ref().and_then(of)))
        };
        let ([lower, upper], [claimed_lower, claimed_upper]) = (row(|c| c.proven), row(|c| Some(c.claimed)));
        bounds.row(["Proven".to_owned(), lower, upper])?;
        bounds.row(["Claimed".to_owned(), claimed_lower, claimed_upper])?;
        let verdict = if self.certified {
            (
                CalloutKind::Good,
                "Every claim is proven",
                "Each field was read from the file and checked anew with interval arithmetic.".to_owned(),
            )
        } else {
            let lines = [("lower bound", &self.lower), ("upper bound", &self.upper)]
                .map(|(name, c)| c.as_ref().filter(|c| !c.confirmed).map(|c| c.line(name).trim().to_owned()));
            (
                CalloutKind::Bad,
                "Not every claim is proven",
                lines.into_iter().flatten().collect::<Vec<_>>().join("; "),
            )
        };
        Ok(Told {
            kind: "Saved solution",
            subtitle: self.description.clone().unwrap_or_default(),
            verdict: (verdict.0, verdict.1.to_owned(), verdict.2),
            bounds,
            given: Vec::new(),
            steps: None,
        })
    }
}

impl soilctl_app::Answer for CertifyAnswer {
    const SCHEMA: &'static str = "soilctl.certify/1";
}

impl Words for CertifyAnswer {
    fn text(&self) -> String {
        let mut text = self.description.as_ref().map_or_else(String::new, |d| format!("{d}\n"));
        for (name, checked) in [("lower", &self.lower), ("upper", &self.upper)] {
            text += &checked.as_ref().map_or_else(String::new, |c| c.line(name));
        }
        for file in &self.files {
            text += &format!("written: {file}\n");
        }
        text
    }
}
