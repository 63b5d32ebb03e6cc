//! Empirical terms of a model file, in words.

use soilctl_effects::Loaded;
use soilctl_strokes::StrokeRow;

/// The conditions of the terms of a file; `None` without terms.
pub(crate) fn conditions(model: &Loaded) -> Option<String> {
    let over: Vec<String> =
        model.file().empirical.iter().flat_map(|term| &term.over).map(ToString::to_string).collect();
    (!over.is_empty()).then(|| over.join(", "))
}

/// That strokes lie beyond those from which the terms were made; `None` if none does.
pub(crate) fn beyond(model: &Loaded, rows: impl Iterator<Item = StrokeRow>) -> Option<String> {
    let told: Vec<bool> = rows.map(|row| model.terms_tell(&row)).collect();
    let beyond = told.iter().filter(|told| !**told).count();
    (beyond > 0).then(|| {
        format!(
            "{beyond} of {} strokes lie beyond those from which the empirical term over {} was made, or do not record it: there the term is held at its edge, \
             or left out, and nobody knows what the force does",
            told.len(),
            conditions(model).unwrap_or_default()
        )
    })
}
