//! Boundaries, plates and structures of a description.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What holds on a boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// The soil does not move.
    Fixed,
    /// The soil slides freely along, not across.
    Smooth,
    /// A plane of symmetry: the same as smooth.
    Symmetric,
    /// Nothing but the surcharge, and water above the ground, acts.
    Free,
    /// The soil goes on for ever: on the left and right under level ground, and below.
    Far,
    /// Given pressure and shear stress.
    Load,
}

/// A side of the whole problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Vertical outline at the least x.
    Left,
    /// Vertical outline at the greatest x.
    Right,
    /// Level outline at the least y.
    Bottom,
    /// Outline with the soil below it.
    Top,
}

/// What holds on a part of the outline.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoundaryEntry {
    /// Its name, for messages, cases and sweeps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// What holds.
    pub kind: Kind,
    /// Where: whole sides. A line of another entry takes precedence.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sides: Vec<Side>,
    /// Where: along these points, all on the outline.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub line: Vec<[f64; 2]>,
    /// Pressure of a load, in place of the surcharge: everywhere, or at the start and the end of `line`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure_kpa: Option<Profile>,
    /// Shear stress on the soil in the direction of `line`, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_kpa: Option<Profile>,
    /// Whether the objective `load` multiplies it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub live: bool,
    /// What kind of action a load is, for the partial factors of cases.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub action: Option<Action>,
}

impl BoundaryEntry {
    /// A condition on whole sides.
    #[must_use]
    pub fn on_sides(kind: Kind, sides: &[Side]) -> Self {
        Self { sides: sides.to_vec(), ..Self::on_line(kind, &[]) }
    }

    /// A condition along points of the outline.
    #[must_use]
    pub fn on_line(kind: Kind, line: &[[f64; 2]]) -> Self {
        Self {
            name: None,
            kind,
            sides: Vec::new(),
            line: line.to_vec(),
            pressure_kpa: None,
            shear_kpa: None,
            live: false,
            action: None,
        }
    }
}

/// What kind of action a load is, by which cases choose its partial factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Action {
    /// Permanent, and unfavourable.
    Permanent,
    /// Variable, and unfavourable.
    Variable,
    /// Favourable: it is not multiplied. A variable load that helps is to be left out.
    Favourable,
}

/// A stress along a line.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Profile {
    /// The same everywhere.
    Uniform(f64),
    /// Linear from the start to the end.
    Linear([f64; 2]),
}

impl Profile {
    /// Its values at the start and the end.
    #[must_use]
    pub const fn ends(self) -> [f64; 2] {
        match self {
            Self::Uniform(value) => [value; 2],
            Self::Linear(ends) => ends,
        }
    }
}

/// What a face bears: shear stress up to `adhesion + pressure * tan(delta)`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Interface {
    /// Friction angle.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub delta_deg: f64,
    /// Adhesion.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub adhesion_kpa: f64,
}

/// What a face bears against one soil.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SoilInterface {
    /// Name of the soil.
    pub soil: String,
    /// Friction angle.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub delta_deg: f64,
    /// Adhesion.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub adhesion_kpa: f64,
}

/// How a structure that does not move with the objective is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Hold {
    /// Soil sticks to it, and it does not move.
    Fixed,
    /// Soil slides along it freely but cannot leave it, and it does not move.
    Smooth,
}

/// A thin rigid plate with a face on each side that has soil. What sticks out of the soil is left out.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlateEntry {
    /// Its name; parts of one structure share it.
    pub name: String,
    /// Its points; a curved plate has many.
    pub line: Vec<[f64; 2]>,
    /// Friction angle of both faces.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub delta_deg: f64,
    /// Adhesion of both faces.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub adhesion_kpa: f64,
    /// The face on the left of `line`, if it differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left: Option<Interface>,
    /// The face on the right of `line`, if it differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right: Option<Interface>,
    /// Against some soils, on both faces, if it differs there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub in_soil: Vec<SoilInterface>,
    /// How it is held, if it does not move.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held: Option<Hold>,
}

/// A rigid body: a polygon, cut out of the soil where it covers it; or the line along which it meets the soil.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StructureEntry {
    /// Its name; parts of one structure share it.
    pub name: String,
    /// Its corners, either way round.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub polygon: Vec<[f64; 2]>,
    /// Instead: points along the outline of the soil.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub edge: Vec<[f64; 2]>,
    /// Friction angle of its faces.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub delta_deg: f64,
    /// Adhesion of its faces.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub adhesion_kpa: f64,
    /// Against some soils, if it differs there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub in_soil: Vec<SoilInterface>,
    /// How it is held, if it does not move.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held: Option<Hold>,
}

/// A straight bar or sheet inside the soil, thin and perfectly flexible: a geogrid, a nail, a strip. It bears an axial force and
/// takes the soil along. A sheet parts the soil, and the soil slides along its faces; with a pullout resistance it is a row of bars
/// (nails, strips, anchors, piles along themselves), between which the soil goes on. With a moment it is a beam, such as a sheet pile or a raft, which may also lie along the outline of the soil.
/// Forces are per metre of width.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MemberEntry {
    /// Its name.
    pub name: String,
    /// Its start and its end.
    pub line: Vec<[f64; 2]>,
    /// Greatest tension.
    pub tensile_kn_per_m: f64,
    /// Greatest compression; a sheet bears none.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub compressive_kn_per_m: f64,
    /// Shear stress that each face bears, over what the soil beside it bears at the same effective normal stress; above 0, at
    /// most 1.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub bond_factor: f64,
    /// Instead of a bond factor, of a row of bars between which the soil goes on: greatest force from the soil for each metre of bar, that
    /// of one bar over the spacing; everywhere, or at the start and the end. Zero is a tie that the soil hands nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pullout_kn_per_m2: Option<Profile>,
    /// Length from the start along which the soil hands a row of bars nothing, such as the free length of anchors.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub free_length_m: f64,
    /// Ends that are attached to the boundary, structure or beam there: they bear a force, others do not. Ends of beams are clamped.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub attached: Vec<MemberEnd>,
    /// Greatest bending moment of a beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moment_knm_per_m: Option<f64>,
    /// Greatest shear force of a beam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_kn_per_m: Option<f64>,
}

impl MemberEntry {
    /// Whether it is a beam.
    #[must_use]
    pub const fn bends(&self) -> bool {
        self.moment_knm_per_m.is_some()
    }

    /// Its length.
    #[must_use]
    pub fn length_m(&self) -> f64 {
        let [a, b] = [0, 1].map(|i| self.line.get(i).copied().unwrap_or_default());
        (b[0] - a[0]).hypot(b[1] - a[1])
    }
}

impl Default for MemberEntry {
    fn default() -> Self {
        Self {
            name: String::new(),
            line: Vec::new(),
            tensile_kn_per_m: 0.0,
            compressive_kn_per_m: 0.0,
            bond_factor: 1.0,
            pullout_kn_per_m2: None,
            free_length_m: 0.0,
            attached: Vec::new(),
            moment_knm_per_m: None,
            shear_kn_per_m: None,
        }
    }
}

/// An end of a member.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MemberEnd {
    /// The first point of its line.
    Start,
    /// The last one.
    End,
}

fn one() -> f64 {
    1.0
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_one(value: &f64) -> bool {
    *value == 1.0
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
pub(super) fn is_zero(value: &f64) -> bool {
    *value == 0.0
}
