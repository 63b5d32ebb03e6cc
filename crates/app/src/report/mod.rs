//! The estimate with what a report tells beside it: an error budget, and direct shear at the stresses of the strokes.

mod budget;
mod shear;

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use budget::{ErrorBudget, ErrorSource};
pub use shear::{ShearComparison, ShearRange};

use crate::estimate::{self, Estimation};
use crate::{AppError, Outcome, TableSource, Watch};

/// One page with the estimate, its figures and what they mean.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub estimate: estimate::Request,

    /// Page to write
    #[arg(long, value_name = "FILE", default_value_os_t = Request::default().out)]
    pub out: PathBuf,

    /// Title of the page; default: the name of the folder or file of the strokes
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,

    /// Direct-shear results to compare with (CSV: soil, normal_stress_psi or normal_stress_pa, friction_angle_deg)
    #[arg(long, value_name = "FILE")]
    pub shear: Option<PathBuf>,

    /// Which soil of --shear; needed if it holds several
    #[arg(long, value_name = "NAME", requires = "shear")]
    pub soil: Option<String>,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            estimate: estimate::Request::default(),
            out: "report.html".into(),
            title: None,
            shear: None,
            soil: None,
        }
    }
}

/// What `report` answers.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The page.
    pub report: String,
    /// The estimate on it.
    #[serde(flatten)]
    pub estimate: estimate::Answer,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.report/1";

    fn outcome(&self) -> Outcome {
        self.estimate.outcome()
    }
}

/// Everything that the page tells.
pub struct Report {
    /// Title of the page.
    pub title: String,
    /// The estimate.
    pub estimation: Estimation,
    /// What each source of error does to a force.
    pub budget: ErrorBudget,
    /// Direct shear beside the estimate, if it was asked for and a soil is consistent.
    pub shear: Option<ShearComparison>,
    /// Whether direct shear was asked for.
    pub asked_for_shear: bool,
}

impl Report {
    /// The answer, once the page is written.
    #[must_use]
    pub fn into_answer(self, page: &Path) -> Answer {
        Answer { report: page.display().to_string(), estimate: self.estimation.answer }
    }
}

/// Estimates and compares; the page is drawn from the result.
///
/// # Errors
/// [`AppError`] as for an estimate, or if the direct-shear table makes no sense.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Report, AppError> {
    if request.estimate.exact {
        return Err(AppError::Request(
            "a report has bands, so --exact has no meaning for it; use estimate".into(),
        ));
    }
    if request.estimate.intervals.any() {
        return Err(AppError::Request(
            "a report takes cohesion, adhesion, surcharge and slope as known; give each of them as one number, or use estimate".into(),
        ));
    }
    let estimation = estimate::run(&request.estimate, watch)?;
    let shear = match &request.shear {
        Some(file) => shear::compare(file, request.soil.as_ref(), &estimation)?,
        None => None,
    };
    Ok(Report {
        title: request.title.clone().unwrap_or_else(|| name_of(&request.estimate.file)),
        budget: ErrorBudget::of(&estimation),
        shear,
        asked_for_shear: request.shear.is_some(),
        estimation,
    })
}

/// Name of the data set: its folder if the file is called like every stroke table, else the file.
fn name_of(table: &TableSource) -> String {
    let Some(file) = table.path() else { return table.name() };
    let stem = file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let folder = file.parent().and_then(|p| p.file_name()).map(|s| s.to_string_lossy().into_owned());
    match folder {
        Some(folder) if stem == "strokes" => folder,
        _ => stem,
    }
}
