//! Logs of other programs: joint states and wrenches of any arm, in which strokes are found and weighed.
//!
//! The whole log is looked at first: one clock for all topics (`soilctl_motion`), what free air says of the sensor (`air/`), where the
//! plate touched the soil (`contact.rs`), what it did there (`push.rs`). Only then a stroke is weighed (`stroke.rs`), beside the
//! tare of its time and posture.

mod air;
mod checks;
mod contact;
mod look;
mod push;
mod stroke;
mod survey;
mod trust;
mod verdict;

use std::ops::Range;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_motion::{Columns, Joints, WALL_CLOCK_S, Wanted, columns};
pub use soilctl_motion::{Oddity, Trouble};

use self::air::AirModel;
pub use self::air::{FreeAir, Noise};
use self::checks::{check, check_units, no_air, note_gaps};
use self::contact::{Touch, depth};
use self::look::{Look, look};
use self::stroke::Weigher;
use self::survey::Survey;
use self::trust::{Doubt, Stops};
use self::verdict::{contact as told, deepest, time, weigh};
use crate::log::{Candidate, LogSettings, LogStroke, NoStroke};
use crate::{Outcome, ProcessError, Setting};

/// The edge is in free air for certain where it is this far above the surface, in m.
const CLEARANCE_M: f64 = 0.005;
/// A stroke travels at least so far along the ground, in m.
pub const LEAST_TRAVEL_M: f64 = 1.5e-3;
/// A force that shows above the surface for a shorter time is a bump that nobody needs to be told of, in s.
const BUMP_S: f64 = 0.3;
/// Wrenches that come further apart tell no failure, in s.
const SLOWEST_S: f64 = 0.1;
/// Rounds of telling free air from contact.
const ROUNDS: usize = 3;

/// What became of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactKind {
    /// A stroke with a failure force.
    Stroke,
    /// A stroke in which no failure can be told.
    NoFailure,
    /// A stroke that cannot be weighed.
    Refused,
    /// No stroke: a press, a touch, a bump.
    NoStroke,
}

/// A contact of the plate, or a window that was given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Contact {
    /// What became of it.
    pub kind: ContactKind,
    /// Begin in s.
    pub from_s: f64,
    /// End in s.
    pub to_s: f64,
    /// Greatest depth of the edge below the surface in m; negative above it; null where the posture is unknown.
    pub depth_m: Option<f64>,
    /// Greatest force beside the tare in N, over a block; null without a tare.
    pub highest_n: Option<f64>,
    /// Why it is no stroke with a failure force; null if it is one.
    pub reason: Option<String>,
}

/// What was found in a log of another program, beside its strokes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ForeignLog {
    /// What free air told; `None` if there was none.
    pub air: Option<FreeAir>,
    /// All contacts.
    pub contacts: Vec<Contact>,
    /// What was odd about the messages.
    pub troubles: Vec<Trouble>,
    /// Where its clock begins, in s of the stamps.
    pub origin_s: i64,
    /// Whether data that matter are missing: a stroke could not be weighed, or has a gap where the force rises.
    pub is_partial: bool,
    /// Damaged parts of the file.
    pub damage: Vec<String>,
    /// Bytes of the file.
    pub bytes: u64,
    /// Whether it has clouds of points.
    pub has_clouds: bool,
}

/// Reads a log of another program and hands over its strokes, and what is none.
///
/// # Errors
/// [`ProcessError::Log`] if the file cannot be read, is no log, or its wrenches tell nothing; [`ProcessError::Missing`],
/// [`ProcessError::Topic`], [`ProcessError::Joints`], [`ProcessError::Urdf`] or [`ProcessError::NoFrame`] if something is missing;
/// [`ProcessError::Stopped`].
pub(crate) fn read(
    path: &Path,
    settings: &LogSettings,
    stop: &AtomicBool,
    found: &mut dyn FnMut(Candidate),
) -> Result<ForeignLog, ProcessError> {
    let asked = |what: &'static str, value: Option<f64>| {
        let advice = "a log of another program does not say it; give it in m".to_owned();
        value.ok_or(ProcessError::Missing { what, advice })
    };
    let surface_z_m = asked("--surface-z", settings.surface_z_m)?;
    let mut setting = Setting {
        surface_z_m,
        width_m: asked("--width", settings.width_m)?,
        alpha_deg: settings.alpha_deg,
        delta_set_deg: settings.delta_set_deg,
        ..Setting::default()
    };
    let Look { joint_topics, wrench_topic, robot } = look(path, settings, stop)?;
    let wanted = Wanted {
        joint_topics: &joint_topics,
        wrench_topic: Some(&wrench_topic),
        joints: robot.joint_names(),
    };
    let mut columns = columns(path, &wanted, stop)?;
    check(&columns, &joint_topics, &wrench_topic, robot.joint_names())?;
    columns.wrenches.values.iter_mut().for_each(|wrench| *wrench = settings.sense.on_plate(*wrench));
    check_units(&columns, &robot)?;
    let survey = Survey::of(&columns, &robot);
    if survey.interval_s > SLOWEST_S {
        return Err(ProcessError::Log(format!(
            "wrenches on {wrench_topic} come every {:.3} s; a failure needs at least {} a second to be told: record faster",
            survey.interval_s,
            1.0 / SLOWEST_S
        )));
    }
    note_gaps(&mut columns, &survey, &wrench_topic);
    let windows: Option<Vec<Range<usize>>> = settings.windows.as_ref().map(|windows| {
        let mut sorted: Vec<[f64; 2]> =
            windows.iter().map(|window| window.map(|t_s| on_clock(t_s, columns.clock.origin_s))).collect();
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
        sorted.iter().map(|[from, to]| survey.within(*from, *to)).collect()
    });
    let in_window = |k: usize| windows.as_ref().is_some_and(|windows| windows.iter().any(|w| w.contains(&k)));
    let air = free_air(&survey, &columns, settings, surface_z_m, &in_window);
    let touches = match &windows {
        Some(windows) => windows.iter().map(|w| Touch { blocks: w.clone(), felt: None }).collect(),
        None => touches(&survey, air.as_ref(), surface_z_m),
    };
    setting.noise =
        air.as_ref().and_then(|air| air.told.noise).map(|noise| noise.of_force(survey.interval_s));
    let mut log = ForeignLog {
        air: air.as_ref().map(|air| air.told.clone()),
        origin_s: columns.clock.origin_s,
        damage: std::mem::take(&mut columns.damage),
        bytes: columns.bytes,
        has_clouds: columns.has_clouds,
        ..ForeignLog::default()
    };
    let clock_set = columns.troubles.iter().filter(|trouble| matches!(trouble.what, Oddity::ClockSet { .. }));
    let weigher = air.as_ref().map(|air| Weigher {
        columns: &columns,
        joints: Joints::new(&columns.joints),
        robot: &robot,
        survey: &survey,
        air,
        stops: Stops::of(&columns.wrenches),
        setting: &setting,
        clock_set_s: clock_set.map(|trouble| trouble.first_s).collect(),
    });
    let mut strokes: Vec<LogStroke> = Vec::new();
    for touch in &touches {
        let outcome = match &weigher {
            Some(weigher) => weigh(weigher, touch, surface_z_m),
            None => Err(NoStroke {
                from_s: time(&survey, touch.blocks.start),
                to_s: time(&survey, touch.blocks.end.saturating_sub(1)),
                reason: no_air(&survey, surface_z_m),
                refused: true,
            }),
        };
        if touch.felt.is_none() && windows.is_none() && outcome.is_err() && touch.blocks.len() < 2 {
            continue;
        }
        log.contacts.push(told(&survey, air.as_ref(), touch, surface_z_m, &outcome));
        match outcome {
            Ok(stroke) => strokes.push(stroke),
            Err(refused) => found(Candidate::Rejected(refused)),
        }
    }
    let weighed =
        strokes.iter().filter(|s| matches!(s.evaluated.analysis.outcome, Outcome::Found(_))).count();
    let few = 2 * weighed < log.contacts.iter().filter(|contact| contact.depth_m > Some(0.0)).count();
    for mut stroke in strokes {
        if few {
            stroke.flags.push(Doubt::FewStrokes.name());
        }
        log.is_partial |= stroke.flags.contains(&Doubt::Gap.name());
        found(Candidate::Stroke(Box::new(stroke)));
    }
    log.troubles = columns.troubles;
    log.is_partial |= log.contacts.iter().any(|contact| contact.kind == ContactKind::Refused);
    Ok(log)
}

/// A time on the log's clock, of one that may be meant on a wall clock.
fn on_clock(t_s: f64, origin_s: i64) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "seconds of a wall clock are exact")]
    let (wall_s, origin_s) = (WALL_CLOCK_S as f64, origin_s as f64);
    if t_s >= wall_s { t_s - origin_s } else { t_s }
}

/// What free air says: blocks with the edge well above the surface, or of unknown height, and without a force that shows.
fn free_air(
    survey: &Survey,
    columns: &Columns,
    settings: &LogSettings,
    surface_z_m: f64,
    in_window: &dyn Fn(usize) -> bool,
) -> Option<AirModel> {
    let above = |k: usize, least_m: f64| {
        depth(&survey.blocks[k], surface_z_m).is_none_or(|depth| depth < -least_m) && !in_window(k)
    };
    let mut air: Vec<usize> = (0..survey.blocks.len()).filter(|k| above(*k, CLEARANCE_M)).collect();
    if air.is_empty() {
        air = (0..survey.blocks.len()).filter(|k| above(*k, 0.0)).collect();
    }
    let mut found = None;
    for _ in 0..ROUNDS {
        found = AirModel::fit(survey, &columns.wrenches, &air, settings.tool_weight_n);
        let Some(model) = &found else { break };
        let felt = contact::felt(survey, model);
        let before = air.len();
        let free: Vec<usize> =
            air.iter().copied().filter(|k| !felt.iter().any(|run| run.contains(k))).collect();
        if free.len() == before || free.is_empty() {
            break;
        }
        air = free;
    }
    match settings.tare {
        Some(tare) => {
            Some(AirModel::given(settings.sense.on_plate(tare), settings.tool_weight_n, found, survey))
        }
        None => found,
    }
}

/// Contacts, but for short bumps above the surface. Without a model of free air, times below the surface.
fn touches(survey: &Survey, air: Option<&AirModel>, surface_z_m: f64) -> Vec<Touch> {
    let Some(air) = air else {
        let below = survey.blocks.iter().map(|block| depth(block, surface_z_m).is_some_and(|d| d > 0.0));
        return contact::runs(below).into_iter().map(|blocks| Touch { blocks, felt: None }).collect();
    };
    let all = contact::touches(survey, air, surface_z_m).into_iter();
    all.filter(|touch| {
        let lasts_s = time(survey, touch.blocks.end.saturating_sub(1)) - time(survey, touch.blocks.start);
        deepest(survey, touch, surface_z_m).is_none_or(|depth| depth > 0.0) || lasts_s > BUMP_S
    })
    .collect()
}
