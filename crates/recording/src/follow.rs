//! Follows a log from beginning to end and writes what each message shows.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use soilctl_controller::{Params, StrokePlan};
use soilctl_kinematics::{Arm, JointAngles};
use soilctl_live::protocol::{Memory, SafeForce, StateMessage};
use soilctl_robot::Urdf;
use soilctl_session::messages::{
    ControllerStep, JointState, SoilTruth, StringMessage, TfMessage, WrenchStamped, decode,
};
use soilctl_session::read::{Item, RawMessage};
use soilctl_session::{CONFIGURATION_RECORD, SESSION_RECORD, STROKE_RECORD, SessionError, topics};

use crate::about::about;
use crate::rrd::{WriteError, Writer};
use crate::safe_force;
use crate::shapes::shapes;
use crate::style::{TRUE_DEPTH, styles};
use crate::{FORCE_M_PER_N, LEAD_SCALE, Recording, RecordingError, rows, sandbox, unwritten};

const STATES: [&str; 3] = ["/state/mode", "/state/trajectory", "/state/sequence"];

/// Links above a link that its entity names; no arm of ours has so many.
const MOST_DEPTH: usize = 100;

type Record = BTreeMap<String, String>;

/// What is known so far.
pub(crate) struct Follower {
    writer: Writer<BufWriter<File>>,
    log: PathBuf,
    out: PathBuf,
    session: Record,
    strokes: Vec<Record>,
    arm: Option<Arm>,
    safe_force: SafeForce,
    /// Entities of the frames.
    frames: BTreeMap<String, String>,
    joints: JointAngles,
    true_joints: JointAngles,
    memory: Memory,
    states: [Option<String>; 3],
    in_stroke: bool,
    counts: BTreeMap<&'static str, u64>,
    span_s: Option<[f64; 2]>,
}

impl Follower {
    pub(crate) fn new(
        writer: Writer<BufWriter<File>>,
        log: &Path,
        out: &Path,
    ) -> Result<Self, RecordingError> {
        let mut follower = Self {
            writer,
            log: log.to_owned(),
            out: out.to_owned(),
            session: Record::new(),
            strokes: Vec::new(),
            arm: None,
            safe_force: SafeForce::default(),
            frames: BTreeMap::new(),
            joints: JointAngles::default(),
            true_joints: JointAngles::default(),
            memory: Memory::default(),
            states: [const { None }; 3],
            in_stroke: false,
            counts: BTreeMap::new(),
            span_s: None,
        };
        let name = follower.name();
        styles(&mut follower.writer, &name).map_err(|error| unwritten(out, &error))?;
        Ok(follower)
    }

    fn name(&self) -> String {
        self.log.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    }

    fn file(&self) -> String {
        self.log.display().to_string()
    }

    /// Takes in what the log has next.
    pub(crate) fn item(&mut self, item: Item<'_>) -> Result<(), RecordingError> {
        match item {
            Item::Metadata { name: SESSION_RECORD, content } => self.session.clone_from(content),
            Item::Metadata { name: STROKE_RECORD, content } => self.strokes.push(content.clone()),
            Item::Metadata { name: CONFIGURATION_RECORD, content } => {
                let text = |key: &str| content.get(key).map_or("", String::as_str);
                let arm = Arm::from_toml(text("arm"), "arm").map_err(|error| self.wrong_arm(&error))?;
                let settings = text("controller");
                let params = Params::from_toml(arm.clone(), settings, "controller", StrokePlan::default());
                if let Ok(params) = &params {
                    let settings = params.config();
                    self.safe_force = safe_force::of_settings(settings);
                    let sand = sandbox::boxes(text("plan"), settings.site.surface_z_m);
                    self.writer
                        .fixed(sandbox::ENTITY, &sand)
                        .map_err(|error| unwritten(&self.out, &error))?;
                }
                self.arm = Some(arm);
            }
            // A log of another program may have topics of these names and other types.
            Item::Message(message) if self.arm.is_some() => self.message(&message)?,
            _ => {}
        }
        Ok(())
    }

    fn wrong_arm(&self, error: &dyn std::fmt::Display) -> RecordingError {
        RecordingError::Arm { file: self.file(), reason: error.to_string() }
    }

    fn message(&mut self, message: &RawMessage<'_>) -> Result<(), RecordingError> {
        let time_ns = i64::try_from(message.log_time_ns).unwrap_or(i64::MAX);
        let done = match message.channel.topic.as_str() {
            topics::ROBOT_DESCRIPTION => {
                let text: StringMessage = self.read(topics::ROBOT_DESCRIPTION, message)?;
                let urdf = Urdf::parse(&text.data).map_err(|error| self.wrong_arm(&error))?;
                self.robot(&urdf)
            }
            topics::TF => {
                let frames: TfMessage = self.read(topics::TF, message)?;
                self.frames(time_ns, &frames)
            }
            topics::TF_STATIC => {
                let frames: TfMessage = self.read(topics::TF_STATIC, message)?;
                self.frames(time_ns, &frames)
            }
            topics::JOINT_STATES => {
                let state: JointState = self.read(topics::JOINT_STATES, message)?;
                self.joint_state(time_ns, &state)
            }
            topics::WRENCH => {
                let wrench: WrenchStamped = self.read(topics::WRENCH, message)?;
                self.wrench(time_ns, &wrench)
            }
            topics::STEP => {
                let step: ControllerStep = self.read(topics::STEP, message)?;
                self.step(time_ns, &step)
            }
            topics::TRUE_JOINTS => {
                let state: JointState = self.read(topics::TRUE_JOINTS, message)?;
                self.true_joints = five(&state.position);
                Ok(())
            }
            topics::TRUE_SOIL => {
                let soil = self.read_with(topics::TRUE_SOIL, message, SoilTruth::read)?;
                self.true_soil(time_ns, &soil)
            }
            _ => Ok(()),
        };
        done.map_err(|error| unwritten(&self.out, &error))
    }

    fn read<T: DeserializeOwned>(
        &mut self,
        topic: &'static str,
        message: &RawMessage<'_>,
    ) -> Result<T, SessionError> {
        self.read_with(topic, message, decode)
    }

    fn read_with<T>(
        &mut self,
        topic: &'static str,
        message: &RawMessage<'_>,
        decode: impl Fn(&[u8]) -> Result<T, String>,
    ) -> Result<T, SessionError> {
        let count = self.counts.entry(topic).or_default();
        let number = *count;
        *count += 1;
        decode(message.data).map_err(|reason| SessionError::Message {
            topic: topic.to_owned(),
            number,
            reason,
        })
    }

    /// Each link has an entity below that of the link that it hangs on.
    fn robot(&mut self, urdf: &Urdf) -> Result<(), WriteError> {
        let above = |link: &usize| Some(urdf.joints().get(urdf.joint_above(*link)?)?.parent);
        for (place, link) in urdf.links().iter().enumerate() {
            let way: Vec<usize> = std::iter::successors(Some(place), above).take(MOST_DEPTH).collect();
            let names = way.iter().rev().filter_map(|place| Some(&urdf.links().get(*place)?.name));
            let entity = names.fold("/world".to_owned(), |path, name| format!("{path}/{name}"));
            for (name, columns) in shapes(link, &BTreeMap::new()) {
                self.writer.fixed(&format!("{entity}/{name}"), &columns)?;
            }
            self.frames.insert(link.name.clone(), entity);
        }
        Ok(())
    }

    fn frames(&mut self, time_ns: i64, message: &TfMessage) -> Result<(), WriteError> {
        for frame in &message.transforms {
            let (parent, child) = (&frame.header.frame_id, &frame.child_frame_id);
            let above = self.frames.get(parent).cloned().unwrap_or_else(|| format!("/world/{parent}"));
            let entity = self.frames.entry(child.clone()).or_insert_with(|| format!("{above}/{child}"));
            let (t, q) = (frame.transform.translation, frame.transform.rotation);
            self.writer.row(entity, time_ns, rows::transform([t.x, t.y, t.z], [q.x, q.y, q.z, q.w]))?;
        }
        Ok(())
    }

    fn joint_state(&mut self, time_ns: i64, state: &JointState) -> Result<(), WriteError> {
        self.joints = five(&state.position);
        self.writer.row("/joints/position", time_ns, rows::curves(&self.joints.degrees()))?;
        self.writer.row("/joints/torque", time_ns, rows::curves(&state.effort))
    }

    /// The sensor's force as it is read, turned into the frame of the base.
    fn wrench(&mut self, time_ns: i64, message: &WrenchStamped) -> Result<(), WriteError> {
        let force = message.wrench.force;
        let force = [force.x, force.y, force.z];
        self.writer.row("/force_sensor", time_ns, rows::curves(&force))?;
        let frames = self.arm.as_ref().and_then(|arm| arm.frames(&self.joints).ok());
        let arrow = frames.map_or(NO_ARROW, |frames| {
            (frames.plate_tip.origin_m, scaled(frames.ft_sensor.direction(force), FORCE_M_PER_N))
        });
        self.writer.row("/world/force/sensor", time_ns, rows::arrow(arrow.0, arrow.1))
    }

    fn step(&mut self, time_ns: i64, step: &ControllerStep) -> Result<(), WriteError> {
        self.memory.step(step);
        let state = StateMessage::new(step, &self.memory);
        let first_s = self.span_s.map_or(state.time_s, |[first_s, _]| first_s);
        self.span_s = Some([first_s, state.time_s]);
        let joints = JointAngles(step.external_joints_rad);
        let (tip, force) = self.force(&joints, step.force_rtz_n);
        self.writer.row("/world/force/plate", time_ns, rows::arrow(tip, force))?;
        self.writer.row("/force/plate", time_ns, rows::curves(&step.force_rtz_n))?;
        if let Some(plate) = state.plate {
            self.writer.row("/height", time_ns, rows::curves(&[plate.z_m * 1e3]))?;
        }
        self.stroke(time_ns, &state, &joints)?;
        let now = [Some(state.mode), state.trajectory, state.sequence];
        for ((entity, before), now) in STATES.iter().zip(&mut self.states).zip(now) {
            if *before != now {
                self.writer.row(entity, time_ns, rows::state(now.as_deref()))?;
                *before = now;
            }
        }
        for event in &step.events {
            let level = match event.kind.split('/').next() {
                Some("fault") => "ERROR",
                Some("sequence_failed") => "WARN",
                _ => "INFO",
            };
            let text = format!("{} {} {} {}", event.kind, event.index, event.value, event.limit);
            self.writer.row("/events", time_ns, rows::line(level, &text))?;
        }
        Ok(())
    }

    /// Curves that only strokes have; a row without values ends them, so that no line joins two strokes.
    fn stroke(&mut self, time_ns: i64, state: &StateMessage, joints: &JointAngles) -> Result<(), WriteError> {
        let lead = state.lead_m.zip(state.lead_inclination_deg);
        let values = state.friction_angle_deg.zip(state.friction_setpoint_deg).zip(lead);
        let Some(((angle_deg, setpoint_deg), (lead_m, inclination_deg))) = values else {
            if std::mem::take(&mut self.in_stroke) {
                self.writer.row("/friction_angle", time_ns, rows::curves(&[]))?;
                self.writer.row("/displacement", time_ns, rows::curves(&[]))?;
                self.writer.row("/world/lead", time_ns, rows::arrow([f64::NAN; 3], [0.0; 3]))?;
                self.safe_area(time_ns, &[])?;
            }
            return Ok(());
        };
        if !std::mem::replace(&mut self.in_stroke, true) {
            let plate = self.arm.as_ref().zip(state.plate.as_ref());
            let fan = plate.and_then(|(arm, plate)| {
                safe_force::fan(&self.safe_force, arm, joints, plate.tool_angle_deg)
            });
            self.safe_area(time_ns, &fan.unwrap_or_default())?;
        }
        self.writer.row("/friction_angle", time_ns, rows::curves(&[angle_deg, setpoint_deg]))?;
        let displacement_m = state.displacement_m.unwrap_or(f64::NAN);
        self.writer.row("/displacement", time_ns, rows::curves(&[displacement_m * 1e3, lead_m * 1e3]))?;
        let (sin, cos) = inclination_deg.to_radians().sin_cos();
        let (tip, lead) = self.vector(joints, [-lead_m * cos, 0.0, -lead_m * sin]);
        self.writer.row("/world/lead", time_ns, rows::arrow(tip, scaled(lead, LEAD_SCALE)))
    }

    /// Forces that the soil bears safely, as an area that hangs on the plate; none without corners.
    fn safe_area(&mut self, time_ns: i64, fan: &[[f64; 3]]) -> Result<(), WriteError> {
        let Some(plate) = self.frames.get(safe_force::LINK) else { return Ok(()) };
        self.writer.row(&format!("{plate}/safe_force"), time_ns, rows::fan(fan))
    }

    fn true_soil(&mut self, time_ns: i64, soil: &SoilTruth) -> Result<(), WriteError> {
        let (tip, force) = self.force(&self.true_joints, soil.force_rtz_n);
        self.writer.row("/world/force/truth", time_ns, rows::arrow(tip, force))?;
        self.writer.row("/force/truth", time_ns, rows::curves(&soil.force_rtz_n))?;
        let limits = [soil.limit_force_n, soil.limit_force_now_n];
        // Early logs have only the first.
        let known = if limits[1].is_finite() { &limits[..] } else { &limits[..1] };
        self.writer.row("/force/limit", time_ns, rows::curves(known))?;
        self.writer.row(TRUE_DEPTH.0, time_ns, rows::curves(&[soil.depth_m * 1e3]))
    }

    /// The plate's tip and a force there as an arrow of its length.
    fn force(&self, joints: &JointAngles, rtz_n: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let (tip, force) = self.vector(joints, rtz_n);
        (tip, scaled(force, FORCE_M_PER_N))
    }

    /// The plate's tip and a vector along r, t, z, both in the frame of the base; not finite at joints that are not.
    fn vector(&self, joints: &JointAngles, rtz: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let Some(arm) = &self.arm else { return NO_ARROW };
        match (arm.frames(joints), arm.at(joints)) {
            (Ok(frames), Ok(arm)) => (frames.plate_tip.origin_m, arm.rtz_to_base(rtz)),
            _ => NO_ARROW,
        }
    }

    /// Writes the rest.
    pub(crate) fn finish(mut self, damage: Vec<String>) -> Result<Recording, RecordingError> {
        let not_ours = |what| RecordingError::NotOurs { file: self.log.display().to_string(), what };
        if self.arm.is_none() {
            return Err(not_ours("record of the configuration"));
        }
        let span_s = self.span_s.ok_or_else(|| not_ours("step of the controller"))?;
        let page = about(&self.name(), &self.session, &self.strokes, &damage);
        let steps = self.counts.get(topics::STEP).copied().unwrap_or(0);
        let out = self.out.clone();
        let written = self.writer.fixed("/about", &rows::page(&page)).and_then(|()| self.writer.finish());
        let entities = written.map_err(|error| unwritten(&out, &error))?;
        Ok(Recording { entities, steps, span_s, damage, foreign: None })
    }
}

const NO_ARROW: ([f64; 3], [f64; 3]) = ([f64::NAN; 3], [f64::NAN; 3]);

fn scaled(vector: [f64; 3], by: f64) -> [f64; 3] {
    vector.map(|part| part * by)
}

/// Joints that a message does not have are not finite.
fn five(position: &[f64]) -> JointAngles {
    JointAngles(std::array::from_fn(|joint| position.get(joint).copied().unwrap_or(f64::NAN)))
}
