use std::collections::BTreeMap;
use std::io::{BufWriter, Write};

use mcap::records::{MessageHeader, Metadata};
use mcap::write::NoSeek;
use mcap::{Attachment, Compression, McapError, WriteOptions};
use serde::Serialize;
use soilctl_controller::{EventKind, Params};
use soilctl_kinematics::{Joint, JointAngles, JointVelocities, urdf};

use crate::error::reason;
use crate::messages::{
    ControllerStep, Header, JointState, Keyframe, StringMessage, Time, Wrench, WrenchStamped, definition,
};
use crate::record::Entry;
use crate::setup::Content;
use crate::setup::{CONFIGURATION_RECORD, END_RECORD, SESSION_RECORD, STROKE_RECORD, SessionSetup};
use crate::strokes::Strokes;
use crate::{SessionError, StepRecord, Truth, cdr, frames, topics};

/// Nanoseconds of one tick.
const TICK_NS: u64 = 2_000_000;
/// Steps between two messages on `/tf`: 50 a second are enough for a picture, and frames follow from the joints.
const TF_STEPS: u64 = 10;
/// Name of the URDF among the attachments.
pub(crate) const URDF_NAME: &str = "robot.urdf";

/// The profile of rosbag2, as in the header of a log.
pub(crate) const PROFILE: &str = "ros2";
/// How messages are encoded.
pub(crate) const MESSAGE_ENCODING: &str = "cdr";
/// How schemas are written.
pub(crate) const SCHEMA_ENCODING: &str = "ros2msg";

/// Options of every file that this crate writes. Chunks end where the file is flushed, are compressed by this thread
/// alone and are written in one go, so that the bytes depend on nothing but the content and a killed process leaves no
/// half of a chunk that looks whole.
pub(crate) fn options() -> WriteOptions {
    WriteOptions::new()
        .profile(PROFILE)
        .library(concat!("soilctl ", env!("CARGO_PKG_VERSION")))
        .compression(Some(Compression::Zstd))
        .compression_threads(0)
        .chunk_size(None)
        .disable_seeking(true)
}

/// Writes a log: steps in, MCAP out. [`Logger`](crate::Logger) runs one in a thread of its own.
pub struct LogWriter<W: Write> {
    file: mcap::Writer<NoSeek<BufWriter<W>>>,
    params: Params,
    channels: [u16; topics::ALL.len()],
    counts: [u32; topics::ALL.len()],
    buffer: Vec<u8>,
    strokes: Strokes,
    keyframes: u32,
    steps: u64,
    log_time: u64,
    surface_z_m: Option<f64>,
    content: Content,
}

impl<W: Write> LogWriter<W> {
    /// Begins a log: settings, channels, URDF.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the sink fails, or what [`SessionSetup::params`] says.
    pub fn new(sink: W, setup: &SessionSetup) -> Result<Self, SessionError> {
        let params = setup.params()?;
        let refused = |error: &McapError| SessionError::Write { steps: 0, reason: reason(error) };
        let mut file =
            options().create(NoSeek::new(BufWriter::new(sink))).map_err(|error| refused(&error))?;
        for (name, metadata) in
            [(SESSION_RECORD, setup.session_record()), (CONFIGURATION_RECORD, setup.configuration_record())]
        {
            file.write_metadata(&Metadata { name: name.to_owned(), metadata })
                .map_err(|error| refused(&error))?;
        }
        let robot = urdf(params.arm());
        let attachment = Attachment {
            log_time: 0,
            create_time: 0,
            name: URDF_NAME.to_owned(),
            media_type: "application/xml".to_owned(),
            data: robot.as_bytes().into(),
        };
        file.attach(&attachment).map_err(|error| refused(&error))?;
        let mut channels = [0; topics::ALL.len()];
        for (channel, topic) in channels.iter_mut().zip(topics::ALL) {
            let schema = definition(topic.message_type).unwrap_or_default();
            *channel = file
                .add_schema(topic.message_type, SCHEMA_ENCODING, schema.as_bytes())
                .and_then(|id| file.add_channel(id, topic.name, MESSAGE_ENCODING, &topic.metadata()))
                .map_err(|error| refused(&error))?;
        }
        let mut writer = Self {
            file,
            params,
            channels,
            counts: [0; topics::ALL.len()],
            buffer: Vec::new(),
            strokes: Strokes::default(),
            keyframes: 0,
            steps: 0,
            log_time: 0,
            surface_z_m: None,
            content: setup.content,
        };
        writer.message(topics::ROBOT_DESCRIPTION, &StringMessage { data: robot })?;
        let surface_z_m = writer.params.config().site.surface_z_m;
        writer.surface(surface_z_m)?;
        Ok(writer)
    }

    /// The parameters that a controller must run with so that the log can be replayed.
    #[must_use]
    pub const fn params(&self) -> &Params {
        &self.params
    }

    /// Writes the state before step `step`, from which a replay can begin.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the sink fails.
    pub fn keyframe(&mut self, step: u64, state: &soilctl_controller::State) -> Result<(), SessionError> {
        let message = Keyframe::new(self.keyframes, step, state)?;
        self.keyframes = self.keyframes.saturating_add(1);
        self.message(topics::KEYFRAME, &message)
    }

    /// Writes one step; `number` counts the calls of the controller from 0.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the sink fails.
    pub fn step(&mut self, number: u64, record: &StepRecord) -> Result<(), SessionError> {
        self.advance_time(record.outputs.tick);
        self.steps = self.steps.saturating_add(1);
        let StepRecord { sensed, commands, outputs, .. } = record;
        self.message(topics::STEP, &ControllerStep::new(number, sensed, commands, outputs))?;
        if self.content == Content::Whole {
            self.derived(number, record)?;
        }
        let found = outputs.events.as_slice().iter().any(|event| event.kind == EventKind::SurfaceFound);
        if found && self.surface_z_m.map(f64::to_bits) != Some(record.surface_z_m.to_bits()) {
            self.surface(record.surface_z_m)?;
        }
        if let (Content::Whole, Some(truth)) = (self.content, &record.truth) {
            self.truth(truth)?;
        }
        match self.strokes.step(record) {
            Some(stroke) => self.metadata(STROKE_RECORD, stroke),
            None => Ok(()),
        }
    }

    /// What follows from a step, for tools that know nothing of controllers.
    fn derived(&mut self, number: u64, record: &StepRecord) -> Result<(), SessionError> {
        let StepRecord { sensed, outputs, .. } = record;
        let seen = &outputs.telemetry;
        let joints = self.joint_state(
            &Joint::ALL.map(Joint::name),
            &seen.external_joints.0,
            &seen.joint_rates.0,
            &seen.joint_torques.0,
        );
        self.message(topics::JOINT_STATES, &joints)?;
        let motors = self.motors(record);
        self.message(topics::MOTOR_STATES, &motors)?;
        let [x, y, z, mx, my, mz] = sensed.wrench;
        let wrench = Wrench { force: [x, y, z].into(), torque: [mx, my, mz].into() };
        let header = self.header(frames::SENSOR);
        self.message(topics::WRENCH, &WrenchStamped { header, wrench })?;
        if number.is_multiple_of(TF_STEPS)
            && let Ok(transforms) = frames::moving(self.params.arm(), &seen.external_joints, self.stamp())
        {
            self.message(topics::TF, &transforms)?;
        }
        Ok(())
    }

    /// Ends the chunk and hands everything to the system: what was written until here survives a kill.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the sink fails.
    pub fn flush(&mut self) -> Result<(), SessionError> {
        self.file.flush().map_err(|error| self.failed(&error))
    }

    /// Ends the log: boundaries of an unfinished stroke, how many steps are missing, the summary with its indexes.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the sink fails.
    pub fn finish(self, dropped_steps: u64) -> Result<(), SessionError> {
        self.finish_with(dropped_steps, BTreeMap::new())
    }

    /// As [`LogWriter::finish`], with texts of one's own by name in the end record. Names of its own keys are not to be
    /// used.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the sink fails.
    pub fn finish_with(
        mut self,
        dropped_steps: u64,
        notes: BTreeMap<String, String>,
    ) -> Result<(), SessionError> {
        if let Some(stroke) = self.strokes.finish("end of log") {
            self.metadata(STROKE_RECORD, stroke)?;
        }
        let mut end = notes;
        for (key, value) in [("steps", self.steps), ("dropped_steps", dropped_steps)] {
            end.insert(key.to_owned(), value.to_string());
        }
        self.metadata(END_RECORD, end)?;
        self.file.finish().map(|_| ()).map_err(|error| self.failed(&error))
    }

    /// Steps written.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.steps
    }

    pub(crate) fn entry(&mut self, entry: &Entry) -> Result<(), SessionError> {
        match entry {
            Entry::Keyframe { step, state } => self.keyframe(*step, state),
            Entry::Step { step, record } => self.step(*step, record),
        }
    }

    /// Log time is that of the tick. A tick that no arm reaches (68 years) is a fault of the hardware and is logged at
    /// the time of the one before.
    fn advance_time(&mut self, tick: u64) {
        if let Some(time) = tick.checked_mul(TICK_NS)
            && i32::try_from(time / 1_000_000_000).is_ok()
        {
            self.log_time = self.log_time.max(time);
        }
    }

    fn stamp(&self) -> Time {
        let sec = i32::try_from(self.log_time / 1_000_000_000).unwrap_or(i32::MAX);
        Time { sec, nanosec: u32::try_from(self.log_time % 1_000_000_000).unwrap_or(0) }
    }

    fn header(&self, frame: &str) -> Header {
        Header { stamp: self.stamp(), frame_id: frame.to_owned() }
    }

    fn joint_state(
        &self,
        names: &[&str; 5],
        position: &[f64],
        velocity: &[f64],
        effort: &[f64],
    ) -> JointState {
        JointState {
            header: self.header(frames::BASE),
            name: names.iter().map(|&name| name.to_owned()).collect(),
            position: position.to_vec(),
            velocity: velocity.to_vec(),
            effort: effort.to_vec(),
        }
    }

    /// Where the transmission has no answer, because an encoder went mad, position and speed are left out.
    fn motors(&self, record: &StepRecord) -> JointState {
        let map = self.params.arm().transmission();
        let seen = &record.outputs.telemetry;
        let joints: &JointAngles = &seen.motor_joints;
        let rates: &JointVelocities = &seen.joint_rates;
        let position = map.motor_angles(joints).map(|angles| angles.0.to_vec()).unwrap_or_default();
        let velocity = map.motor_velocities(rates).map(|rates| rates.0.to_vec()).unwrap_or_default();
        let names = ["motor_base", "motor_shoulder", "motor_elbow_a", "motor_elbow_b", "motor_wrist"];
        self.joint_state(&names, &position, &velocity, &record.outputs.motor_torques.0)
    }

    fn truth(&mut self, truth: &Truth) -> Result<(), SessionError> {
        let joints =
            self.joint_state(&Joint::ALL.map(Joint::name), &truth.joints.0, &truth.joint_rates.0, &[]);
        self.message(topics::TRUE_JOINTS, &joints)?;
        self.message(topics::TRUE_SOIL, &truth.soil)
    }

    fn surface(&mut self, surface_z_m: f64) -> Result<(), SessionError> {
        self.surface_z_m = Some(surface_z_m);
        let transforms = frames::fixed(self.params.arm(), surface_z_m, self.stamp())?;
        self.message(topics::TF_STATIC, &transforms)
    }

    fn message<T: Serialize>(&mut self, topic: &str, message: &T) -> Result<(), SessionError> {
        let Some(place) = topics::ALL.iter().position(|known| known.name == topic) else { return Ok(()) };
        cdr::encode(message, &mut self.buffer)
            .map_err(|error| SessionError::Write { steps: self.steps, reason: error.to_string() })?;
        let header = MessageHeader {
            channel_id: self.channels[place],
            sequence: self.counts[place],
            log_time: self.log_time,
            publish_time: self.log_time,
        };
        self.counts[place] = self.counts[place].wrapping_add(1);
        self.file.write_to_known_channel(&header, &self.buffer).map_err(|error| self.failed(&error))
    }

    fn metadata(&mut self, name: &str, metadata: BTreeMap<String, String>) -> Result<(), SessionError> {
        let record = Metadata { name: name.to_owned(), metadata };
        self.file.write_metadata(&record).map_err(|error| self.failed(&error))
    }

    fn failed(&self, error: &McapError) -> SessionError {
        SessionError::Write { steps: self.steps, reason: reason(error) }
    }
}
