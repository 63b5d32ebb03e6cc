use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::{Active, EffectId, EffectsError, EmpiricalTerm, Reference, Shape};

/// Id of the format.
pub const FILE_SCHEMA: &str = "soilctl.model-file/1";

/// A force model with a soil and the effects that a campaign was found to have: what `--model-file` loads.
///
/// Taking an entry out of `effects`, or of `empirical`, takes it out of every prediction, exactly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModelFile {
    /// [`FILE_SCHEMA`].
    pub schema: String,
    /// Id of the force model that everything is added to.
    pub model: String,
    /// Outcome of the diagnosis that wrote the file; `hand` if it was written by hand.
    pub status: String,
    /// The recalibrated soil.
    pub soil: SoilEntry,
    /// Effects, best first.
    pub effects: Vec<EffectEntry>,
    /// Terms without a name, of conditions of the strokes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub empirical: Vec<EmpiricalTerm>,
    /// What the data did not tell apart.
    #[serde(default)]
    pub equivalence_set: Vec<String>,
    /// What the parameters refer to.
    pub reference: Reference,
    /// FNV-1a hash of the stroke table, 16 hexadecimal digits; empty if written by hand.
    #[serde(default)]
    pub data_hash: String,
    /// How well it does on batches that it has not seen; `null` with fewer than two batches.
    #[serde(default)]
    pub held_out: Option<HeldOut>,
}

/// A value with its standard deviation and unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ParameterValue {
    /// The value.
    pub value: f64,
    /// Its standard deviation.
    pub sd: f64,
    /// Its unit; `1` for a number without.
    pub unit: String,
}

/// Soil and interface of a model file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SoilEntry {
    /// Friction angle, deg.
    pub phi_deg: ParameterValue,
    /// Interface friction angle for strokes without a set-point, deg.
    pub delta_deg: ParameterValue,
    /// True interface friction minus set-point for strokes with one, deg.
    pub delta_offset_deg: ParameterValue,
    /// Bulk density, kg/m3.
    pub density_kg_m3: ParameterValue,
    /// Gravity, m/s2.
    pub gravity_m_s2: f64,
}

/// One effect of a model file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EffectEntry {
    /// Id in the catalogue.
    pub id: EffectId,
    /// Its parameters by name.
    pub parameters: BTreeMap<String, ParameterValue>,
    /// Shape for effects whose shape is no parameter; see the catalogue.
    #[serde(default)]
    pub shape: f64,
    /// ln Bayes factor over the explanation without it; 0 if written by hand.
    #[serde(default)]
    pub log_bayes_factor: f64,
}

/// Figures of merit on batches that were left out of the fit, without and with the effects.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HeldOut {
    /// Root mean square of ln force measured over predicted, without effects.
    pub rmse_before: f64,
    /// The same with effects.
    pub rmse_after: f64,
    /// chi-square a stroke without effects.
    pub chi2_per_n_before: f64,
    /// The same with effects.
    pub chi2_per_n_after: f64,
    /// Gain in expected log predictive density.
    pub delta_elpd: f64,
    /// Its standard error.
    pub delta_elpd_se: f64,
}

impl EffectEntry {
    /// The effect with its amplitude and its shape; `file` stands for the model file in messages.
    fn active(&self, file: &str) -> Result<Active, EffectsError> {
        let effect = self.id.effect();
        let value = |name: &str| {
            let problem = || EffectsError::BadFile {
                file: file.into(),
                problem: format!("effect {} needs the parameter {name} with a finite value", self.id),
            };
            self.parameters.get(name).map(|p| p.value).filter(|v| v.is_finite()).ok_or_else(problem)
        };
        let amplitude = value(effect.parameter.name)?;
        let shape = match effect.shape.and_then(|shape| shape.parameter) {
            Some(parameter) => value(parameter.name)?,
            None => self.shape,
        };
        let wrong = |allowed: &str| EffectsError::BadFile {
            file: file.into(),
            problem: format!("the shape of effect {} is {shape}; it must be {allowed}", self.id),
        };
        if let Some(Shape { parameter, values }) = effect.shape {
            let (least, most) = values.iter().fold((f64::MAX, f64::MIN), |(l, m), v| (l.min(*v), m.max(*v)));
            if parameter.is_none() && !(least..=most).contains(&shape) {
                return Err(wrong(&format!("from {least} to {most}")));
            }
            if least > 0.0 && shape <= 0.0 {
                return Err(wrong("above 0"));
            }
        }
        Ok(Active { effect, amplitude, shape })
    }
}

impl ModelFile {
    /// Reads and checks a model file.
    ///
    /// # Errors
    /// [`EffectsError::File`] if it cannot be read, [`EffectsError::BadFile`] if it is not what it should be.
    pub fn read(path: &Path) -> Result<Self, EffectsError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path)
            .map_err(|problem| EffectsError::File { file: file.clone(), problem: problem.to_string() })?;
        Self::parse(&text, &file)
    }

    /// As [`ModelFile::read`], from text; `file` stands for it in messages.
    ///
    /// # Errors
    /// As [`ModelFile::read`].
    pub fn parse(text: &str, file: &str) -> Result<Self, EffectsError> {
        let bad = |problem: String| EffectsError::BadFile { file: file.into(), problem };
        let found: Self = serde_json::from_str(text).map_err(|problem| bad(problem.to_string()))?;
        if found.schema != FILE_SCHEMA {
            return Err(bad(format!("schema is {:?}; it must be {FILE_SCHEMA:?}", found.schema)));
        }
        let soil = &found.soil;
        let ranges = [
            ("soil.phi_deg", soil.phi_deg.value, 1.0, 60.0),
            ("soil.delta_deg", soil.delta_deg.value, 0.0, 60.0),
            ("soil.delta_offset_deg", soil.delta_offset_deg.value, -60.0, 60.0),
            ("soil.density_kg_m3", soil.density_kg_m3.value, 1.0, 1e5),
            ("soil.gravity_m_s2", soil.gravity_m_s2, 1e-3, 1e3),
            ("reference.depth_m", found.reference.depth_m, 1e-6, 1e3),
        ];
        for (key, value, low, high) in ranges {
            if !(low..=high).contains(&value) {
                return Err(bad(format!("{key} is {value}; it must be from {low} to {high}")));
            }
        }
        found.active(file)?;
        found.empirical.iter().try_for_each(|term| term.check(file))?;
        Ok(found)
    }

    /// Its effects with amplitudes and shapes, in the order in which they act; `file` stands for it in messages.
    ///
    /// # Errors
    /// [`EffectsError::BadFile`] with the parameter or shape that is wrong and what is allowed.
    pub fn active(&self, file: &str) -> Result<Vec<Active>, EffectsError> {
        self.effects.iter().map(|entry| entry.active(file)).collect()
    }

    /// Writes the file as JSON.
    ///
    /// # Errors
    /// [`EffectsError::File`] if it cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), EffectsError> {
        let failed = |problem: String| EffectsError::File { file: path.display().to_string(), problem };
        let text = serde_json::to_string_pretty(self).map_err(|problem| failed(problem.to_string()))?;
        let text = text + "\n";
        soilctl_jobs::write_atomically(path, text.as_bytes()).map_err(|problem| failed(problem.to_string()))
    }
}
