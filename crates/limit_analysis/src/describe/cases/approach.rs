//! Design approaches of Eurocode 7 with the values that it recommends.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Factors;

/// A design approach of EN 1997-1:2004 with the recommended values of its Annex A. National annexes may say others: give those
/// as `factors`.
///
/// | approach | sets | tan phi', c' | c_u | permanent | variable | resistance |
/// |---|---|---|---|---|---|---|
/// | `da1-1` | A1 + M1 + R1 | 1 | 1 | 1.35 | 1.5 | 1 |
/// | `da1-2` | A2 + M2 + R1 | 1.25 | 1.4 | 1 | 1.3 | 1 |
/// | `da2` | A1 + M1 + R2 | 1 | 1 | 1.35 | 1.5 | to be given |
/// | `da3` | loads A1, soil A2 + M2 + R3 | 1.25 | 1.4 | 1.35, soil 1 | 1.5 | 1 |
/// | `da3-slope` | A2 + M2 + R3 | 1.25 | 1.4 | 1 | 1.3 | 1 |
///
/// Sets A are Table A.3, M Table A.4, R Tables A.5, A.13 and A.14.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Approach {
    /// Design approach 1, combination 1: actions are multiplied.
    #[serde(rename = "da1-1")]
    Da1Actions,
    /// Design approach 1, combination 2: strengths are divided.
    #[serde(rename = "da1-2")]
    Da1Strengths,
    /// Design approach 2: actions are multiplied, and the resistance is divided.
    #[serde(rename = "da2")]
    Da2,
    /// Design approach 3 where loads come from a structure.
    #[serde(rename = "da3")]
    Da3,
    /// Design approach 3 for slopes and overall stability: loads act on the soil.
    #[serde(rename = "da3-slope")]
    Da3Slope,
}

/// Table A.3, sets A1 and A2: unfavourable permanent and variable actions.
const A1: [f64; 2] = [1.35, 1.5];
const A2: [f64; 2] = [1.0, 1.3];

/// Table A.4, sets M1 and M2: tan phi' and c', and c_u.
const M1: [f64; 2] = [1.0, 1.0];
const M2: [f64; 2] = [1.25, 1.4];

impl Approach {
    /// Its factors, that on resistance if there is one for all problems. That on weight is for unfavourable weight of soil.
    pub(super) fn factors(self) -> Factors {
        let ([permanent, variable], weight, [drained, undrained], resistance) = match self {
            Self::Da1Actions => (A1, A1[0], M1, Some(1.0)),
            Self::Da1Strengths => (A2, A2[0], M2, Some(1.0)),
            Self::Da2 => (A1, A1[0], M1, None),
            Self::Da3 => (A1, A2[0], M2, Some(1.0)),
            Self::Da3Slope => (A2, A2[0], M2, Some(1.0)),
        };
        Factors {
            friction: Some(drained),
            cohesion: Some(drained),
            undrained: Some(undrained),
            weight: Some(weight),
            water: None,
            permanent: Some(permanent),
            variable: Some(variable),
            resistance,
        }
    }
}
