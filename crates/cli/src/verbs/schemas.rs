//! `soilctl schemas DIR`: the JSON schemas of all requests and answers, for the reference documentation.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::Value;
use soilctl_app::tool::{TOOL_SCHEMA, ToolFile};
use soilctl_app::{Answer, Outcome, USE_CASES, log, report};
use soilctl_campaign::file::{PLAN_SCHEMA, PlanFile};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::PROBLEM_SCHEMA;

use super::{dig, monitor, run as run_verb, view, workbench};
use crate::error::CliError;

#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Folder to write to; made if it is not there
    dir: PathBuf,
}

pub(crate) fn run(args: &Args) -> Result<Outcome, CliError> {
    std::fs::create_dir_all(&args.dir)
        .map_err(|problem| CliError::File { path: args.dir.display().to_string(), problem })?;
    for case in USE_CASES {
        save(&args.dir, case.answer_id, &case.answer()?)?;
        let id = format!("soilctl.{}-request/1", case.name.replace(' ', "-"));
        save(&args.dir, &id, &titled(case.request()?, &id))?;
    }
    write::<report::Answer>(&args.dir)?;
    write::<log::Answer>(&args.dir)?;
    write_file::<Description>(&args.dir, PROBLEM_SCHEMA)?;
    write_file::<ToolFile>(&args.dir, TOOL_SCHEMA)?;
    write_file::<PlanFile>(&args.dir, PLAN_SCHEMA)?;
    write::<run_verb::RunAnswer>(&args.dir)?;
    write::<dig::DigAnswer>(&args.dir)?;
    write::<monitor::MonitorAnswer>(&args.dir)?;
    write::<workbench::WorkbenchAnswer>(&args.dir)?;
    write::<view::ViewAnswer>(&args.dir)?;
    Ok(Outcome::Done)
}

fn write<A: Answer + 'static>(dir: &Path) -> Result<(), CliError> {
    save(dir, A::SCHEMA, &soilctl_app::schema::<A>()?)
}

/// The schema of files that a verb reads.
fn write_file<F: JsonSchema>(dir: &Path, id: &str) -> Result<(), CliError> {
    let generator = SchemaSettings::draft2020_12().into_generator();
    let schema = serde_json::to_value(generator.into_root_schema_for::<F>())?;
    save(dir, id, &titled(schema, id))
}

/// A schema with its id as the title.
fn titled(mut schema: Value, id: &str) -> Value {
    if let Some(keys) = schema.as_object_mut() {
        keys.insert("title".into(), Value::from(id));
    }
    schema
}

fn save(dir: &Path, id: &str, schema: &Value) -> Result<(), CliError> {
    let path = dir.join(id.replace('/', ".") + ".json");
    let text = serde_json::to_string_pretty(schema)? + "\n";
    Ok(soilctl_app::files::save(&path, text.as_bytes())?)
}
