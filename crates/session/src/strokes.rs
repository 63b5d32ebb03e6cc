use std::collections::BTreeMap;

use soilctl_controller::{EventKind, Mode, TICK_S, TrajectoryKind};

use crate::StepRecord;
use crate::messages::word;

/// Finds where strokes begin and end, for the metadata of a log.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    found: u32,
    active: Option<Active>,
}

#[derive(Debug)]
struct Active {
    /// Everything but the end.
    record: BTreeMap<String, String>,
    /// The last tick of the stroke.
    last_tick: u64,
}

impl Strokes {
    /// Looks at one step: the record of a stroke that is over.
    pub(crate) fn step(&mut self, step: &StepRecord) -> Option<BTreeMap<String, String>> {
        let outputs = &step.outputs;
        let mut finish = None;
        let mut begins = false;
        for event in outputs.events.as_slice() {
            match event.kind {
                EventKind::TrajectoryEnded(TrajectoryKind::Stroke, how) => finish = Some(word(&how)),
                EventKind::TrajectoryStarted(TrajectoryKind::Stroke) => begins = true,
                _ => {}
            }
        }
        let running = outputs.telemetry.trajectory == Some(TrajectoryKind::Stroke);
        let over = self.active.is_some() && (begins || !running);
        let done = if over {
            let how = finish.unwrap_or_else(|| {
                if outputs.mode == Mode::Fault { "fault".to_owned() } else { "aborted".to_owned() }
            });
            self.finish(&how)
        } else {
            None
        };
        if running {
            match &mut self.active {
                Some(active) => active.last_tick = outputs.tick,
                None => self.begin(step),
            }
        }
        done
    }

    /// The record of a stroke that the end of the log cuts.
    pub(crate) fn finish(&mut self, how: &str) -> Option<BTreeMap<String, String>> {
        let Active { mut record, last_tick } = self.active.take()?;
        record.insert("end_tick".to_owned(), last_tick.to_string());
        record.insert("end_s".to_owned(), seconds(last_tick));
        record.insert("finish".to_owned(), how.to_owned());
        Some(record)
    }

    fn begin(&mut self, step: &StepRecord) {
        let tick = step.outputs.tick;
        let mut record = BTreeMap::new();
        let mut put = |key: &str, value: String| {
            record.insert(key.to_owned(), value);
        };
        put("number", self.found.to_string());
        put("start_tick", tick.to_string());
        put("start_s", seconds(tick));
        // A stroke that was commanded by itself is none of a plan.
        if step.outputs.telemetry.sequence.is_some() {
            let spec = &step.stroke;
            put("plan_index", step.stroke_index.to_string());
            put("batch", spec.batch.to_string());
            put("radius_m", spec.radius_m.to_string());
            put("base_deg", spec.base_rad.to_degrees().to_string());
            put("alpha_deg", spec.tool_angle_rad.to_degrees().to_string());
            put("depth_m", spec.depth_m.to_string());
            put("delta_set_deg", spec.delta_rad.to_degrees().to_string());
        }
        self.found = self.found.saturating_add(1);
        self.active = Some(Active { record, last_tick: tick });
    }
}

#[allow(clippy::cast_precision_loss, reason = "exact below 2^53 ticks")]
fn seconds(tick: u64) -> String {
    (tick as f64 * TICK_S).to_string()
}
