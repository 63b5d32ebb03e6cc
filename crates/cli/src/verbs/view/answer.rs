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
    /// States of the arm that are shown; only of another program's recording.
    #[serde(skip_serializing_if = "Option::is_none")]
    states: Option<usize>,
    /// Where times begin, in s of the stamps; only of another program's recording.
    #[serde(skip_serializing_if = "Option::is_none")]
    clock_origin_s: Option<i64>,
    /// What was odd, or could not be used; only of another program's recording.
    #[serde(skip_serializing_if = "Option::is_none")]
    notes: Option<Vec<String>>,
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
        let foreign = recording.foreign;
        Self {
            recording: out.display().to_string(),
            foxglove_layout: layout.map(|path| path.display().to_string()),
            viewer,
            steps: recording.steps,
            start_s,
            end_s,
            states: foreign.as_ref().map(|foreign| foreign.states),
            clock_origin_s: foreign.as_ref().map(|foreign| foreign.clock_origin_s),
            notes: foreign.map(|foreign| foreign.notes),
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
        let what = match self.states {
            Some(states) => format!("{states} states"),
            None => format!("{} steps", self.steps),
        };
        text += &format!("{what}, {} to {} s\n", number(self.start_s), number(self.end_s));
        let rows = self.entities.iter().map(|entity| vec![entity.rows.to_string(), entity.entity.clone()]);
        text + &columns(&rows.collect::<Vec<_>>())
    }
}
