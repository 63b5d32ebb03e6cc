//! A campaign plan as it stands in a TOML file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Id of the format in the reference documentation; the file itself says `version = 1`.
pub const PLAN_SCHEMA: &str = "soilctl.plan/1";

/// A campaign plan. Unknown keys are refused.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanFile {
    /// Version of the format: 1.
    pub version: u32,
    /// What the campaign is for, in free text; goes into `campaign.json`.
    #[serde(default)]
    pub design: String,
    /// The arm: `thesis`, or the path of an arm file, from the folder of the plan.
    #[serde(default = "thesis")]
    pub arm: String,
    /// Settings of the controller: `default`, or the path of a settings file, from the folder of the plan.
    #[serde(default = "default")]
    pub controller: String,
    /// The simulated plant: `default`, or the path of a plant file, from the folder of the plan.
    #[serde(default = "default")]
    pub plant: String,
    /// The soil: the name of a preset, or a table.
    pub soil: SoilEntry,
    /// Force model whose forces are the true ones: any that `predict` knows, or `table` for a bracket.
    #[serde(default = "table")]
    pub model: String,
    /// Part of what the plate's ends add at most, by the table of proven bounds, that they do add to the forces of the model; 0 to 1.
    /// Left out: 0, plane strain.
    #[serde(default)]
    pub end_factor: f64,
    /// Seed of noise and scatter, from 0; an option of the command line goes before.
    #[serde(default)]
    pub seed: u64,
    /// Whether each batch begins with a search of the joints' stops. Otherwise the encoders are referenced when a batch
    /// begins, as after homing by hand.
    #[serde(default)]
    pub homing: bool,
    /// How the soil is prepared.
    #[serde(default)]
    pub preparation: Preparation,
    /// Rigid blocks that are buried in the soil.
    #[serde(default)]
    pub blocks: Vec<Block>,
    /// The batches, one preparation of the soil each, with at most 1024 strokes together.
    pub batches: Vec<Batch>,
}

/// A rigid block that does not move, buried upright and aligned with a radius from the base axis. It reaches down as far as any plate goes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Block {
    /// Number of the batch in whose soil it lies, from 0. Left out: it lies in that of all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub batch: Option<usize>,
    /// Distance from the base axis to the face that is turned away from it, which a pulled plate meets, in m; above 0, at most 10.
    pub face_radius_m: f64,
    /// Base angle of its middle in degrees; -180 to 180.
    pub base_deg: f64,
    /// Depth of its top below the level surface in m; 0 to 1.
    pub top_m: f64,
    /// Width across the radius in m; above 0, at most 10.
    pub width_m: f64,
    /// Length from that face towards the base in m; above 0, at most 10.
    pub length_m: f64,
}

/// A soil: a preset or numbers.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum SoilEntry {
    /// Name of a preset.
    Preset(String),
    /// Numbers.
    Soil(SoilTable),
}

/// A soil by its numbers.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SoilTable {
    /// Friction angle in degrees; 1 to 60. With `friction_law`, that at its reference stress.
    pub phi_deg: f64,
    /// How friction falls with stress; left out, it is the same everywhere. Only of soil without cohesion and buried blocks.
    #[serde(default)]
    pub friction_law: Option<LawTable>,
    /// Friction angle between soil and plate in degrees; 0 to `phi_deg`.
    pub delta_deg: f64,
    /// Cohesion in Pa; 0 to 1e5.
    #[serde(default)]
    pub cohesion_pa: f64,
    /// Bulk density in kg/m3; 100 to 10 000.
    pub density_kg_m3: f64,
    /// Density of the loosest packing in kg/m3.
    pub loosest_kg_m3: f64,
    /// Density of the densest packing in kg/m3; at least 1 above the loosest.
    pub densest_kg_m3: f64,
    /// Gravity in m/s2; above 0, at most 30.
    #[serde(default = "standard_gravity")]
    pub gravity_m_s2: f64,
}

/// Friction as a law of stress, `phi = phi_deg - slope log10(stress / reference)`, with the normal stress where the soil slips. Friction stays
/// within what the force model answers, and is at least that on the plate.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LawTable {
    /// Fall of the friction angle in degrees a decade of stress; 0 to 12.
    pub slope_deg_per_decade: f64,
    /// Normal stress in Pa at which the friction angle is `phi_deg`; 1 to 1e6.
    pub reference_stress_pa: f64,
}

/// How the soil is prepared before each batch.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Preparation {
    /// Standard deviation of the density between preparations, relative; 0 to 0.2. Left out: that of the preset, or
    /// 0.02.
    pub density_sd_rel: Option<f64>,
}

/// Strokes in one preparation of the soil.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Batch {
    /// Radius of its strokes from the base axis in m, where they have none of their own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_m: Option<f64>,
    /// The strokes in order; at least one.
    pub strokes: Vec<Stroke>,
}

/// A stroke.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stroke {
    /// Radius of the insertion from the base axis in m; above 0. Left out: that of the batch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_m: Option<f64>,
    /// Base angle in degrees; -180 to 180.
    pub base_deg: f64,
    /// Tool angle from the horizontal in degrees; 45 to 135.
    pub alpha_deg: f64,
    /// Vertical depth of the lower edge in m; above 0.
    pub depth_m: f64,
    /// Wanted angle between force and plate normal in degrees; 0 to 60.
    pub delta_set_deg: f64,
}

fn thesis() -> String {
    "thesis".to_owned()
}

fn default() -> String {
    "default".to_owned()
}

fn table() -> String {
    "table".to_owned()
}

const fn standard_gravity() -> f64 {
    soilctl_soil::STANDARD_GRAVITY_M_S2
}
