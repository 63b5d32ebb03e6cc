//! Cases and sweeps as their author writes them.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Approach;
use crate::describe::check::title;
use crate::describe::error::DescriptionError;

/// A load case: the problem with other values, and with partial factors on actions and strengths.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CaseEntry {
    /// Its name.
    pub name: String,
    /// A design approach, which says all partial factors that `factors` does not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub approach: Option<Approach>,
    /// What the weight of the soil does. Needed with an approach that multiplies unfavourable permanent actions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub soil_weight: Option<Effect>,
    /// Partial factors.
    #[serde(default)]
    pub factors: Factors,
    /// Values in place of those of the file, by parameter: `"soil.sand.phi_deg" = 34`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub set: BTreeMap<String, Setting>,
}

impl CaseEntry {
    pub(super) fn title(&self, index: usize) -> String {
        title("case", index, &self.name)
    }
}

/// What an action does to the safety of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// It helps.
    Favourable,
    /// It harms.
    Unfavourable,
}

/// Partial factors, one where nothing else says what they are.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Factors {
    /// Divides the tangents of friction angles, of soils and of faces.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// Divides the cohesion and tension of soils with friction, and the adhesion of faces with friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cohesion: Option<f64>,
    /// Divides the undrained shear strength of soils without friction, and the adhesion of faces without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub undrained: Option<f64>,
    /// Multiplies the unit weights of soils.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
    /// Multiplies the unit weight of water; that of soils if left out, since both are one action.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub water: Option<f64>,
    /// Multiplies permanent loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub permanent: Option<f64>,
    /// Multiplies variable loads.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub variable: Option<f64>,
    /// Divides the bounds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub resistance: Option<f64>,
}

/// What a parameter is set to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Setting {
    /// A number.
    Number(f64),
    /// Points, for a polygon, a line or a water table.
    Points(Vec<[f64; 2]>),
    /// Numbers, for a load that varies along its line, or a direction.
    Numbers([f64; 2]),
}

/// A parameter that takes several values: a list of them, or `count` from `from` to `to`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SweepEntry {
    /// The parameter, such as `soil.sand.phi_deg`, `boundary.traffic.pressure_kpa` or `seismic.kh`.
    pub parameter: String,
    /// The values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub values: Vec<f64>,
    /// First value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<f64>,
    /// Last value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
    /// How many values at equal distances, both ends included: 2 or more.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub count: Option<u16>,
}

impl SweepEntry {
    /// The values.
    pub(super) fn points(&self, index: usize) -> Result<Vec<f64>, DescriptionError> {
        let wrong = |problem: &str| {
            Err(DescriptionError::entry(title("sweep", index, &self.parameter), problem.to_owned()))
        };
        let points = match (self.values.is_empty(), self.from, self.to, self.count) {
            (false, None, None, None) => self.values.clone(),
            (true, Some(from), Some(to), Some(count)) if count >= 2 => {
                let part = |k: u16| f64::from(k) / f64::from(count - 1);
                (0..count).map(|k| from * (1.0 - part(k)) + to * part(k)).collect()
            }
            (true, Some(_), Some(_), Some(_)) => return wrong("count must be 2 or more"),
            _ => return wrong("give either values, or from, to and count"),
        };
        if points.iter().any(|value| !value.is_finite()) {
            return wrong("its values must be finite numbers");
        }
        Ok(points)
    }
}
