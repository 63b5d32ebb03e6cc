//! What an excavation is answered with.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_columns::{Cell, Kind};
use soilctl_digging::{Contact, End, Taught};

use super::request::Least;
use crate::files::save_table;
use crate::{AppError, Outcome};

/// What becomes of a plate that is pushed with an inclination.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Becomes {
    /// It sticks to the soil, in all soils that are possible.
    Sticks,
    /// It sticks or slips, by how rough it is within what is known.
    Open,
    /// It slips up along the soil.
    SlipsUp,
    /// It goes down, unless the soil below its edge holds it.
    Dives,
}

impl From<Contact> for Becomes {
    fn from(contact: Contact) -> Self {
        match contact {
            Contact::Sticks => Self::Sticks,
            Contact::Open => Self::Open,
            Contact::SlipsUp => Self::SlipsUp,
            Contact::Dives => Self::Dives,
        }
    }
}

/// What all soils bear of forces of one inclination.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct ForceRow {
    /// Inclination of the plate's force to its normal (deg), positive downwards.
    pub inclination_deg: f64,
    /// What becomes of the plate.
    pub plate: Becomes,
    /// Force (N) that every soil bears for certain; null where nothing is proven.
    pub bears_n: Option<f64>,
    /// Force (N) that fails every soil for certain; null beyond what the plate transmits.
    pub fails_n: Option<f64>,
    /// Greatest share of a torque limit at the force that fails; null without one.
    pub share: Option<f64>,
}

/// What a stroke at a tool angle takes at most, in the strongest of all soils.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct AngleRow {
    /// Tool angle at the insertion (deg).
    pub alpha_deg: f64,
    /// Tool angle at the end of the stroke (deg): the wrist stays, so that the plate turns with the forearm.
    pub end_alpha_deg: f64,
    /// Failure force (N) at the begin that every soil bears for certain; null where no lower bound is proven.
    pub bears_n: Option<f64>,
    /// Failure force (N) at the begin that is enough in every soil.
    pub fails_n: f64,
    /// Greatest share of a torque limit on the way.
    pub share: f64,
    /// Greatest sum of squared currents on the way (A2): heat (W) for each ohm of winding.
    pub heat_a2: f64,
    /// Work on the soil for each volume that is moved (kJ/m3).
    pub work_kj_m3: f64,
}

/// A pass as it was planned.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct PassRow {
    /// Tool angle at the insertion (deg).
    pub alpha_deg: f64,
    /// Depth below the surface where the plate goes in (m).
    pub depth_m: f64,
    /// Force (N) at the begin that is enough to fail every soil that was possible.
    pub fails_n: f64,
    /// Greatest share of a torque limit on the way, in the strongest soil.
    pub share: f64,
}

/// What became of a pass's measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Learned {
    /// It narrowed or confirmed what is possible.
    Region,
    /// No soil of what was possible explains it together with the others; it was left out.
    Contradicts,
    /// Friction angle or density were known exactly, so that there was nothing to narrow.
    Known,
    /// Its failure cannot be told.
    NoFailure,
    /// It was made into a heap.
    Heap,
    /// Its tool angle is none of the force model.
    OutsideModel,
    /// Nobody asked.
    NotAsked,
}

impl From<Option<Taught>> for Learned {
    fn from(taught: Option<Taught>) -> Self {
        match taught {
            Some(Taught::Region { .. }) => Self::Region,
            Some(Taught::Contradicts { .. }) => Self::Contradicts,
            Some(Taught::Known) => Self::Known,
            Some(Taught::NoFailure) => Self::NoFailure,
            Some(Taught::Heap) => Self::Heap,
            Some(Taught::OutsideModel) => Self::OutsideModel,
            None => Self::NotAsked,
        }
    }
}

/// A pass that was dug.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DugRow {
    /// As it was planned.
    pub planned: PassRow,
    /// Depth that was reached at the end of the insertion and of the stroke (m), in truth.
    pub depth_m: [f64; 2],
    /// Depth below the level surface that it cut to where it began (m), by the controller's sensors.
    pub floor_m: f64,
    /// Way of the plate (m).
    pub travel_m: f64,
    /// Soil that the plate swept (m3).
    pub swept_m3: f64,
    /// Greatest force of the soil in the stroke (N), in truth.
    pub peak_force_n: f64,
    /// Greatest share of a torque limit in insertion and stroke, of means over 0.1 s.
    pub peak_share: [f64; 2],
    /// Mechanical work of the motors in insertion and stroke (J).
    pub work_j: f64,
    /// Squared currents over the time of insertion and stroke (A2 s): heat (J) for each ohm of winding.
    pub heat_a2s: f64,
    /// Time of insertion and stroke (s).
    pub time_s: f64,
    /// What its measurement said.
    pub learned: Learned,
    /// Friction angles that are possible after it (deg).
    pub phi_deg: [f64; 2],
    /// Densities that are possible after it (kg/m3).
    pub density_kg_m3: [f64; 2],
    /// Why it was not made to its end; null if it was.
    pub failure: Option<String>,
}

/// Why an excavation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Ended {
    /// The trench is as deep as wanted.
    Complete,
    /// No pass keeps to the torque share in all soils that are possible.
    TooStrong,
    /// A stroke was not made to its end.
    StrokeFailed,
    /// There were as many passes as there may be.
    TooManyPasses,
    /// It was broken off.
    Stopped,
}

impl From<End> for Ended {
    fn from(end: End) -> Self {
        match end {
            End::Complete => Self::Complete,
            End::TooStrong => Self::TooStrong,
            End::StrokeFailed => Self::StrokeFailed,
            End::TooManyPasses => Self::TooManyPasses,
            End::Stopped => Self::Stopped,
        }
    }
}

/// How an excavation was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Manner {
    /// Tool angles chosen, replanned by what each pass taught.
    Learning,
    /// Tool angles chosen, without learning.
    Planned,
    /// The passes of the planned one again, as deep each, at a fixed tool angle of 90 deg, whatever torque that takes.
    Fixed,
}

/// A trench that was dug on the simulated arm.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DugTrench {
    /// How.
    pub manner: Manner,
    /// Why it ended.
    pub ended: Ended,
    /// Depth of its floor at the far end (m), by the controller's sensors.
    pub depth_m: f64,
    /// Passes in order.
    pub passes: Vec<DugRow>,
    /// Soil that was swept (m3).
    pub swept_m3: f64,
    /// Greatest share of a torque limit in any pass.
    pub peak_share: f64,
    /// Mechanical work of the motors (J).
    pub work_j: f64,
    /// The same for the volume swept (kJ/m3); null if none was.
    pub work_kj_m3: Option<f64>,
    /// Squared currents over time (A2 s): heat (J) for each ohm of winding.
    pub heat_a2s: f64,
    /// The same for the volume swept (A2 s for a litre); null if none was.
    pub heat_a2s_per_l: Option<f64>,
    /// Time of insertions and strokes (s).
    pub time_s: f64,
}

/// Which forces fail the soil, what they cost the motors, and a trench in passes.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The soil of the simulated box.
    pub soil: String,
    /// Friction angles that are possible (deg).
    pub phi_deg: [f64; 2],
    /// Friction on the plate that is possible (deg).
    pub delta_deg: [f64; 2],
    /// Densities that are possible (kg/m3).
    pub density_kg_m3: [f64; 2],
    /// What is to be least.
    pub least: Least,
    /// Share of the torque limits that a pass may take.
    pub share: f64,
    /// Tool angle (deg) and depth (m) for which forces and tool angles are told: those of the first pass, or of the least pass if none keeps the share.
    pub at: [f64; 2],
    /// Forces by their inclination.
    pub forces: Vec<ForceRow>,
    /// Tool angles; those that the arm does not reach are missing.
    pub angles: Vec<AngleRow>,
    /// Passes as they are planned, without what they will teach.
    pub passes: Vec<PassRow>,
    /// Whether these passes make the whole depth.
    pub complete: bool,
    /// Trenches that were dug on the simulated arm; empty if none was asked for.
    pub dug: Vec<DugTrench>,
    /// Files that were written.
    pub files: Vec<String>,
    /// The answer in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.excavate/1";

    fn outcome(&self) -> Outcome {
        let learned = self.dug.iter().find(|dug| dug.manner == Manner::Learning);
        let done = learned.map_or(self.complete, |dug| dug.ended == Ended::Complete);
        if done { Outcome::Done } else { Outcome::Partial }
    }
}

impl Answer {
    /// Writes the passes that were planned, or those that were dug.
    pub(super) fn write_table(&self, path: &Path) -> Result<(), AppError> {
        let planned = self.passes.iter().map(|pass| ("planned", pass, pass.depth_m, None));
        let planned = (1..).zip(planned.filter(|_| self.dug.is_empty()));
        let dug = self.dug.iter().flat_map(|trench| {
            let passes = trench.passes.iter();
            (1..).zip(passes.map(|pass| (trench.manner.name(), &pass.planned, pass.depth_m[0], Some(pass))))
        });
        let rows = planned.chain(dug).map(|(number, (manner, pass, depth_m, dug))| {
            let found = |of: fn(&DugRow) -> f64| dug.map_or(Cell::Missing, |dug| Cell::Float(of(dug)));
            [
                Cell::Text(manner.into()),
                Cell::Integer(number),
                Cell::Float(pass.alpha_deg),
                Cell::Float(depth_m),
                Cell::Float(pass.share),
                found(|dug| dug.peak_share[0].max(dug.peak_share[1])),
                found(|dug| dug.peak_force_n),
                found(|dug| dug.work_j),
                found(|dug| dug.heat_a2s),
                found(|dug| dug.swept_m3),
                found(|dug| dug.travel_m),
            ]
        });
        save_table(path, "excavate", COLUMNS, rows)
    }
}

impl Manner {
    /// As tables call it.
    fn name(self) -> &'static str {
        match self {
            Self::Learning => "learning",
            Self::Planned => "without_learning",
            Self::Fixed => "fixed",
        }
    }
}

const COLUMNS: [(&str, Kind); 11] = [
    ("manner", Kind::Text),
    ("pass", Kind::Integer),
    ("alpha_deg", Kind::Decimal),
    ("depth_m", Kind::Decimal),
    ("planned_share", Kind::Decimal),
    ("peak_share", Kind::OptionalFloat),
    ("peak_force_n", Kind::OptionalFloat),
    ("work_j", Kind::OptionalFloat),
    ("heat_a2s", Kind::OptionalFloat),
    ("swept_m3", Kind::OptionalFloat),
    ("travel_m", Kind::OptionalFloat),
];
