//! What a campaign is held against.

use std::path::Path;

use soilctl_diagnosis::Data;
use soilctl_effects::{EffectEntry, Loaded, ModelFile};

use crate::AppError;

/// What a campaign is held against.
pub struct Against {
    /// Id of the force model.
    pub model: String,
    /// The model file that it comes from, with its path.
    pub file: Option<(String, ModelFile)>,
}

impl Against {
    /// A force model, or that of a model file, whose effects the data then take as known.
    pub(super) fn read(model: &str, file: Option<&Path>, data: &mut Data) -> Result<Self, AppError> {
        let Some(path) = file else { return Ok(Self { model: model.to_owned(), file: None }) };
        let known = Loaded::read(path)?;
        data.know(&known);
        let file = known.file().clone();
        Ok(Self { model: file.model.clone(), file: Some((path.display().to_string(), file)) })
    }

    /// Effects of the model file.
    #[must_use]
    pub fn known(&self) -> &[EffectEntry] {
        self.file.as_ref().map_or(&[], |(_, file)| &file.effects)
    }

    /// In words.
    #[must_use]
    pub fn described(&self) -> String {
        let ids: Vec<&str> = self.known().iter().map(|known| known.id.name()).collect();
        if ids.is_empty() { self.model.clone() } else { format!("{} with {}", self.model, ids.join(", ")) }
    }
}
