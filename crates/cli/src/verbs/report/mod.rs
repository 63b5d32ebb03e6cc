//! `soilctl report`: one HTML page with the estimate, its figures and what they mean.

mod budget;
mod curves;
mod page;
mod shear;

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use super::Outcome;
use super::estimate::args::EstimateArgs;
use super::estimate::{EstimateAnswer, work};
use super::pages::{self, FigureFiles};
use crate::error::CliError;
use crate::output::{Answer, Output};

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(flatten)]
    estimate: EstimateArgs,

    /// Page to write
    #[arg(long, value_name = "FILE", default_value = "report.html")]
    out: PathBuf,

    #[command(flatten)]
    figures: FigureFiles,

    /// Title of the page; default: the name of the folder or file of the strokes
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,

    /// Direct-shear results to compare with (CSV: soil, normal_stress_psi or normal_stress_pa, friction_angle_deg)
    #[arg(long, value_name = "FILE")]
    shear: Option<PathBuf>,

    /// Which soil of --shear; needed if it holds several
    #[arg(long, value_name = "NAME", requires = "shear")]
    soil: Option<String>,

    /// Opens the page in the browser
    #[arg(long)]
    open: bool,
}

/// What `report` answers.
#[derive(Serialize, JsonSchema)]
pub(crate) struct ReportAnswer {
    /// The page.
    report: String,
    /// The estimate on it.
    #[serde(flatten)]
    estimate: EstimateAnswer,
}

impl Answer for ReportAnswer {
    const SCHEMA: &'static str = "soilctl.report/1";

    fn text(&self) -> String {
        format!("{}\nreport: {}\n", self.estimate.text(), self.report)
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let work = work::run(&args.estimate, false)?;
    let title = args.title.clone().unwrap_or_else(|| name_of(&args.estimate.file));
    let mut page = page::render(args, &title, &work)?;
    pages::write(&mut page, Some(&args.out), &args.figures, output)?;
    if args.open
        && let Err(problem) = open::that_detached(&args.out)
    {
        output
            .note(&format!("the page could not be opened ({problem}); open {} yourself", args.out.display()));
    }
    let consistent = work.answer.consistent;
    output.answer(&ReportAnswer { report: args.out.display().to_string(), estimate: work.answer })?;
    Ok(if consistent { Outcome::Done } else { Outcome::Negative })
}

/// Name of the data set: its folder if the file is called like every stroke table, else the file.
fn name_of(file: &std::path::Path) -> String {
    let stem = file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let folder = file.parent().and_then(|p| p.file_name()).map(|s| s.to_string_lossy().into_owned());
    match folder {
        Some(folder) if stem == "strokes" => folder,
        _ => stem,
    }
}
