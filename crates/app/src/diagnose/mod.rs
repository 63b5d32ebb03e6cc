//! Where model and measurement disagree, which effect is missing, and the gap after it is added.

mod against;
mod answer;
mod contenders;
mod disagreements;
mod files;
mod follow_up;
mod kept;
mod learn;
mod logs;
mod request;
mod resimulated;
pub mod self_test;
pub mod self_test_logs;

use std::path::Path;

pub use against::Against;
pub use answer::{
    Answer, ChannelGapAnswer, EffectAnswer, GapAnswer, NearestAnswer, NextAnswer, ParameterAnswer,
    SignalAnswer, TermAnswer, TermPoint, TestabilityAnswer, WhereAnswer,
};
use contenders::Weights;
use follow_up::FollowUp;
use logs::Asked;
pub use logs::Resimulation;
pub use request::Request;
use resimulated::Again;
pub use resimulated::{Resimulated, Simulated};
use soilctl_diagnosis::{AddedTraces, Data, Diagnosis, Readings, RecordedTraces, Surface, diagnose};
use soilctl_earth_pressure::plane_model;
use soilctl_strokes::{Campaign, ReadOptions, StrokeTable};

use crate::{AppError, Watch};

/// A diagnosis with everything that figures and page are drawn from.
pub struct Diagnosed {
    /// Name of the campaign: that of its folder.
    pub title: String,
    /// What it was held against.
    pub against: Against,
    /// The strokes and all that is known beside them.
    pub data: Data,
    /// What they say.
    pub diagnosis: Diagnosis,
    /// Their traces, if there are some.
    pub traces: Option<AddedTraces>,
    /// The campaign on the simulated arm, as far as it was asked for.
    pub simulated: Simulated,
    /// The answer.
    pub answer: Answer,
}

/// Diagnoses a campaign and writes all files but the page.
///
/// # Errors
/// [`AppError`] if the request or a file makes no sense, or a file cannot be read or written.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Diagnosed, AppError> {
    diagnosed(request, true, watch)
}

/// The same without simulating what was found once more, which only the page shows.
fn without_page(request: &Request, watch: &dyn Watch) -> Result<Diagnosed, AppError> {
    diagnosed(request, false, watch)
}

fn diagnosed(request: &Request, shows_found: bool, watch: &dyn Watch) -> Result<Diagnosed, AppError> {
    crate::request::check(request)?;
    let dir = &request.dir;
    let strokes = dir.join("strokes.csv");
    let out = request.out.clone().unwrap_or_else(|| dir.join("diagnosis"));
    let table = StrokeTable::read(&strokes, ReadOptions { allow_zero_sd: false })?;
    let campaign = Campaign::read_beside(&strokes)?.unwrap_or_default();
    let mut data = Data::new(table.name(), table.rows().collect(), campaign)?;
    // `process` takes the tare off; of a table of somebody else nobody knows.
    if table.unknown_columns().any(|column| column.name() == "failure_time_s") {
        data.tare_taken_off();
    }
    let traces = traces(request.traces.as_deref(), dir, &table, &mut data)?;
    let against = Against::read(&request.model, request.model_file.as_deref(), &mut data)?;
    let ends = (data.levels_deg[0], data.levels_deg[data.levels_deg.len() - 1]);
    let surface = Surface::new(plane_model(&against.model)?, ends)?;
    let weigh = |data: &Data| {
        watch.begin(0, "weighing explanations");
        let found = diagnose(data, &surface);
        watch.end();
        Ok(found?)
    };
    let log_evidence = |data: &Data, of: &Readings| Ok(soilctl_diagnosis::log_evidence(data, &surface, of)?);
    let fitted = |data: &Data, of: &[bool]| Ok(soilctl_diagnosis::fitted(data, &surface, of)?);
    let weights = Weights { diagnosis: &weigh, fitted: &fitted, log_evidence: &log_evidence };
    let mut diagnosis = weigh(&data)?;
    let mut follow_up = FollowUp::default();
    let (simulated, resimulated, why) = match logs::asked(request, &data)? {
        Asked::Not(how, why) => (Simulated::default(), how, why),
        Asked::Again(plan, seed) => {
            let again = Again { plan: *plan, seed, out: &out, shows_found, watch };
            let (simulated, how) = again.compare(&against, &mut data, &mut diagnosis, &weights)?;
            if let (Resimulation::Compared, Some(next)) = (how, &diagnosis.next) {
                follow_up = follow_up::write(&again.plan, request.logs.as_ref().unwrap_or(dir), next, &out)?;
            }
            (simulated, how, None)
        }
    };
    let title = dir.file_name().map_or_else(|| "campaign".into(), |name| name.to_string_lossy().into_owned());
    let written = files::write(&against, &data, &diagnosis, simulated.twin.as_ref(), &strokes, &out)?;
    let used = traces.as_ref().map_or(0, |traces| traces.used);
    let answer =
        Answer::new(&against, &data, &diagnosis, (&simulated, resimulated, why), used, &written, follow_up);
    Ok(Diagnosed { title, against, data, diagnosis, traces, simulated, answer })
}

/// Puts the traces that are named into the data, or those in the folder; `None` if there are none.
fn traces(
    named: Option<&Path>,
    dir: &Path,
    strokes: &StrokeTable,
    data: &mut Data,
) -> Result<Option<AddedTraces>, AppError> {
    let beside = dir.join("traces.csv");
    let path = match named {
        Some(path) => path,
        None if beside.is_file() => &beside,
        None => return Ok(None),
    };
    Ok(Some(RecordedTraces::read(path, strokes)?.add_to(data)))
}
