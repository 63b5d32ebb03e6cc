use soilctl_controller::{Outputs, Sensed};
use soilctl_kinematics::MotorTorques;

/// What the controller wants of the motors in one tick.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Drive {
    /// Torques of the motor coordinates in N m.
    pub motor_torques: MotorTorques,
    /// Whether the amplifiers shall be on; if not, the torques count as zero.
    pub amplifiers_enabled: bool,
}

impl From<&Outputs> for Drive {
    fn from(outputs: &Outputs) -> Self {
        Self { motor_torques: outputs.motor_torques, amplifiers_enabled: outputs.amplifiers_enabled }
    }
}

/// The boundary between controller and hardware: a simulated plant, or a driver of a real arm.
pub trait Hardware {
    /// What can go wrong.
    type Error;

    /// Lets the motors act for one tick of 2 ms, then reads the sensors.
    ///
    /// The first call, with amplifiers off, gives the readings of the first tick. Ticks rise by one.
    ///
    /// # Errors
    /// Whatever the hardware cannot do. A reading that is merely bad is no error: the controller judges it.
    fn exchange(&mut self, drive: &Drive) -> Result<Sensed, Self::Error>;
}
