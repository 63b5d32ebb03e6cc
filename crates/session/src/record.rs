use soilctl_controller::{Commands, Outputs, Sensed, State, StrokeSpec};
use soilctl_kinematics::{JointAngles, JointVelocities};

use crate::messages::SoilTruth;

/// Steps between two key frames, and between two flushes of a simulated run.
pub const KEYFRAME_STEPS: u64 = 500;

/// What one step leaves behind. Plain data of fixed size, so that a control thread can hand it on without allocating.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepRecord {
    /// What went in.
    pub sensed: Sensed,
    /// What was wanted.
    pub commands: Commands,
    /// What came out.
    pub outputs: Outputs,
    /// The stroke that sequences make.
    pub stroke: StrokeSpec,
    /// Its number in the plan or sweep, from 0.
    pub stroke_index: u16,
    /// Height of the soil's surface in m.
    pub surface_z_m: f64,
    /// What a simulation knows, when `sensed` was read.
    pub truth: Option<Truth>,
}

impl StepRecord {
    /// The record of a step; `state` as the step left it.
    #[must_use]
    pub fn new(
        sensed: &Sensed,
        commands: &Commands,
        outputs: &Outputs,
        state: &State,
        truth: Option<Truth>,
    ) -> Self {
        Self {
            sensed: *sensed,
            commands: *commands,
            outputs: *outputs,
            stroke: state.machine.stroke,
            stroke_index: state.machine.index,
            surface_z_m: state.surface_z_m,
            truth,
        }
    }
}

/// What a simulation knows and nobody measures.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Truth {
    /// The joints.
    pub joints: JointAngles,
    /// Their speeds.
    pub joint_rates: JointVelocities,
    /// The soil.
    pub soil: SoilTruth,
}

/// What goes from the control thread to the logger.
#[derive(Debug, Clone, Copy)]
#[allow(clippy::large_enum_variant, reason = "both live in a ring of fixed places; a box would allocate")]
pub(crate) enum Entry {
    /// The state before the step of this number.
    Keyframe { step: u64, state: State },
    /// The step of this number.
    Step { step: u64, record: StepRecord },
}
