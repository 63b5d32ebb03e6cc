//! Logs of our own controller: `/controller/step` has all that is needed, the metadata records say what a stroke was.

mod depth;
mod geometry;
mod joints;
mod sample;
mod signals;
mod stroke;
mod surface;

use std::collections::{BTreeMap, VecDeque};

use soilctl_kinematics::Arm;
use soilctl_session::messages::{ControllerStep, decode};
use soilctl_session::read::RawMessage;
use soilctl_session::{CONFIGURATION_RECORD, STROKE_RECORD, topics};

use self::geometry::Edge;
use self::sample::{Phase, Sample, tip_and_sensor};
use self::stroke::{Logged, process};
use super::{LogSettings, LogStroke, NoStroke};
use crate::ProcessError;

/// Kept of the way to a stroke, in s.
const APPROACH_S: f64 = 120.0;
/// Kept while no stroke is near, in s.
const IDLE_S: f64 = 3.0;
/// Kept of a stroke, in s: beyond, it is cut.
const LONGEST_S: f64 = 600.0;
/// Free air is looked for up to this time after a stroke, in s.
const AFTER_S: f64 = 15.0;
/// What the controller does while a hand leads the plate.
const FOLLOW: &str = "follow";
/// Steps in a second if the log does not say.
const USUAL_RATE_HZ: f64 = 500.0;

/// Takes a log's items in order; gives strokes.
pub(super) struct OwnLog {
    arm: Arm,
    tool_weight_n: f64,
    tick_s: f64,
    before: VecDeque<Sample>,
    active: Option<Logged>,
    /// A stroke that is over, but of which free air afterwards is still awaited.
    pending: Option<Logged>,
    surface_m: Option<f64>,
    walls_m: [Option<f64>; 4],
    /// Density that was weighed for the log's batch, in kg/m^3.
    density_kg_m3: Option<f64>,
    /// Batch of the present preparation, strokes in it so far, and their edges.
    batch: Option<String>,
    edges: Vec<[Edge; 2]>,
    found: Vec<LogStroke>,
    refused: Vec<NoStroke>,
    /// Whether the plate was led by hand, and whether the controller made a stroke.
    led: bool,
    has_strokes: bool,
    /// Messages that could not be read.
    pub(super) unreadable: u64,
}

impl OwnLog {
    /// From the records of configuration and session.
    pub(super) fn new(
        configuration: &BTreeMap<String, String>,
        session: &BTreeMap<String, String>,
        tool_weight_n: f64,
    ) -> Result<Self, ProcessError> {
        let rate = session.get("tick_rate_hz").and_then(|text| text.parse().ok());
        let rate_hz = rate.filter(|rate: &f64| rate.is_finite() && *rate > 0.0).unwrap_or(USUAL_RATE_HZ);
        let text = configuration.get("arm").ok_or_else(|| {
            ProcessError::Log(format!("its record {CONFIGURATION_RECORD} has no arm; give --urdf and topics"))
        })?;
        let arm = Arm::from_toml(text, "arm of the log").map_err(ProcessError::arm)?;
        Ok(Self {
            arm,
            tool_weight_n,
            tick_s: 1.0 / rate_hz,
            before: VecDeque::new(),
            active: None,
            pending: None,
            surface_m: None,
            walls_m: [None; 4],
            density_kg_m3: configuration
                .get("density_kg_m3")
                .and_then(|text| text.parse().ok())
                .filter(|density: &f64| density.is_finite() && *density > 0.0),
            batch: None,
            edges: Vec::new(),
            found: Vec::new(),
            refused: Vec::new(),
            led: false,
            has_strokes: false,
            unreadable: 0,
        })
    }

    pub(super) fn message(&mut self, message: &RawMessage<'_>) -> Result<(), ProcessError> {
        match message.channel.topic.as_str() {
            topics::STEP => match decode(message.data) {
                Ok(step) => self.step(&step),
                Err(_) => {
                    self.unreadable += 1;
                    Ok(())
                }
            },
            topics::TF_STATIC => {
                self.surface_m = super::surface_in(message.data).or(self.surface_m);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    pub(super) fn record(&mut self, name: &str, content: &BTreeMap<String, String>) {
        if name != STROKE_RECORD {
            return;
        }
        if let Some(logged) = self.pending.as_mut().or(self.active.as_mut()) {
            logged.record.clone_from(content);
        }
    }

    fn step(&mut self, step: &ControllerStep) -> Result<(), ProcessError> {
        let sample = Sample::new(step, self.tick_s);
        if !sample.is_finite() {
            self.unreadable += 1;
            return Ok(());
        }
        for found in step.events.iter().filter(|event| event.kind == "wall_found") {
            self.wall(found.index, &sample)?;
        }
        self.led |= step.trajectory == FOLLOW;
        if sample.phase == Phase::Stroke {
            self.has_strokes = true;
            self.finish();
            let before = &mut self.before;
            let surface = self.surface_m;
            let logged = self.active.get_or_insert_with(|| Logged {
                approach: before.drain(..).collect(),
                stated_surface_m: surface,
                ..Logged::default()
            });
            if logged.stroke.first().is_none_or(|first| sample.t_s - first.t_s <= LONGEST_S) {
                logged.stroke.push(sample);
            }
            return Ok(());
        }
        if let Some(logged) = self.active.take() {
            self.pending = Some(logged);
        }
        let begins =
            sample.phase == Phase::Bias && self.before.back().is_some_and(|s| s.phase != Phase::Bias);
        if begins {
            self.finish();
            self.before.clear();
        }
        let keep_s = if sample.phase == Phase::Other { IDLE_S } else { APPROACH_S };
        self.before.push_back(sample);
        while self.before.front().is_some_and(|first| sample.t_s - first.t_s > keep_s) {
            self.before.pop_front();
        }
        if let Some(logged) = &mut self.pending {
            logged.after.push(sample);
            let since = logged.stroke.last().map_or(sample.t_s, |last| last.t_s);
            let idle = logged.after.iter().rev().take(150).filter(|s| s.phase == Phase::Other).count() >= 150;
            if idle || sample.t_s - since > AFTER_S {
                self.finish();
            }
        }
        Ok(())
    }

    /// How to look for strokes in a log in which a hand made them and not the controller: as in a recording of any arm, of which this one
    /// tells its soil and its plate.
    pub(super) fn by_hand(&self, settings: &LogSettings) -> Option<LogSettings> {
        (self.led && !self.has_strokes).then(|| LogSettings {
            surface_z_m: settings.surface_z_m.or(self.surface_m),
            width_m: settings.width_m.or(Some(self.arm.config().plate.width_m)),
            ..settings.clone()
        })
    }

    /// Ends the log.
    pub(super) fn end(&mut self) {
        self.finish();
        self.pending = self.active.take();
        self.finish();
    }

    pub(super) fn take(&mut self) -> (Vec<LogStroke>, Vec<NoStroke>) {
        (std::mem::take(&mut self.found), std::mem::take(&mut self.refused))
    }

    fn finish(&mut self) {
        let Some(logged) = self.pending.take() else { return };
        let span = |f: fn(&[Sample]) -> Option<&Sample>| f(&logged.stroke).map_or(0.0, |s| s.t_s);
        let (from_s, to_s) = (span(<[Sample]>::first), span(<[Sample]>::last));
        match process(&self.arm, &logged, self.tool_weight_n) {
            Ok(mut stroke) => {
                self.place(&logged, &mut stroke);
                self.found.push(stroke);
            }
            Err(reason) => {
                self.refused.push(NoStroke { from_s, to_s, reason: reason.to_string(), refused: false });
            }
        }
    }

    /// Order within the batch, and distances to earlier strokes and to walls.
    fn place(&mut self, logged: &Logged, stroke: &mut LogStroke) {
        let batch = logged.record.get("batch").cloned();
        if batch != self.batch || batch.is_none() {
            self.edges.clear();
            self.batch.clone_from(&batch);
        }
        let width_m = self.arm.config().plate.width_m;
        let edge = |sample: Option<&Sample>| {
            let (tip, _) = tip_and_sensor(&self.arm, &sample?.external).ok()?;
            Edge::new([tip.origin_m[0], tip.origin_m[1]], width_m)
        };
        let row = &mut stroke.evaluated.row;
        row.density_kg_m3 = self.density_kg_m3;
        if batch.is_some() {
            row.order = u32::try_from(self.edges.len() + 1).ok();
        }
        if let (Some(first), Some(last)) = (edge(logged.stroke.first()), edge(logged.stroke.last())) {
            let own = [first, last];
            let pairs = self.edges.iter().flatten().flat_map(|old| own.iter().map(|new| old.distance_m(new)));
            row.gap_prior_m = pairs.min_by(f64::total_cmp).filter(|_| batch.is_some());
            row.wall_m =
                own.iter().filter_map(|edge| edge.walls_distance_m(&self.walls_m)).min_by(f64::total_cmp);
            self.edges.push(own);
        }
    }

    fn wall(&mut self, number: u16, sample: &Sample) -> Result<(), ProcessError> {
        let number = usize::from(number);
        let (tip, _) = tip_and_sensor(&self.arm, &sample.external)?;
        let edge = Edge::new([tip.origin_m[0], tip.origin_m[1]], self.arm.config().plate.width_m);
        if let (Some(wall), Some(edge)) = (self.walls_m.get_mut(number), edge) {
            *wall = Some(edge.furthest(number));
        }
        Ok(())
    }
}
