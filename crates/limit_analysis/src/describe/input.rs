//! A problem as its author writes it: the content of a problem file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cases::{CaseEntry, SweepEntry};
use super::parts::{Action, BoundaryEntry, Kind, MemberEntry, PlateEntry, StructureEntry, is_zero};
use super::strength::StrengthLaw;

/// A plane-strain collapse problem in metres, kPa, kN/m3 and degrees: what a problem file says.
///
/// x points to the right, y upwards. See `docs/problem-file.md`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// `soilctl.problem/1`, or left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// What it is, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Pressure on all free boundaries and on the ground beyond far ones.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub surcharge_kpa: f64,
    /// What kind of action the surcharge is, for the partial factors of cases.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surcharge_action: Option<Action>,
    /// What holds on outline that no boundary entry names.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub default_boundary: Option<Kind>,
    /// What is bounded.
    pub objective: Aim,
    /// Earthquake as a steady acceleration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seismic: Option<Seismic>,
    /// Ground water.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub water: Option<Water>,
    /// Places with a given head: ground water flows between them.
    #[serde(default, rename = "head", skip_serializing_if = "Vec::is_empty")]
    pub heads: Vec<HeadEntry>,
    /// Water that flows between the given heads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seepage: Option<Seepage>,
    /// Soils.
    #[serde(default, rename = "soil")]
    pub soils: Vec<SoilEntry>,
    /// Where they are.
    #[serde(default, rename = "region")]
    pub regions: Vec<RegionEntry>,
    /// What holds on the outline.
    #[serde(default, rename = "boundary", skip_serializing_if = "Vec::is_empty")]
    pub boundaries: Vec<BoundaryEntry>,
    /// Thin rigid plates.
    #[serde(default, rename = "plate", skip_serializing_if = "Vec::is_empty")]
    pub plates: Vec<PlateEntry>,
    /// Rigid bodies.
    #[serde(default, rename = "structure", skip_serializing_if = "Vec::is_empty")]
    pub structures: Vec<StructureEntry>,
    /// Bars and sheets inside the soil.
    #[serde(default, rename = "member", skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MemberEntry>,
    /// Load cases.
    #[serde(default, rename = "case", skip_serializing_if = "Vec::is_empty")]
    pub cases: Vec<CaseEntry>,
    /// Parameters that take several values.
    #[serde(default, rename = "sweep", skip_serializing_if = "Vec::is_empty")]
    pub sweeps: Vec<SweepEntry>,
}

/// A soil: of Mohr and Coulomb's strength, or of a curved one.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SoilEntry {
    /// Its name, by which regions refer to it.
    pub name: String,
    /// Friction angle, 0 up to (not including) 90. Every soil has it or a `strength`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_deg: Option<f64>,
    /// Cohesion, at the reference level if it varies.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub cohesion_kpa: f64,
    /// What it grows by with each metre of depth.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub cohesion_gradient_kpa_per_m: f64,
    /// The y at which the cohesion is `cohesion_kpa`; needed with a gradient.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cohesion_level_m: Option<f64>,
    /// Unit weight, with the water in the pores.
    pub unit_weight_kn_m3: f64,
    /// Greatest effective tension; left out: what friction and cohesion allow.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension_kpa: Option<f64>,
    /// How the strength of clay (`phi_deg` 0) depends on the direction of the stress; `cohesion_kpa` is that under the greatest pressure upright then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub anisotropy: Option<AnisotropyEntry>,
    /// Strength that grows less and less with pressure, in place of `phi_deg` and cohesion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength: Option<StrengthLaw>,
    /// What `strength` is multiplied by, 0.01 to 100; 1 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strength_factor: Option<f64>,
    /// Dilation angle, 0 up to `phi_deg`, of soil that dilates less than the flow rule says: its strength is lessened after Davis (1968), which
    /// is an approximation, and bounds are proven for what is left. As much as the flow rule says if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dilation_deg: Option<f64>,
    /// Pore pressure over the weight of the soil vertically above, 0 to 1.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub pore_pressure_ratio: f64,
    /// Permeability to water, downwards, 1e-15 to 1e3; needed where water flows through several soils.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub permeability_m_per_s: Option<f64>,
    /// Permeability along x over that downwards, 1e-3 to 1e3; 1 if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub permeability_ratio: Option<f64>,
}

/// Undrained strength that depends on the direction of the stress, an ellipse in plane strain: strengths over the active one, `cohesion_kpa`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Anisotropy")]
pub struct AnisotropyEntry {
    /// Passive strength, where the greatest pressure is level, over the active one; 0.1 to 10.
    pub passive: f64,
    /// Greatest shear stress on level and upright planes over the active strength, 0.1 to 10; what direct simple shear finds.
    pub shear: f64,
}

/// An area of one soil.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RegionEntry {
    /// Its name, for messages.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Name of its soil.
    pub soil: String,
    /// Corners, either way round; the last is joined to the first. Regions may share edges, not area.
    pub polygon: Vec<[f64; 2]>,
}

/// Ground water: hydrostatic below its table, none above; open water where the table is above the ground.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Water {
    /// Points of the water table from left to right; level beyond its ends.
    pub table: Vec<[f64; 2]>,
    /// How much higher than these points the table is, for cases and sweeps.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub rise_m: f64,
    /// Unit weight of water.
    #[serde(default = "fresh_water")]
    pub unit_weight_kn_m3: f64,
}

impl Water {
    /// Fresh water with a table through these points.
    #[must_use]
    pub fn fresh(table: Vec<[f64; 2]>) -> Self {
        Self { table, rise_m: 0.0, unit_weight_kn_m3: fresh_water() }
    }

    /// Points of the water table where it is.
    #[must_use]
    pub fn levels(&self) -> Vec<[f64; 2]> {
        self.table.iter().map(|[x, y]| [*x, y + self.rise_m]).collect()
    }
}

fn fresh_water() -> f64 {
    9.81
}

/// Ground at which the head of the water is given, and open water where that is above the ground.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeadEntry {
    /// Its name, for messages, cases and sweeps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Points along the outline of the soil.
    pub line: Vec<[f64; 2]>,
    /// The total head: the y up to which water would rise in a standpipe there.
    pub head_m: f64,
}

/// Ground water that flows between given heads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Seepage {
    /// Unit weight of water.
    #[serde(default = "fresh_water")]
    pub unit_weight_kn_m3: f64,
}

impl Default for Seepage {
    fn default() -> Self {
        Self { unit_weight_kn_m3: fresh_water() }
    }
}

/// Earthquake as a steady acceleration, in units of gravity.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Seismic {
    /// Force on the soil towards positive x over its weight.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub kh: f64,
    /// Force upwards likewise, below 1.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub kv: f64,
}

/// What is bounded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Aim {
    /// The force of a structure or plate on the soil along its motion, in kN per metre of width.
    Structure {
        /// Name of the structures and plates that move, as one.
        name: String,
        /// Direction of motion; any length.
        direction: [f64; 2],
    },
    /// The factor on all live loads.
    Load {},
    /// The factor on all unit weights.
    UnitWeight {},
    /// The horizontal acceleration over gravity that is added to the given one.
    Seismic {
        /// Whether it pushes the soil towards negative x.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        leftwards: bool,
    },
    /// The factor by which cohesion and the tangents of all friction angles can be divided: the factor of safety.
    StrengthReduction {},
}

impl Default for Aim {
    fn default() -> Self {
        Self::Load {}
    }
}
