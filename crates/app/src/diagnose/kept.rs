//! Tables of simulated campaigns, each in a folder that is named by what it is of, so that none is simulated twice.

use std::path::{Path, PathBuf};

use soilctl_campaign::{Content, Options, Plan};
use soilctl_effects::ModelFile;
use soilctl_jobs::fnv1a;
use soilctl_strokes::{ReadOptions, StrokeTable};

use crate::files::failed;
use crate::{AppError, Watch, process, simulate};

/// Strokes of a simulated campaign.
pub(super) struct Kept {
    pub(super) strokes: StrokeTable,
    /// Their courses.
    pub(super) traces: PathBuf,
}

/// The campaign of a plan, or `only` some of its batches, with the soil and the effects of a model file, as `process` reads its logs: from the
/// folder below `store` that has it, or simulated there. Logs, some 10 MB a stroke, are removed once the table is written. `None` if no stroke
/// has a failure force, or it was stopped; batches that are finished then stay.
pub(super) fn kept(
    plan: &Plan,
    file: &ModelFile,
    seed: u64,
    only: Option<&[usize]>,
    store: &Path,
    (threads, watch): (usize, &dyn Watch),
) -> Result<Option<Kept>, AppError> {
    let text = serde_json::to_string(file)?;
    // Files that the plan names may change under the same name.
    let named = format!("{:?}{:?}", plan.plant().config(), plan.controller());
    let part = only.map_or_else(String::new, |only| format!("\n{only:?}"));
    let of = format!("{}\n{seed}\n{}\n{text}\n{named}{part}", env!("CARGO_PKG_VERSION"), plan.text());
    let folder = store.join(fnv1a(of.as_bytes()));
    let (strokes, traces) = (folder.join("strokes.csv"), folder.join("traces.csv"));
    // Traces are written last.
    if !(strokes.is_file() && traces.is_file()) {
        let name = folder.display().to_string();
        let options = Options { out: &folder, seed, threads, content: Content::Steps, only };
        let made = simulate::campaign(plan, Some((file, name.as_str())), &options, watch)?;
        if !made.complete {
            return Ok(None);
        }
        let processed = process::run(&process::Request::of_folder(&folder, &strokes), watch)?;
        if processed.stopped || processed.strokes.is_empty() {
            return Ok(None);
        }
        remove_logs(&folder)?;
    }
    let strokes = StrokeTable::read(&strokes, ReadOptions { allow_zero_sd: false })?;
    Ok(Some(Kept { strokes, traces }))
}

/// Removes the logs of a folder.
pub(super) fn remove_logs(folder: &Path) -> Result<(), AppError> {
    for entry in std::fs::read_dir(folder).map_err(failed(folder))? {
        let path = entry.map_err(failed(folder))?.path();
        if path.extension().is_some_and(|ending| ending == "mcap") {
            std::fs::remove_file(&path).map_err(failed(&path))?;
        }
    }
    Ok(())
}
