use serde::Serialize;
use soilctl_campaign::presets;

/// What a page is told of the sessions that are dug.
#[derive(Debug, Clone, Default, Serialize)]
#[serde(tag = "type", rename = "dig")]
pub(crate) struct DigMessage {
    /// Soils to choose from.
    soils: Vec<SoilItem>,
    /// The one that is dug; empty if no session runs.
    pub(crate) soil: String,
    /// The log that is being written; empty if there is none.
    pub(crate) log: String,
    /// Those that are closed.
    pub(crate) dug: Vec<Dug>,
    /// Why the soil that was chosen last is not dug; empty if it is.
    pub(crate) problem: String,
}

/// A log that is closed.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Dug {
    pub(crate) soil: String,
    pub(crate) log: String,
    pub(crate) steps: u64,
    pub(crate) problems: Vec<String>,
}

#[derive(Debug, Clone, Serialize)]
struct SoilItem {
    name: String,
    title: String,
    gravity_m_s2: f64,
}

impl DigMessage {
    pub(crate) fn new() -> Self {
        let item = |soil: soilctl_campaign::SoilPreset| SoilItem {
            name: soil.name,
            title: soil.title,
            gravity_m_s2: soil.gravity_m_s2,
        };
        Self { soils: presets().into_iter().map(item).collect(), ..Self::default() }
    }
}
