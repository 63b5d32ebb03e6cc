use soilctl_kinematics::{JointAngles, JointTorques, JointVelocities, MotorTorques, TaskPose};

use crate::{Events, Mode, SequenceId, TrajectoryKind};

/// What a step wants of the hardware, and what it saw and thought.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Outputs {
    /// The tick that was answered.
    pub tick: u64,
    /// Whether the arm is driven.
    pub mode: Mode,
    /// Whether the amplifiers shall be on.
    pub amplifiers_enabled: bool,
    /// Torques of the motors.
    pub motor_torques: MotorTorques,
    /// The amplifier currents of these torques in A.
    pub motor_currents_a: [f64; 5],
    /// Whether this tick shall be stored.
    pub store: bool,
    /// Number of the stored segment; a new one begins a new file.
    pub storage_segment: u32,
    /// What happened.
    pub events: Events,
    /// What was sensed and wanted.
    pub telemetry: Telemetry,
}

/// What a step saw and thought, for logs and panels.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Telemetry {
    /// Joint angles by the motor encoders.
    pub motor_joints: JointAngles,
    /// Joint angles by the external encoders.
    pub external_joints: JointAngles,
    /// Joint speeds by the motor encoders.
    pub joint_rates: JointVelocities,
    /// Pose by the external encoders, the stretch of the elbow counted in; zero before homing.
    pub pose: TaskPose,
    /// Force of the soil on the plate along r, t, z in N; zero before homing.
    pub force_rtz_n: [f64; 3],
    /// Wanted joint angles.
    pub desired_joints: JointAngles,
    /// Wanted position of the tip under stiffness control in m, else zero.
    pub desired_position_m: [f64; 3],
    /// Joint torques before the transmission.
    pub joint_torques: JointTorques,
    /// Inclination of the plate's force on the soil below the horizontal in rad, in a stroke.
    pub force_inclination_rad: f64,
    /// Wanted inclination in rad, in a stroke.
    pub desired_inclination_rad: f64,
    /// Inclination of the lead (theta_adj) in rad, in a stroke.
    pub lead_inclination_rad: f64,
    /// Lead in m, in a stroke.
    pub lead_m: f64,
    /// Lateral offset of the accommodation in m, in an insertion.
    pub accommodation_m: f64,
    /// The active trajectory.
    pub trajectory: Option<TrajectoryKind>,
    /// The innermost active sequence and its step.
    pub sequence: Option<(SequenceId, u8)>,
}
