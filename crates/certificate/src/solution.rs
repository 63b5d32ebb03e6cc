use std::fs;
use std::io::Read;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::{CertificateError, LowerField, Mechanism, SpaceStress, Statement, UpperField};

/// What [`Solution::schema`] must say.
pub const SCHEMA: &str = "soilctl.solution/1";

/// Largest file that is read, in bytes: some 100 000 triangles.
pub const MAX_FILE_BYTES: u64 = 256 << 20;

/// A saved solution: a problem, and fields that prove bounds on its collapse force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Solution {
    /// [`SCHEMA`].
    pub schema: String,
    /// Name and version of the program that made it.
    pub program: String,
    /// The problem.
    pub statement: Statement,
    /// What one unit of the statement is; no proof depends on it.
    #[serde(default)]
    pub scale: Scale,
    /// Stress field for the lower bound.
    pub lower: Option<Claim<LowerField>>,
    /// Velocity field for the upper bound.
    pub upper: Option<Claim<UpperField>>,
    /// Blocks in space for the upper bound, if the structure has ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mechanism: Option<Claim<Mechanism>>,
    /// Stress field in space for the lower bound, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub space: Option<Claim<SpaceStress>>,
}

/// What the units of a statement are. Each entry is optional.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scale {
    /// Length of one in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length_m: Option<f64>,
    /// Unit weight of one in N/m^3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit_weight_n_per_m3: Option<f64>,
    /// What the problem is, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
}

/// A field and the bound that its maker claims for it. No proof looks at the claim.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim<F> {
    /// The field.
    pub field: F,
    /// The claimed bound, in the units of the statement.
    pub claimed: f64,
    /// How the field was computed, if that is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub computed: Option<Computed>,
}

/// How a field was computed: for those who want the same digits again. No proof depends on it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Computed {
    /// Name and version of the cone solver.
    pub solver: String,
    /// What factorised the linear systems of its steps.
    pub factorisation: String,
}

impl Solution {
    /// Reads a solution.
    ///
    /// # Errors
    ///
    /// [`CertificateError::File`], [`CertificateError::TooLarge`] above [`MAX_FILE_BYTES`],
    /// [`CertificateError::Format`] where the text is not of the format, [`CertificateError::Schema`].
    pub fn read(path: &Path) -> Result<Self, CertificateError> {
        let file_error =
            |e: std::io::Error| CertificateError::File { path: path.to_owned(), message: e.to_string() };
        let mut text = String::new();
        // Some files have no length, or grow.
        fs::File::open(path)
            .and_then(|file| file.take(MAX_FILE_BYTES + 1).read_to_string(&mut text))
            .map_err(file_error)?;
        Self::from_json(&text, path)
    }

    /// Reads the text of a file, which is called `name` where it makes no sense.
    ///
    /// # Errors
    ///
    /// [`CertificateError::TooLarge`], [`CertificateError::Format`] and [`CertificateError::Schema`], as [`Solution::read`].
    pub fn from_json(text: &str, name: &Path) -> Result<Self, CertificateError> {
        if text.len() as u64 > MAX_FILE_BYTES {
            return Err(CertificateError::TooLarge { path: name.to_owned(), limit: MAX_FILE_BYTES });
        }
        let solution: Self = serde_json::from_str(text)
            .map_err(|e| CertificateError::Format { path: name.to_owned(), message: e.to_string() })?;
        if solution.schema == SCHEMA {
            Ok(solution)
        } else {
            Err(CertificateError::Schema { found: solution.schema, expected: SCHEMA })
        }
    }

    /// Writes the solution as compact JSON from which [`Solution::read`] restores every number exactly.
    ///
    /// # Errors
    ///
    /// [`CertificateError::File`]; [`CertificateError::Format`] if a number is NaN or infinite, which JSON cannot say.
    pub fn write(&self, path: &Path) -> Result<(), CertificateError> {
        soilctl_jobs::write_atomically(path, self.to_json(path)?.as_bytes())
            .map_err(|e| CertificateError::File { path: path.to_owned(), message: e.to_string() })
    }

    /// The text of the file that [`Solution::write`] writes, which is called `name` where there is none.
    ///
    /// # Errors
    ///
    /// [`CertificateError::Format`], as [`Solution::write`].
    pub fn to_json(&self, name: &Path) -> Result<String, CertificateError> {
        let format = |message: String| CertificateError::Format { path: name.to_owned(), message };
        let text = serde_json::to_string(self).map_err(|e| format(e.to_string()))?;
        // JSON has no infinity and no NaN; serde writes `null`, which nobody could read back.
        if !serde_json::from_str::<Self>(&text).is_ok_and(|back| back == *self) {
            return Err(format("a number is NaN or infinite".into()));
        }
        Ok(text)
    }
}
