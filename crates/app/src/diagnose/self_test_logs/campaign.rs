//! One hidden campaign: simulated on an arm that the twin does not know, processed, and diagnosed with the twin.

use std::path::Path;
use std::sync::atomic::Ordering;

use soilctl_campaign::{Content, Options, Plan};
use soilctl_strokes::Campaign;

use super::counts::Entry;
use super::hidden::{Case, PHI_SD_DEG};
use crate::diagnose::learn::remove_logs;
use crate::diagnose::{Request, without_page};
use crate::files::{failed, save};
use crate::machine::cores;
use crate::{AppError, Interrupted, Watch, process, simulate};

/// Folder of what the twin keeps between campaigns, beside theirs.
const TWIN: &str = "twin";

/// Makes and diagnoses a campaign in a folder of its own within `folder`, of which only tables are left; `None` if it was stopped, and
/// then the next run goes on from there.
pub(super) fn run(
    folder: &Path,
    case: &Case,
    model: &str,
    watch: &dyn Watch,
) -> Result<Option<Entry>, AppError> {
    let stop = watch.stop(Interrupted::KeepsResults);
    let own = folder.join(format!("{:04}_{}", case.number, case.named()));
    let logs = own.join("logs");
    std::fs::create_dir_all(&logs).map_err(failed(&logs))?;
    save(&own.join("plant.toml"), case.plant.as_bytes())?;
    // Whoever simulates the logs again finds the twin's plant beside them.
    save(&logs.join("plant.toml"), soilctl_campaign::default_plant()?.as_bytes())?;
    let strokes = logs.join("strokes.csv");
    let plan = Plan::from_toml(&case.plan, "the plan of a hidden campaign", &own)?;
    let options = Options { out: &logs, seed: case.seed, threads: cores(), content: Content::Steps };
    let made = simulate::campaign(&plan, Some((&case.truth, "what is hidden")), &options, watch)?;
    if !made.complete {
        return Ok(None);
    }
    let processed = process::run(&process::Request::of_folder(&logs, &strokes), watch)?;
    if processed.stopped {
        return Ok(None);
    }
    if processed.strokes.is_empty() {
        remove_logs(&logs)?;
        return Ok(Some(Entry::without_failures(case)));
    }
    // What a direct shear test tells.
    let mut told = Campaign::read_beside(&strokes)?.unwrap_or_default();
    (told.phi_independent_deg, told.phi_independent_sd) = (Some(case.told_phi_deg), Some(PHI_SD_DEG));
    told.write_beside(&strokes)?;
    let twin = folder.join(TWIN);
    let request =
        Request { dir: logs.clone(), model: model.to_owned(), out: Some(twin.clone()), ..Request::default() };
    let found = without_page(&request, watch)?;
    if stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    remove_logs(&logs)?;
    let again = twin.join("resimulated");
    if again.is_dir() {
        std::fs::remove_dir_all(&again).map_err(failed(&again))?;
    }
    Ok(Some(Entry::new(case, &found)))
}
