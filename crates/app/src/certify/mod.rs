//! Proves the bounds of a saved solution anew.

mod words;

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_certificate::Solution;
use soilctl_limit_analysis::results::Units;

pub use words::Said;

use crate::limits::Fields;
use crate::{AppError, Outcome, Watch};

/// Proves the bounds of a saved solution anew.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// A solution saved with `soilctl bound --save`
    pub file: PathBuf,
}

/// What a saved solution proves.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Whether every claim in the file is proven.
    pub certified: bool,
    /// The lower bound; null if the file has none.
    pub lower: Option<Checked>,
    /// The upper bound; null if the file has none.
    pub upper: Option<Checked>,
    /// Width of the structure in the units of the file, where its ends are part of the problem; null in plane strain.
    pub width: Option<f64>,
    /// What the bounds are of, read from the statement that was proven.
    pub statement: Vec<Said>,
    /// What the file calls the problem, which nothing proves.
    pub description: Option<String>,
    /// Files written for --plot, --vtu, --mesh, --report and --figures, named as they were given.
    pub files: Vec<String>,
}

/// One bound.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Checked {
    /// What the file claims.
    pub claimed: f64,
    /// What is proven, whatever is claimed; null if the field proves nothing.
    pub proven: Option<f64>,
    /// Whether the proof reaches the claim.
    pub confirmed: bool,
    /// Why the field proves nothing; null if it does.
    pub refusal: Option<String>,
}

impl Checked {
    fn new(found: soilctl_certificate::Checked, reaches: impl Fn(f64, f64) -> bool) -> Self {
        let claimed = found.claimed;
        match found.proven {
            Ok(proven) => {
                Self { claimed, proven: Some(proven), confirmed: reaches(claimed, proven), refusal: None }
            }
            Err(why) => Self { claimed, proven: None, confirmed: false, refusal: Some(why.to_string()) },
        }
    }

    /// The bound in a line that starts with its name.
    #[must_use]
    pub fn line(&self, name: &str) -> String {
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

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.certify/1";

    fn outcome(&self) -> Outcome {
        if self.certified { Outcome::Done } else { Outcome::Negative }
    }
}

/// The answer, and the solution.
#[derive(Debug)]
pub struct Certified {
    /// The answer.
    pub answer: Answer,
    solution: Solution,
}

/// Proves what the solution claims.
///
/// # Errors
/// [`AppError`] if the file cannot be read or claims nothing, or if the checker proves bounds that exclude each other, which is a
/// fault of its own. A claim that is not proven is an answer.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Certified, AppError> {
    of(Solution::read(&request.file)?, &request.file)
}

/// Proves what a solution claims that was read from `name`.
///
/// # Errors
/// As those of [`run`].
pub fn of(solution: Solution, name: &Path) -> Result<Certified, AppError> {
    let (lower, upper) = soilctl_certificate::check(&solution)?;
    let lower = lower.map(|c| Checked::new(c, |claimed, proven| claimed <= proven));
    let upper = upper.map(|c| Checked::new(c, |claimed, proven| claimed >= proven));
    if lower.is_none() && upper.is_none() {
        return Err(AppError::Request(format!(
            "{} has neither a lower nor an upper bound; save one with `soilctl bound --save FILE`",
            name.display()
        )));
    }
    let certified = [&lower, &upper].into_iter().flatten().all(|c| c.confirmed);
    let description = solution.scale.description.clone();
    let width = solution.statement.width;
    let statement = words::words(&solution.statement, &solution.scale);
    let answer = Answer { certified, lower, upper, width, statement, description, files: Vec::new() };
    Ok(Certified { answer, solution })
}

impl Certified {
    /// The fields of the solution, in its own coordinates, in metres if it says how long one of its units is.
    ///
    /// # Errors
    /// [`AppError`] if a field makes no sense.
    pub fn fields(&self) -> Result<Fields, AppError> {
        let (statement, scale) = (&self.solution.statement, &self.solution.scale);
        // What follows tells about units.
        let title = scale.description.as_ref().and_then(|d| d.split(';').next());
        let known = scale.length_m.zip(scale.unit_weight_n_per_m3);
        let (length, stress, names) =
            known.map_or((1.0, 1.0, ["L", "γL"]), |(l, w)| (l, 1e-3 * l * w, ["m", "kPa"]));
        let [length_name, stress_name] = names.map(str::to_owned);
        let units = Units { origin: [0.0; 2], length, length_name, stress, stress_name };
        let fields = Fields::new(
            self.solution.upper.as_ref().map(|c| (statement, &c.field)),
            self.solution.lower.as_ref().map(|c| (statement, &c.field)),
            units,
            title.map_or_else(String::new, |title| format!("“{title}”")),
        )?;
        let fields = match &self.solution.mechanism {
            Some(claim) => fields.with_blocks(statement, &claim.field)?,
            None => fields,
        };
        match &self.solution.space {
            Some(claim) => fields.with_end(statement, &claim.field),
            None => Ok(fields),
        }
    }
}
