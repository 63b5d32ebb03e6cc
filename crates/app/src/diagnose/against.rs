//! What a campaign is held against.

use std::path::Path;

use soilctl_diagnosis::Data;
use soilctl_effects::{EffectEntry, EmpiricalTerm, Loaded, ModelFile};

use crate::{AppError, terms};

/// What a campaign is held against.
pub struct Against {
    /// Id of the force model.
    pub model: String,
    /// The model file that it comes from, with its path.
    pub file: Option<(String, ModelFile)>,
    /// That strokes lie beyond those from which its empirical terms were made.
    pub beyond_terms: Option<String>,
}

impl Against {
    /// A force model, or that of a model file, whose effects the data then take as known.
    pub(super) fn read(model: &str, file: Option<&Path>, data: &mut Data) -> Result<Self, AppError> {
        let Some(path) = file else {
            return Ok(Self { model: model.to_owned(), file: None, beyond_terms: None });
        };
        let known = Loaded::read(path)?;
        data.know(&known);
        let file = known.file().clone();
        let beyond_terms = terms::beyond(&known, data.rows.iter().cloned());
        Ok(Self { model: file.model.clone(), file: Some((path.display().to_string(), file)), beyond_terms })
    }

    /// Effects of the model file.
    #[must_use]
    pub fn known(&self) -> &[EffectEntry] {
        self.file.as_ref().map_or(&[], |(_, file)| &file.effects)
    }

    /// What is known, in words: effects, then empirical terms.
    #[must_use]
    pub fn known_words(&self) -> Vec<String> {
        let terms = self.file.iter().flat_map(|(_, file)| &file.empirical);
        let over = |term: &EmpiricalTerm| {
            let over: Vec<&str> = term.over.iter().map(|condition| condition.column()).collect();
            format!("a term over {}", over.join(" and "))
        };
        self.known().iter().map(|known| known.id.to_string()).chain(terms.map(over)).collect()
    }

    /// In words.
    #[must_use]
    pub fn described(&self) -> String {
        let known = self.known_words();
        if known.is_empty() {
            self.model.clone()
        } else {
            format!("{} with {}", self.model, known.join(", "))
        }
    }
}
