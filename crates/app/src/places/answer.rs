//! What places say, as plain data.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_estimator::Ring;

use crate::Outcome;
use crate::request::Ends;

/// What was found at a place.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PlaceFound {
    /// Its name.
    pub name: String,
    /// Where it is along x (m); null if the table does not say.
    pub x_m: Option<f64>,
    /// Where it is along y (m).
    pub y_m: Option<f64>,
    /// Its strokes.
    pub strokes: usize,
    /// Whether any soil explains all of them.
    pub consistent: bool,
    /// Range of the friction angle (deg); null if inconsistent.
    pub phi_deg: Option<[f64; 2]>,
    /// Range of the density (kg/m3); null if inconsistent.
    pub density_kg_m3: Option<[f64; 2]>,
    /// What is known of the friction on the plate there (deg).
    pub delta_deg: [f64; 2],
    /// Consistent [phi, density]: polygons, each an outer ring and its holes.
    pub region: Vec<Vec<Ring>>,
    /// Place of its group in `groups`, from 0; null if inconsistent.
    pub group: Option<usize>,
}

/// What a pair of places was compared by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum By {
    /// Forces of strokes of one kind, which are the same in one soil whatever the model.
    Forces,
    /// Whether some soil explains the strokes of both, by the model.
    Sets,
    /// Nothing: no strokes of one kind, and at one of them no soil explains its strokes.
    Nothing,
}

/// Two places beside each other.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Pair {
    /// Their names.
    pub places: [String; 2],
    /// What they were compared by.
    pub by: By,
    /// Kinds of strokes that both have.
    pub kinds: usize,
    /// Forces at the first over those at the second, of strokes of one kind: their geometric mean; null without such strokes.
    pub force_ratio: Option<f64>,
    /// Least ratio above 1 that would have been told as a difference, of this pair alone; null without a probability.
    pub tellable_ratio: Option<f64>,
    /// Probability that places of one soil differ so much by chance, at most; null without a probability.
    pub p: Option<f64>,
    /// Whether the soils differ.
    pub differ: bool,
}

/// Places whose soils are not found to differ, together.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Group {
    /// Their names.
    pub places: Vec<String>,
    /// Range of the friction angle (deg) if they have one soil.
    pub phi_deg: [f64; 2],
    /// Range of the density (kg/m3) if they have one soil.
    pub density_kg_m3: [f64; 2],
    /// Consistent [phi, density] if they have one soil, as that of a place.
    pub region: Vec<Vec<Ring>>,
}

/// A covariance `sd^2 exp(-distance / length)` that the places leave plausible.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Covariance {
    /// Its length (m).
    pub length_m: f64,
    /// Greatest plausible standard deviation over the ground for that length, in the unit of the quantity.
    pub sd: f64,
}

/// A cell of the ground.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Cell {
    /// Its middle along x (m).
    pub x_m: f64,
    /// Its middle along y (m).
    pub y_m: f64,
    /// Range of the friction angle (deg) at its middle.
    pub phi_deg: [f64; 2],
    /// Range of the density (kg/m3) at its middle.
    pub density_kg_m3: [f64; 2],
    /// Standard deviation of what kriging errs by in the friction angle (deg), at most.
    pub phi_sd_deg: f64,
    /// The same of the density (kg/m3).
    pub density_sd_kg_m3: f64,
    /// Whether it is among the places, in their convex hull; beyond it the ground is carried on, not interpolated.
    pub inside: bool,
}

/// What lies between places.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Between {
    /// Side of a cell (m).
    pub cell_m: f64,
    /// Convex hull of the places: [x, y] (m).
    pub hull: Vec<[f64; 2]>,
    /// Covariances of the friction angle (deg).
    pub phi_covariances: Vec<Covariance>,
    /// Covariances of the density (kg/m3).
    pub density_covariances: Vec<Covariance>,
    /// Whether the greatest variation over the ground that was tried, fifteen times that of the places, is still plausible: then it may be more,
    /// and intervals wider.
    pub is_variation_open: bool,
    /// Standard deviations that an interval reaches beyond what places know.
    pub deviations: f64,
    /// Cells, along x first.
    pub cells: Vec<Cell>,
    /// Where a further place would tell most, the best first: [x, y] (m).
    pub next_places: Vec<[f64; 2]>,
}

/// The answer.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Answer {
    /// Force model.
    pub model: String,
    /// Whether plates have ends.
    pub ends: Ends,
    /// Probability with which the set of a place holds its soil; null for bounds, which hold it for sure.
    pub confidence: Option<f64>,
    /// Part of the differences that are told which may be none; null for bounds.
    pub false_discovery: Option<f64>,
    /// Places in the order in which they first appear.
    pub places: Vec<PlaceFound>,
    /// Pairs of places.
    pub pairs: Vec<Pair>,
    /// Groups of places whose soils are not found to differ.
    pub groups: Vec<Group>,
    /// What lies between places; null if they are too few or have no coordinates.
    pub between: Option<Between>,
    /// The result in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.places/1";

    /// In part if a place has no set.
    fn outcome(&self) -> Outcome {
        if self.places.iter().all(|place| place.consistent) { Outcome::Done } else { Outcome::Partial }
    }
}
