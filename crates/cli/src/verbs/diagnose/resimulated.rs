//! The same commands on the simulated arm: what it reads without the effects, and with those that were found.

use std::path::{Path, PathBuf};

use soilctl_app::simulate;
use soilctl_campaign::{Options, Plan};
use soilctl_diagnosis::{Course, Data};
use soilctl_effects::ModelFile;
use soilctl_strokes::{Campaign, ReadOptions, StrokeTable};

use super::recorded::Recorded;
use crate::error::CliError;
use crate::output::Output;
use crate::verbs::process;

/// Noise of the campaign that is simulated again must not be that of the first one.
const OTHER_NOISE: u64 = 0x5eed;

/// A campaign that was simulated again.
pub(super) struct Resimulated {
    /// What its logs gave.
    pub(super) data: Data,
    /// Forces in N and courses, by stroke of `data`.
    pub(super) courses: Vec<Option<Course>>,
}

impl Resimulated {
    /// Course and failure force in N of the stroke with a name; `None` if it was not made.
    pub(super) fn stroke(&self, stroke_id: &str) -> Option<(&Course, f64)> {
        let place = self.data.rows.iter().position(|row| row.stroke_id.as_deref() == Some(stroke_id))?;
        Some((self.courses.get(place)?.as_ref()?, self.data.rows[place].force_n))
    }
}

/// The first log of a folder, by name.
pub(super) fn first_log(folder: &Path) -> Result<PathBuf, CliError> {
    let failed = |problem| CliError::File { path: folder.display().to_string(), problem };
    let mut logs = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|ending| ending == "mcap") {
            logs.push(path);
        }
    }
    logs.sort();
    logs.into_iter().next().ok_or_else(|| {
        CliError::Usage(format!(
            "there is no .mcap file in {}; give the folder of the campaign's logs with --resimulate",
            folder.display()
        ))
    })
}

/// Runs the plan of a log again with soil and effects of a model file, in a folder of its own below `out`: what is
/// there of the same run is used. `None` if it was stopped.
pub(super) fn resimulate(
    log: &Path,
    file: &ModelFile,
    campaign: &Campaign,
    out: &Path,
    output: &Output,
) -> Result<Option<Resimulated>, CliError> {
    let (plan, seed) = Plan::from_log(log)?;
    let text = serde_json::to_string(file)?;
    let folder = out.join("resimulated").join(soilctl_jobs::fnv1a(text.as_bytes()));
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let options = Options { out: &folder, seed: seed ^ OTHER_NOISE, threads };
    let name = folder.display().to_string();
    let simulated = simulate::campaign(&plan, Some((file, name.as_str())), &options, output)?;
    if !simulated.complete {
        return Ok(None);
    }
    let strokes = folder.join("strokes.csv");
    let (processed, _) = process::process(&process::Args::plain(&folder, &strokes), output)?;
    if processed.stopped || processed.strokes.is_empty() {
        return Ok(None);
    }
    let table = StrokeTable::read(&strokes, ReadOptions { allow_zero_sd: false })?;
    let mut data = Data::new(table.name(), table.rows().collect(), campaign.clone())?;
    data.tare_taken_off();
    let traces = folder.join("traces.csv");
    let mut found = Vec::new();
    if let Some(recorded) = Recorded::read(Some(&traces), &folder, &table)? {
        found = recorded.added(&mut data).courses;
    }
    Ok(Some(Resimulated { data, courses: found }))
}
