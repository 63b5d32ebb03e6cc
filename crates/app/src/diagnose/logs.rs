//! Whether a campaign can be run again on the simulated arm: are its logs there, and are they ours?

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_campaign::Plan;
use soilctl_diagnosis::Data;

use super::Request;
use crate::AppError;
use crate::files::failed;

/// Whether signals were compared with those of the same commands on the simulated arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Resimulation {
    /// They were.
    Compared,
    /// There is no log beside the table.
    NoLogs,
    /// The request wants the table alone.
    NotWanted,
    /// The logs cannot be simulated again, or no simulated stroke failed the soil.
    NotPossible,
    /// The user ended the work before it was done; the same command goes on from there.
    Stopped,
}

/// What request and folder say.
pub(super) enum Asked {
    /// The campaign is run again: its plan and seed.
    Again(Box<Plan>, u64),
    /// It is not, with a reason where it could have been expected.
    Not(Resimulation, Option<String>),
}

/// Finds out what is asked for. Logs that are named must do; those that happen to be beside the table need not.
pub(super) fn asked(request: &Request, data: &Data) -> Result<Asked, AppError> {
    if request.no_resimulate {
        return Ok(Asked::Not(Resimulation::NotWanted, None));
    }
    let folder = request.logs.as_ref().unwrap_or(&request.dir);
    let logs = logs_of(folder)?;
    match (logs.first(), &request.logs) {
        (Some(first), None) => Ok(match plan(first, &logs, data) {
            Ok((plan, seed)) => Asked::Again(Box::new(plan), seed),
            Err(problem) => Asked::Not(Resimulation::NotPossible, Some(problem.to_string())),
        }),
        (Some(first), Some(_)) => {
            let (plan, seed) = plan(first, &logs, data)?;
            Ok(Asked::Again(Box::new(plan), seed))
        }
        (None, None) => Ok(Asked::Not(Resimulation::NoLogs, None)),
        (None, Some(_)) => Err(AppError::Request(format!(
            "there is no .mcap file in {}; give the folder of the campaign's logs with --logs, or --no-resimulate",
            folder.display()
        ))),
    }
}

/// The plan of the logs, if the table is made of them: `process` names strokes after their logs.
fn plan(first: &Path, logs: &[PathBuf], data: &Data) -> Result<(Plan, u64), AppError> {
    let found = Plan::from_log(first)?;
    let names: Vec<String> =
        logs.iter().filter_map(|log| Some(format!("{}-", log.file_stem()?.to_string_lossy()))).collect();
    let of_these = |id: &String| names.iter().any(|name| id.starts_with(name));
    if data.rows.iter().filter_map(|row| row.stroke_id.as_ref()).any(of_these) {
        return Ok(found);
    }
    Err(AppError::Request(format!(
        "no stroke of the table is named after a log in {}, as `soilctl process` names them: these are not the logs of its strokes",
        first.parent().unwrap_or(Path::new("")).display()
    )))
}

/// Logs of a folder, by name.
fn logs_of(folder: &Path) -> Result<Vec<PathBuf>, AppError> {
    let mut logs = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed(folder))? {
        let path = entry.map_err(failed(folder))?.path();
        if path.extension().is_some_and(|ending| ending == "mcap") {
            logs.push(path);
        }
    }
    logs.sort();
    Ok(logs)
}
