//! The follow-up as a plan that the simulated arm and the real one run.

use std::path::Path;

use soilctl_campaign::Plan;
use soilctl_campaign::file::{Batch, Stroke};
use soilctl_diagnosis::NextExperiment;
use soilctl_strokes::StrokeRow;

use crate::AppError;
use crate::files::save;

/// Name of the plan.
const NAME: &str = "next_experiment.toml";

/// What became of the plan of a follow-up.
#[derive(Debug, Default)]
pub(super) struct FollowUp {
    /// Where it is.
    pub(super) plan: Option<String>,
    /// Why there is none, where there could have been one.
    pub(super) refused: Option<String>,
}

/// Writes the plan of the campaign with the strokes of its follow-up after those that it has. `logs` is the folder from which the plan's
/// files are looked for.
pub(super) fn write(
    plan: &Plan,
    logs: &Path,
    next: &NextExperiment,
    out: &Path,
) -> Result<FollowUp, AppError> {
    let refused = |why: String| FollowUp { plan: None, refused: Some(why) };
    if !next.by_plan {
        return Ok(refused(
            "a plan says neither another plate, nor speeds, nor where the box stands".to_owned(),
        ));
    }
    let Some(batches) = batches(&next.rows) else {
        return Ok(refused("strokes of the follow-up lack a radius, a base angle or a set-point".to_owned()));
    };
    let text = match plan.with_further(&batches, logs) {
        Ok(text) => text,
        Err(problem) => return Ok(refused(problem.to_string())),
    };
    let made = plan.batches();
    let path = out.join(NAME);
    let head = format!(
        "# {}\n# Batches 1 to {made} are those of the campaign; the follow-up is from batch {} on. The simulated arm makes the first ones again,\n\
         # bit for bit, under the same seed. Files that the plan names are looked for beside it.\n\n",
        next.text,
        made + 1
    );
    save(&path, (head + &text).as_bytes())?;
    Ok(FollowUp { plan: Some(path.display().to_string()), refused: None })
}

/// Strokes by batch; `None` if one lacks what a plan says of each.
fn batches(rows: &[StrokeRow]) -> Option<Vec<Batch>> {
    rows.chunk_by(|a, b| a.batch == b.batch)
        .map(|rows| {
            let strokes = rows.iter().map(stroke).collect::<Option<_>>()?;
            Some(Batch { radius_m: None, strokes })
        })
        .collect()
}

fn stroke(row: &StrokeRow) -> Option<Stroke> {
    Some(Stroke {
        radius_m: Some(row.radius_m?),
        base_deg: row.base_deg?,
        alpha_deg: row.alpha_deg,
        depth_m: row.depth_m,
        delta_set_deg: row.delta_set_deg?,
    })
}
