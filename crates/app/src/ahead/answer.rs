//! What is said of strokes that may come near something buried.

use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_columns::{Cell, Kind};
use soilctl_process::ahead::{Look, Place, Region};

use crate::files::save_table;
use crate::{AppError, Outcome};

/// What became of a stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Its force rose beyond what the soil explains.
    Alarm,
    /// It did not.
    Quiet,
    /// There is nothing to compare it with, or it ended too early.
    NotJudged,
}

impl Verdict {
    /// In words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Alarm => "ALARM",
            Self::Quiet => "quiet",
            Self::NotJudged => "not judged",
        }
    }
}

/// One look at a stroke.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct LookAnswer {
    /// Way of the plate when the look was possible.
    pub way_m: f64,
    /// Force over what the soil explains: at the first look by the other strokes, later by these and the force at the first.
    pub ratio: f64,
    /// Ratio above which a stroke alarms.
    pub limit: f64,
}

impl From<&Look> for LookAnswer {
    fn from(look: &Look) -> Self {
        Self { way_m: look.way_m, ratio: look.ratio, limit: look.limit }
    }
}

/// A part of the region.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct PlaceAnswer {
    /// Distance from the plate's lower edge ahead to the block, from and to (m).
    pub ahead_m: [f64; 2],
    /// Depth of its top below the surface, from and to (m).
    pub top_m: [f64; 2],
}

impl From<&Place> for PlaceAnswer {
    fn from(place: &Place) -> Self {
        Self { ahead_m: place.ahead_m, top_m: place.top_m }
    }
}

/// Where a fixed block may be.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct RegionAnswer {
    /// Distances still ahead, from and to (m); null if no block goes with the stroke.
    pub ahead_m: Option<[f64; 2]>,
    /// Depths of its top below the surface, from and to (m); null likewise.
    pub top_m: Option<[f64; 2]>,
    /// Whether it may be still further ahead than what was looked at.
    pub is_open: bool,
    /// All parts.
    pub places: Vec<PlaceAnswer>,
}

impl From<&Region> for RegionAnswer {
    fn from(region: &Region) -> Self {
        Self {
            ahead_m: region.ahead_m(),
            top_m: region.top_m(),
            is_open: region.is_open,
            places: region.places.iter().map(PlaceAnswer::from).collect(),
        }
    }
}

/// An alarm.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct AlarmAnswer {
    /// Way of the plate at the alarm (m).
    pub way_m: f64,
    /// When it came, in s on the clock of the log's stroke.
    pub time_s: f64,
    /// Force over what the soil explains, at the look that alarms.
    pub ratio: f64,
    /// Between these the ratio lies by the scatter of the others.
    pub ratio_range: [f64; 2],
    /// Whether it is more from the first look on, by comparison with other strokes; else it rose since.
    pub from_the_beginning: bool,
    /// Where a fixed block may be by the looks up to the alarm, seen from the plate then; null where bounds do not apply, since the plate is not upright.
    pub region: Option<RegionAnswer>,
    /// Way of the plate at the last look (m).
    pub last_way_m: f64,
    /// Where a fixed block may be by all looks, seen from the plate at the last; null likewise.
    pub last_region: Option<RegionAnswer>,
}

/// A stroke.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct StrokeAnswer {
    /// Its name: that of the log, and its number in it.
    pub stroke_id: String,
    /// When it began, in s on the log's clock.
    pub start_s: f64,
    /// Tool angle (deg).
    pub alpha_deg: f64,
    /// Depth of the plate at the beginning (m).
    pub depth_m: f64,
    /// What became of it.
    pub verdict: Verdict,
    /// Why it is not judged; null if it is.
    pub reason: Option<String>,
    /// Strokes it was compared with.
    pub references: usize,
    /// Looks over which the probability of a false alarm is shared out.
    pub looks_planned: usize,
    /// The alarm; null if it is none.
    pub alarm: Option<AlarmAnswer>,
    /// The looks.
    pub looks: Vec<LookAnswer>,
}

/// Strokes that may come near something buried.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The answer in words.
    pub verdict: String,
    /// Strokes that alarm.
    pub alarms: usize,
    /// Strokes that do not.
    pub quiet: usize,
    /// Strokes that are not judged.
    pub not_judged: usize,
    /// Probability that a stroke with nothing ahead alarms.
    pub false_alarms: f64,
    /// Probability that a region holds what bounds and scatter allow.
    pub confidence: f64,
    /// Strokes with nothing ahead, by the logs of `reference`; null without such logs.
    pub references: Option<usize>,
    /// Friction angles of the soil for which regions hold (deg).
    pub phi_deg: [f64; 2],
    /// The strokes, by log.
    pub strokes: Vec<StrokeAnswer>,
    /// Logs that cannot be used, and what is missing in others.
    pub problems: Vec<String>,
    /// What else is to be kept in mind.
    pub notes: Vec<String>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.ahead/1";

    fn outcome(&self) -> Outcome {
        if self.not_judged > 0 || !self.problems.is_empty() { Outcome::Partial } else { Outcome::Done }
    }
}

impl Answer {
    /// Writes the looks.
    pub(super) fn write_table(&self, path: &Path) -> Result<(), AppError> {
        let rows = self.strokes.iter().flat_map(|stroke| {
            stroke.looks.iter().map(|look| {
                let alarmed = stroke.alarm.as_ref().is_some_and(|alarm| alarm.way_m <= look.way_m);
                [
                    Cell::Text(stroke.stroke_id.as_str().into()),
                    Cell::Float(look.way_m),
                    Cell::Float(look.ratio),
                    Cell::Float(look.limit),
                    Cell::Flag(alarmed),
                ]
            })
        });
        save_table(path, "ahead", COLUMNS, rows)
    }
}

const COLUMNS: [(&str, Kind); 5] = [
    ("stroke_id", Kind::Text),
    ("way_m", Kind::Decimal),
    ("ratio", Kind::Decimal),
    ("limit", Kind::Decimal),
    ("alarmed", Kind::Flag),
];
