//! One hidden campaign: simulated on an arm that the twin does not know, processed, and diagnosed with the twin.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use soilctl_campaign::{Content, Options, Plan};
use soilctl_strokes::Campaign;

use super::counts::{Entry, Said};
use super::hidden::{Case, PHI_SD_DEG};
use crate::diagnose::kept::remove_logs;
use crate::diagnose::{Diagnosed, Request, without_page};
use crate::files::{failed, read_text, save};
use crate::machine::cores;
use crate::{AppError, Interrupted, Watch, process, simulate};

/// Folder of what the twin keeps between campaigns, beside theirs.
const TWIN: &str = "twin";
/// Folders of the logs of a campaign, and of its follow-up.
const CAMPAIGN: &str = "logs";
const FOLLOW_UP: &str = "follow_up";

/// Makes and diagnoses a campaign in a folder of its own within `folder`, of which only tables are left; `None` if it was stopped, and
/// then the next run goes on from there. Where the answer leaves several effects open and proposes a plan, that is run on the same arm and
/// diagnosed, if `how` (the force model, and that) says so.
pub(super) fn run(
    folder: &Path,
    case: &Case,
    how: (&str, bool),
    watch: &dyn Watch,
) -> Result<Option<Entry>, AppError> {
    let entry = made(folder, case, how, watch)?;
    // Only now: who goes on after a follow-up that was stopped needs the logs of the campaign.
    if entry.is_some() {
        let own = own(folder, case);
        for logs in [CAMPAIGN, FOLLOW_UP].map(|name| own.join(name)) {
            if logs.is_dir() {
                remove_logs(&logs)?;
            }
        }
    }
    Ok(entry)
}

fn own(folder: &Path, case: &Case) -> PathBuf {
    folder.join(format!("{:04}_{}", case.number, case.hidden.name()))
}

fn made(
    folder: &Path,
    case: &Case,
    (model, follows_up): (&str, bool),
    watch: &dyn Watch,
) -> Result<Option<Entry>, AppError> {
    let own = own(folder, case);
    std::fs::create_dir_all(&own).map_err(failed(&own))?;
    save(&own.join("plant.toml"), case.plant.as_bytes())?;
    let hidden = Hidden { own: &own, twin: folder.join(TWIN), case, model, watch };
    let plan = Plan::from_toml(&case.plan, "the plan of a hidden campaign", &own)?;
    let found = match hidden.diagnosed(&plan, CAMPAIGN)? {
        Made::Stopped => return Ok(None),
        Made::WithoutFailures => return Ok(Some(Entry::new(case, Said::without_failures(), None))),
        Made::Diagnosed(found) => found,
    };
    let proposed = found.answer.next_experiment.as_ref().and_then(|next| next.plan.as_ref());
    let (true, true, Some(proposed)) = (follows_up, found.answer.equivalence_set.len() > 1, proposed) else {
        return Ok(Some(Entry::new(case, Said::new(case, &found), None)));
    };
    // The proposal names the twin's plant; the arm is the one that made the campaign.
    let plan = Plan::from_toml(&read_text(Path::new(proposed))?, proposed, &own)?;
    let followed = match hidden.diagnosed(&plan, FOLLOW_UP)? {
        Made::Stopped => return Ok(None),
        Made::WithoutFailures => Said::without_failures(),
        Made::Diagnosed(followed) => Said::new(case, &followed),
    };
    Ok(Some(Entry::new(case, Said::new(case, &found), Some(followed))))
}

/// What became of a campaign.
enum Made {
    Stopped,
    WithoutFailures,
    Diagnosed(Box<Diagnosed>),
}

struct Hidden<'a> {
    own: &'a Path,
    twin: PathBuf,
    case: &'a Case,
    model: &'a str,
    watch: &'a dyn Watch,
}

impl Hidden<'_> {
    /// Runs a plan on the hidden arm and diagnoses its logs with the twin.
    fn diagnosed(&self, plan: &Plan, name: &str) -> Result<Made, AppError> {
        let stop = self.watch.stop(Interrupted::KeepsResults);
        let logs = self.own.join(name);
        std::fs::create_dir_all(&logs).map_err(failed(&logs))?;
        // Whoever simulates the logs again finds the twin's plant beside them.
        save(&logs.join("plant.toml"), soilctl_campaign::default_plant()?.as_bytes())?;
        let strokes = logs.join("strokes.csv");
        let options = Options {
            out: &logs,
            seed: self.case.seed,
            threads: cores(),
            content: Content::Steps,
            only: None,
        };
        let made =
            simulate::campaign(plan, Some((&self.case.truth, "what is hidden")), &options, self.watch)?;
        if !made.complete {
            return Ok(Made::Stopped);
        }
        let processed = process::run(&process::Request::of_folder(&logs, &strokes), self.watch)?;
        if processed.stopped {
            return Ok(Made::Stopped);
        }
        if processed.strokes.is_empty() {
            return Ok(Made::WithoutFailures);
        }
        // What a direct shear test tells.
        let mut told = Campaign::read_beside(&strokes)?.unwrap_or_default();
        (told.phi_independent_deg, told.phi_independent_sd) =
            (Some(self.case.told_phi_deg), Some(PHI_SD_DEG));
        told.write_beside(&strokes)?;
        let request = Request {
            dir: logs.clone(),
            model: self.model.to_owned(),
            out: Some(self.twin.clone()),
            ..Request::default()
        };
        let found = without_page(&request, self.watch)?;
        if stop.load(Ordering::Relaxed) {
            return Ok(Made::Stopped);
        }
        let again = self.twin.join("resimulated");
        if again.is_dir() {
            std::fs::remove_dir_all(&again).map_err(failed(&again))?;
        }
        Ok(Made::Diagnosed(Box::new(found)))
    }
}
