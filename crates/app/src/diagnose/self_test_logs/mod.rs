//! Hidden effects in logs of arms that the twin does not know, and how often the diagnosis is right.

mod campaign;
mod counts;
mod design;
mod hidden;
mod outside;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::Instant;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_effects::EffectId;
use soilctl_jobs::{Inputs, Journal};

pub use counts::{Entry, Part, Said};
pub use design::Design;
use hidden::{Case, Sand, Wanted};

use super::self_test::Rate;
use crate::files::failed;
use crate::{AppError, Interrupted, Outcome, Watch};

/// Hides effects in logs of simulated arms that the twin does not know, diagnoses them with the twin, and counts how often that is right.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Folder for the campaigns; a run that was ended goes on from there
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,

    /// Force model without effects
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model)]
    pub model: String,

    /// Hidden campaigns; every third hides nothing, the others an effect in turn
    #[arg(long, value_name = "N", default_value_t = Request::default().campaigns, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    #[schemars(range(min = 1, max = 10_000))]
    pub campaigns: u64,

    /// Strokes of a campaign
    #[arg(long, value_name = "N", value_enum, default_value_t = Request::default().strokes)]
    pub strokes: Design,

    /// Hide this effect in all of them, or `none`, or `two`: in turn six pairs of effects, or `outside`: in turn six kinds that no effect is, which takes
    /// 24 strokes or 48
    #[arg(long, value_name = "EFFECT")]
    pub hidden: Option<String>,

    /// Preset of the sand of all of them, instead of four in turn
    #[arg(long, value_name = "PRESET")]
    pub soil: Option<String>,

    /// Where an answer leaves several effects open, run the plan that it proposes on the same arm and diagnose that, too
    #[arg(long)]
    pub follow_up: bool,

    /// Seed
    #[arg(long, value_name = "N", default_value_t = Request::default().seed)]
    pub seed: u64,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            folder: PathBuf::new(),
            model: "table".into(),
            campaigns: 3,
            strokes: Design::default(),
            hidden: None,
            soil: None,
            follow_up: false,
            seed: 1,
        }
    }
}

/// How often the diagnosis was right on logs of arms that the twin does not know.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Force model.
    pub model: String,
    /// Seed.
    pub seed: u64,
    /// Campaigns that are diagnosed, by number.
    pub campaigns: Vec<Entry>,
    /// Rates by name, each with the number of campaigns behind it. Campaigns in which no stroke failed the soil count nowhere.
    pub rates: Vec<Rate>,
    /// How often each hidden effect, or `none`, was answered by which status and first effect.
    pub confusion: BTreeMap<String, BTreeMap<String, usize>>,
    /// Whether the work was stopped before the last campaign.
    #[serde(skip)]
    pub stopped: bool,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.diagnose-self-test-logs/2";

    fn outcome(&self) -> Outcome {
        if self.stopped { Outcome::Partial } else { Outcome::Done }
    }
}

/// What must be the same for a run to go on with the campaigns of another. Their number may grow.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Header {
    schema: String,
    program_version: String,
    model: String,
    strokes: Design,
    hidden: Option<String>,
    soil: Option<String>,
    follow_up: bool,
    seed: u64,
}

impl Header {
    fn new(request: &Request) -> Self {
        Self {
            schema: "soilctl.diagnose-self-test-logs-journal/4".to_owned(),
            program_version: env!("CARGO_PKG_VERSION").to_owned(),
            model: request.model.clone(),
            strokes: request.strokes,
            hidden: request.hidden.clone(),
            soil: request.soil.clone(),
            follow_up: request.follow_up,
            seed: request.seed,
        }
    }
}

impl Inputs for Header {
    fn inputs(&self) -> Vec<(&'static str, String)> {
        let left_out = |value: Option<&String>| value.map_or_else(|| "left out".to_owned(), Clone::clone);
        vec![
            ("format", self.schema.clone()),
            ("version of soilctl", self.program_version.clone()),
            ("--model", self.model.clone()),
            ("--strokes", self.strokes.all().to_string()),
            ("--hidden", left_out(self.hidden.as_ref())),
            ("--soil", left_out(self.soil.as_ref())),
            ("--follow-up", self.follow_up.to_string()),
            ("--seed", self.seed.to_string()),
        ]
    }
}

/// Makes and diagnoses hidden campaigns, those that are missing in the folder.
///
/// # Errors
/// [`AppError`] if there is no such force model or effect, the folder is of another run, or a campaign cannot be made or diagnosed.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let wanted = wanted(request)?;
    let soil = request.soil.as_deref().map(Sand::named).transpose()?;
    let folder = &request.folder;
    std::fs::create_dir_all(folder).map_err(failed(folder))?;
    let (mut journal, mut entries) = open(&folder.join("self_test.jsonl"), &Header::new(request))?;
    let known = |entries: &[Entry], number: u64| entries.iter().any(|entry| entry.number == number);
    let stop = watch.stop(Interrupted::KeepsResults);
    let stopped = || stop.load(Ordering::Relaxed);
    let todo: Vec<u64> = (0..request.campaigns).filter(|number| !known(&entries, *number)).collect();
    let mut clock = Clock { watch, start: Instant::now(), todo: todo.len(), design: request.strokes };
    clock.begin(entries.len());
    for (done, number) in todo.into_iter().enumerate() {
        if stopped() {
            break;
        }
        let case = Case::new(request.seed, number, wanted, (request.strokes, soil), &request.model)?;
        let how = (request.model.as_str(), request.follow_up);
        let Some(entry) = campaign::run(folder, &case, how, watch)? else { break };
        let followed =
            entry.follow_up.as_ref().map(|said| format!(", after its follow-up {}", said.in_words()));
        let said = entry.said.in_words() + &followed.unwrap_or_default();
        clock.after(done + 1, &format!("campaign {number}, hidden {}: {said}", case.hidden.name()));
        journal.add(&entry)?;
        entries.push(entry);
    }
    entries.retain(|entry| entry.number < request.campaigns);
    entries.sort_by_key(|entry| entry.number);
    let (rates, confusion) = counts::count(&entries);
    Ok(Answer {
        model: request.model.clone(),
        seed: request.seed,
        stopped: (entries.len() as u64) < request.campaigns,
        campaigns: entries,
        rates,
        confusion,
    })
}

/// What campaigns are to hide.
fn wanted(request: &Request) -> Result<Wanted, AppError> {
    match (request.hidden.as_deref(), request.strokes) {
        (None, _) => Ok(Wanted::InTurn),
        (Some("none"), _) => Ok(Wanted::Nothing),
        (Some("two"), _) => Ok(Wanted::Two),
        (Some("outside"), Design::Strokes12) => Err(AppError::Request(
            "12 strokes have one depth and two tool angles, over which no shape shows: give 24 or 48 strokes"
                .to_owned(),
        )),
        (Some("outside"), Design::Strokes24 | Design::Strokes48) => Ok(Wanted::Outside),
        (Some(id), _) => Ok(Wanted::Effect(id.parse::<EffectId>()?)),
    }
}

/// The journal, and what it holds.
fn open(path: &Path, header: &Header) -> Result<(Journal, Vec<Entry>), AppError> {
    let entries = match Journal::read::<Header, Entry>(path)? {
        Some((found, entries)) => {
            found.same_as(header, path)?;
            entries
        }
        None => Vec::new(),
    };
    Ok((Journal::begin(path, header, &entries)?, entries))
}

/// Says what is ahead and how long it may take, by what was done.
struct Clock<'a> {
    watch: &'a dyn Watch,
    start: Instant,
    todo: usize,
    design: Design,
}

impl Clock<'_> {
    fn begin(&mut self, known: usize) {
        let minutes = |strokes: usize| strokes as f64 * STROKE_S / 60.0;
        let alone = RUNS * self.design.kinds();
        self.watch.note(&format!(
            "{} hidden campaigns of {} strokes to be made and diagnosed, {known} are there; each stroke is simulated twice, and some {alone} single \
             strokes a soil show what effects do: at some 3 s of one core a stroke, {:.0} min of one core and {:.0} for each new soil, and more where \
             something is found",
            self.todo,
            self.design.all(),
            minutes(2 * self.design.all() * self.todo),
            minutes(alone),
        ));
    }

    fn after(&self, done: usize, text: &str) {
        let left = self.start.elapsed().as_secs_f64() / done as f64 * self.todo.saturating_sub(done) as f64;
        self.watch.note(&format!("{text}; {left:.0} s left at this pace"));
    }
}

/// Processor time of a simulated stroke in s, on a machine of 2026, and how often each kind of stroke is simulated to show effects and settings in one
/// soil: for predictions only.
const STROKE_S: f64 = 3.0;
const RUNS: usize = 59;
