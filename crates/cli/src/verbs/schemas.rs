//! `soilctl schemas DIR`: the JSON schemas of all answers, for the reference documentation.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Value, json};
use soilctl_campaign::file::{PLAN_SCHEMA, PlanFile};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::PROBLEM_SCHEMA;

use super::{
    Outcome, arm, bound, certify, demo, diagnose, estimate, log, monitor, predict, process, replay, report,
    run as run_verb, shear, simulate, solve, table, view,
};
use crate::error::CliError;
use crate::output::{Answer, Document};

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Folder to write to; made if it is not there
    dir: PathBuf,
}

pub(crate) fn run(args: &Args) -> Result<Outcome, CliError> {
    std::fs::create_dir_all(&args.dir)
        .map_err(|problem| CliError::File { path: args.dir.display().to_string(), problem })?;
    write::<predict::Prediction>(&args.dir)?;
    write::<bound::BoundAnswer>(&args.dir)?;
    write::<solve::SolveAnswer>(&args.dir)?;
    write::<solve::CheckAnswer>(&args.dir)?;
    write::<certify::CertifyAnswer>(&args.dir)?;
    write::<estimate::EstimateAnswer>(&args.dir)?;
    write::<diagnose::DiagnosisAnswer>(&args.dir)?;
    write::<diagnose::SelfTestAnswer>(&args.dir)?;
    write::<report::ReportAnswer>(&args.dir)?;
    write::<shear::ShearAnswer>(&args.dir)?;
    write::<simulate::SimulateAnswer>(&args.dir)?;
    write::<demo::DemoAnswer>(&args.dir)?;
    write::<table::TableAnswer>(&args.dir)?;
    write::<log::LogAnswer>(&args.dir)?;
    write::<process::ProcessAnswer>(&args.dir)?;
    write::<replay::ReplayAnswer>(&args.dir)?;
    write_file::<Description>(&args.dir, PROBLEM_SCHEMA)?;
    write_file::<PlanFile>(&args.dir, PLAN_SCHEMA)?;
    write::<run_verb::RunAnswer>(&args.dir)?;
    write::<monitor::MonitorAnswer>(&args.dir)?;
    write::<view::ViewAnswer>(&args.dir)?;
    write::<arm::SkewingAnswer>(&args.dir)?;
    write::<arm::UrdfAnswer>(&args.dir)?;
    Ok(Outcome::Done)
}

fn write<A: Answer + JsonSchema + 'static>(dir: &Path) -> Result<(), CliError> {
    let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let mut schema = serde_json::to_value(generator.into_root_schema_for::<Document<'static, A>>())?;
    if let Some(keys) = schema.as_object_mut() {
        keys.insert("title".into(), Value::from(A::SCHEMA));
    }
    if let Some(id) = schema.pointer_mut("/properties/schema") {
        *id = json!({"description": "Id of this schema.", "const": A::SCHEMA});
    }
    save(dir, A::SCHEMA, &schema)
}

/// The schema of files that a verb reads.
fn write_file<F: JsonSchema>(dir: &Path, id: &str) -> Result<(), CliError> {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let mut schema = serde_json::to_value(generator.into_root_schema_for::<F>())?;
    if let Some(keys) = schema.as_object_mut() {
        keys.insert("title".into(), Value::from(id));
    }
    save(dir, id, &schema)
}

fn save(dir: &Path, id: &str, schema: &Value) -> Result<(), CliError> {
    let path = dir.join(id.replace('/', ".") + ".json");
    let text = serde_json::to_string_pretty(schema)? + "\n";
    process::save(&path, text.as_bytes())
}
