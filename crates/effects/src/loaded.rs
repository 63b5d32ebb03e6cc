use std::path::Path;

use soilctl_earth_pressure::plane_model;
use soilctl_strokes::StrokeRow;

use crate::{Active, Base, DirectMechanics, EffectsError, ModelFile, Stroke, force_n};

/// A model file that is ready to predict.
pub struct Loaded {
    file: ModelFile,
    mechanics: DirectMechanics,
    effects: Vec<Active>,
}

impl Loaded {
    /// Reads a model file and the force model that it names.
    ///
    /// # Errors
    /// As [`ModelFile::read`], and [`EffectsError::Model`] if there is no such force model.
    pub fn read(path: &Path) -> Result<Self, EffectsError> {
        Self::new(ModelFile::read(path)?, &path.display().to_string())
    }

    /// Prepares a model file; `name` stands for it in messages.
    ///
    /// # Errors
    /// As [`Loaded::read`].
    pub fn new(file: ModelFile, name: &str) -> Result<Self, EffectsError> {
        let effects = file.active(name)?;
        let mechanics = DirectMechanics::new(plane_model(&file.model)?);
        Ok(Self { file, mechanics, effects })
    }

    /// The file behind it.
    #[must_use]
    pub const fn file(&self) -> &ModelFile {
        &self.file
    }

    /// Its effects, in the order in which they act.
    #[must_use]
    pub fn effects(&self) -> &[Active] {
        &self.effects
    }

    /// Force in N that the model file expects to be read for a stroke, with its effects and empirical terms.
    ///
    /// # Errors
    /// As [`force_n`].
    pub fn force_n(&self, row: &StrokeRow) -> Result<f64, EffectsError> {
        let reference = &self.file.reference;
        let terms = self.file.empirical.iter().map(|term| term.ln_factor(row, reference)).sum::<f64>();
        let force_n = self.force_with(row, &self.effects)?;
        // Without terms no bit changes.
        Ok(if self.file.empirical.is_empty() { force_n } else { force_n * libm::exp(terms) })
    }

    /// The same without the effects and terms.
    ///
    /// # Errors
    /// As [`force_n`].
    pub fn plain_force_n(&self, row: &StrokeRow) -> Result<f64, EffectsError> {
        self.force_with(row, &[])
    }

    /// Whether the empirical terms were made from strokes like this one: beyond them they are held at their edge, and left out where a condition is not
    /// recorded.
    #[must_use]
    pub fn terms_tell(&self, row: &StrokeRow) -> bool {
        self.file.empirical.iter().all(|term| term.is_told(row, &self.file.reference))
    }

    /// Interface friction angle of a stroke, deg: its set-point and the offset, or that of the file.
    #[must_use]
    pub fn delta_deg(&self, row: &StrokeRow) -> f64 {
        let soil = &self.file.soil;
        row.delta_set_deg.map_or(soil.delta_deg.value, |set| (set + soil.delta_offset_deg.value).max(0.0))
    }

    fn force_with(&self, row: &StrokeRow, effects: &[Active]) -> Result<f64, EffectsError> {
        let soil = &self.file.soil;
        let base = Base {
            phi_deg: soil.phi_deg.value,
            delta_deg: self.delta_deg(row),
            density_kg_m3: soil.density_kg_m3.value,
            gravity_m_s2: soil.gravity_m_s2,
        };
        let reference = &self.file.reference;
        force_n(&self.mechanics, &Stroke::new(row, reference), reference, &base, effects)
    }
}
