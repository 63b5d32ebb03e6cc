use serde::{Deserialize, Serialize};

/// What the hardware reports for one tick.
///
/// The sequence numbers change with every fresh reading of their sensor, so that a silent sensor is told from a still arm.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Sensed {
    /// Number of the tick, rising by one; a larger step means missed ticks.
    pub tick: u64,
    /// Counts of the motor encoders, by motor.
    pub motor_counts: [i32; 5],
    /// Sequence number of the motor encoders.
    pub motor_sequence: u32,
    /// Counts of the external encoders, in the motors' coordinates.
    pub external_counts: [i32; 5],
    /// Sequence number of the external encoders.
    pub external_sequence: u32,
    /// Force (N) and moment (N m) of the soil on the plate in the frame `ft_sensor`, bias included.
    pub wrench: [f64; 6],
    /// Sequence number of the force sensor.
    pub wrench_sequence: u32,
    /// The force sensor's own report of an overload or saturation.
    pub wrench_overload: bool,
    /// Currents that the amplifiers report in A.
    pub amplifier_current_a: [f64; 5],
    /// Supply voltages that the amplifiers report in V.
    pub amplifier_voltage_v: [f64; 5],
    /// Sequence number of the amplifiers' readings.
    pub amplifier_sequence: u32,
}
