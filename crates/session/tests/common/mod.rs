//! A controller with the plant of its own tests, and a log of what they do.
#![allow(
    dead_code,
    unreachable_pub,
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "helpers of tests; no file uses all of them"
)]

#[path = "../../../controller/tests/common/mod.rs"]
pub mod plant;

use std::io::Write;
use std::path::Path;
use std::sync::{Arc, Mutex};

use plant::{Rig, Soil};
use soilctl_controller::{Params, Request, SequenceId, State, StrokeSpec, Trajectory};
use soilctl_kinematics::{JointAngles, JointVelocities, TaskPose};
use soilctl_session::messages::SoilTruth;
use soilctl_session::{Logger, Pace, Recorder, SessionError, SessionSetup, StepRecord, Truth};

const PLAN: &str = include_str!("../../../../data/plans/table_6_2.toml");

/// Ticks of one insertion, stroke and pull-out with their rests, and the way back.
pub const STROKE_TICKS: u64 = 26_000;
/// When the way back begins.
const BACK: u64 = 24_000;

pub fn setup(seed: u64) -> SessionSetup {
    let params = Params::thesis();
    SessionSetup::new(params.arm().config(), params.config(), PLAN, seed, "springs").unwrap()
}

/// An arm over soft soil that makes one stroke after the other.
pub struct Digger {
    pub rig: Rig,
    start: TaskPose,
    ticks: u64,
}

impl Digger {
    pub fn new(setup: &SessionSetup) -> Self {
        let params = setup.params().unwrap();
        let pose = TaskPose::digging(0.4318, 0.0, -0.3, 80f64.to_radians()).unwrap();
        let start = params.arm().inverse(&pose).unwrap();
        let mut rig = Rig::homed(params, start);
        rig.plant.soil = Some(Soil { failure_n: 12.0 + setup.seed as f64 * 0.01, ..Soil::new() });
        Self { rig, start: pose, ticks: 0 }
    }

    /// One tick, logged. Says whether the log goes on.
    pub fn tick(&mut self, recorder: &mut Recorder) -> bool {
        let mut goes_on = true;
        let StepRecord { sensed, commands, outputs, truth, .. } =
            self.step(|state| goes_on = recorder.before(state));
        recorder.after(&sensed, &commands, &outputs, &self.rig.state, truth) && goes_on
    }

    /// One tick; `before` sees the state that it changes.
    pub fn step(&mut self, before: impl FnOnce(&State)) -> StepRecord {
        let mut commands = self.rig.commands();
        commands.request = match self.ticks % STROKE_TICKS {
            0 => Some(Request::Stroke(StrokeSpec {
                batch: 0,
                radius_m: 0.4318,
                base_rad: 0.0,
                tool_angle_rad: 80f64.to_radians(),
                depth_m: 0.02,
                delta_rad: 0.4,
            })),
            1 => Some(Request::Start(SequenceId::InsertStrokePullout)),
            BACK => Some(Request::Push(Trajectory::CartesianMove { target: self.start })),
            _ => None,
        };
        self.ticks += 1;
        let truth = self.truth();
        let sensed = self.rig.plant.sense();
        before(&self.rig.state);
        let outputs = self.rig.tick_with(&sensed, &commands);
        StepRecord::new(&sensed, &commands, &outputs, &self.rig.state, Some(truth))
    }

    fn truth(&self) -> Truth {
        let plant = &self.rig.plant;
        let joints = JointAngles(plant.q);
        let height_m = plant.arm.forward(&joints).unwrap().z_m;
        let soil = plant.soil.as_ref().unwrap();
        let depth_m = soil.surface_z - height_m;
        let limit_force_n = if depth_m > 0.0 { soil.failure_n } else { 0.0 };
        let soil = SoilTruth { depth_m, limit_force_n, force_rtz_n: plant.force_rtz, ..SoilTruth::default() };
        Truth { joints, joint_rates: JointVelocities(plant.v), soil }
    }
}

/// A simulated run of this many ticks into a file.
pub fn write_log(path: &Path, seed: u64, ticks: u64) {
    let setup = setup(seed);
    let (logger, mut recorder) = Logger::create(path, &setup, Pace::Simulated).unwrap();
    let mut digger = Digger::new(&setup);
    for _ in 0..ticks {
        assert!(digger.tick(&mut recorder));
    }
    drop(recorder);
    let report = logger.finish().unwrap();
    assert_eq!((report.steps, report.dropped_steps), (ticks, 0));
    assert!(digger.rig.state.fault.is_none(), "{:?}", digger.rig.state.fault);
}

/// A sink whose content can be looked at, and which can be made to fail or to wait.
#[derive(Clone, Default)]
pub struct Shelf(pub Arc<Mutex<Content>>);

#[derive(Default)]
pub struct Content {
    pub bytes: Vec<u8>,
    /// Bytes for which there is room, or as many as wanted.
    pub room: Option<usize>,
    /// Whether writing waits.
    pub stuck: bool,
    /// Whether somebody has waited.
    pub waited: bool,
}

impl Write for Shelf {
    fn write(&mut self, data: &[u8]) -> std::io::Result<usize> {
        loop {
            let mut content = self.0.lock().unwrap();
            if content.stuck {
                content.waited = true;
                drop(content);
                std::thread::sleep(std::time::Duration::from_millis(1));
                continue;
            }
            let left = content.room.map_or(data.len(), |room| room - content.bytes.len());
            if left == 0 && !data.is_empty() {
                return Err(std::io::Error::new(std::io::ErrorKind::StorageFull, "no space left on device"));
            }
            let taken = left.min(data.len());
            content.bytes.extend_from_slice(&data[..taken]);
            return Ok(taken);
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The error of a log that could not be written.
pub fn write_error(result: Result<soilctl_session::LogReport, SessionError>) -> (u64, String) {
    match result {
        Err(SessionError::Write { steps, reason }) => (steps, reason),
        other => panic!("{other:?}"),
    }
}
