use serde::{Deserialize, Serialize};

/// Limits whose breach leads to the safe state. In brackets the unit of an event's value and limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Fault {
    /// The emergency stop was pressed.
    EmergencyStop,
    /// The operator's heartbeat stopped (ticks).
    Watchdog,
    /// Ticks were missed, or did not rise (ticks).
    DroppedTicks,
    /// The motor encoders fell silent (ticks).
    MotorEncoderStale,
    /// The external encoders fell silent (ticks).
    ExternalEncoderStale,
    /// The force sensor fell silent (ticks).
    ForceStale,
    /// The force sensor reports new readings without any noise (ticks).
    ForceFrozen,
    /// The amplifiers' readings fell silent (ticks).
    AmplifierStale,
    /// A channel of the force sensor is not a number.
    ForceNotFinite,
    /// An amplifier's reading is not a number.
    AmplifierNotFinite,
    /// The force sensor is out of its range (N or N m).
    ForceRange,
    /// The force sensor reports an overload.
    ForceOverload,
    /// An encoder jumped further in one tick than the joint can turn (rad).
    EncoderJump,
    /// Motor and external encoders of a joint disagree (rad).
    EncoderDisagreement,
    /// A joint is outside its limits (rad).
    JointLimit,
    /// A joint is too fast (rad/s).
    JointSpeed,
    /// The plate's force is too large (N).
    TipForce,
    /// The tip is at a forbidden radius (m).
    WorkspaceRadius,
    /// The tip is at a forbidden height (m).
    WorkspaceHeight,
    /// The tip is at a forbidden base angle (rad).
    WorkspaceBase,
    /// A joint does not follow (rad).
    TrackingError,
    /// Under stiffness control the tip is too far from where it should be (m).
    StiffnessError,
    /// A wanted joint angle changed too fast (rad in one tick).
    SetpointRate,
    /// A torque was at its limit for too long (ticks).
    TorqueSaturated,
    /// An amplifier's current is too large (A).
    OverCurrent,
    /// An amplifier's current is not the commanded one (A).
    CurrentMismatch,
    /// An amplifier's voltage is out of bounds (V).
    SupplyVoltage,
    /// The arm's equations have no answer at the sensed posture.
    Kinematics,
    /// A computed torque was not a number; it was not sent.
    OutputNotFinite,
}

/// The first fault since the last reset.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FaultRecord {
    /// Which limit.
    pub fault: Fault,
    /// Joint, motor or channel.
    pub index: u16,
    /// The value found.
    pub value: f64,
    /// The limit.
    pub limit: f64,
    /// The tick.
    pub tick: u64,
}

/// Whether the arm is driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Mode {
    /// Amplifiers off; may be enabled.
    #[default]
    Off,
    /// Amplifiers on.
    Ready,
    /// The safe state: amplifiers off, torques and currents zero, trajectories and sequences gone, until a reset.
    Fault,
}
