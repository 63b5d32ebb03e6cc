use std::path::Path;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_recording::Recording;

use crate::output::Words;
use soilctl_app::text::{columns, number};

/// What was made of a log.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ViewAnswer {
    /// The recording.
    recording: String,
    /// The layout for Foxglove; null if none was asked for.
    foxglove_layout: Option<String>,
    /// The viewer that was started; null if none was.
    viewer: Option<String>,
    /// Steps of the controller in the log.
    steps: u64,
    /// Log time of the first step in s.
    start_s: f64,
    /// Log time of the last step in s.
    end_s: f64,
    /// What the recording shows over time.
    entities: Vec<Entity>,
    /// What is wrong with the log; empty if it is whole.
    damage: Vec<String>,
}

/// An entity of the recording.
#[derive(Debug, Serialize, JsonSchema)]
struct Entity {
    /// Its path.
    entity: String,
    /// Its rows.
    rows: u64,
}

impl ViewAnswer {
    pub(super) fn new(
        recording: Recording,
        out: &Path,
        layout: Option<&Path>,
        viewer: Option<String>,
    ) -> Self {
        let [start_s, end_s] = recording.span_s;
        Self {
            recording: out.display().to_string(),
            foxglove_layout: layout.map(|path| path.display().to_string()),
            viewer,
            steps: recording.steps,
            start_s,
            end_s,
            entities: recording.entities.into_iter().map(|(entity, rows)| Entity { entity, rows }).collect(),
            damage: recording.damage,
        }
    }
}

impl soilctl_app::Answer for ViewAnswer {
    const SCHEMA: &'static str = "soilctl.view/1";
}

impl Words for ViewAnswer {
    fn text(&self) -> String {
        let mut text = format!("recording: {}\n", self.recording);
        if let Some(layout) = &self.foxglove_layout {
            text += &format!("layout for Foxglove: {layout}\n");
        }
        if let Some(viewer) = &self.viewer {
            text += &format!("opened with: {viewer}\n");
        }
        text += &format!("{} steps, {} to {} s\n", self.steps, number(self.start_s), number(self.end_s));
        let rows = self.entities.iter().map(|entity| vec![entity.rows.to_string(), entity.entity.clone()]);
        text + &columns(&rows.collect::<Vec<_>>())
    }
}
