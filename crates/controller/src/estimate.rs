//! From counts and raw forces to joints, speeds, pose and force.

use serde::{Deserialize, Serialize};
use soilctl_kinematics::{
    Jacobian, Joint, JointAngles, JointTorques, JointVelocities, KinematicsError, MotorAngles,
    MotorVelocities, TaskForce, TaskPose,
};

use crate::{Params, Sensed, TICK_S};

/// Memory of the conversion: offsets, filters, bias.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Filters {
    /// Whether the filters hold a reading; if not, the next one is taken as it is.
    pub primed: bool,
    /// Whether the offsets were ever set; before the first homing the arm is taken to stand at its stops.
    pub offset_known: bool,
    /// Motor counts at which the motor coordinates are zero.
    pub motor_zero: [i32; 5],
    /// External counts at which the motor coordinates are zero.
    pub external_zero: [i32; 5],
    /// Filtered motor coordinates by the motor encoders in rad.
    pub motor_rad: [f64; 5],
    /// Filtered motor coordinates by the external encoders in rad.
    pub external_rad: [f64; 5],
    /// The same before the low-pass: where in the present count they are, as far as the motors' motion tells.
    pub within_rad: [f64; 5],
    /// Filtered speeds of the motor coordinates in rad/s.
    pub motor_rate_rad_s: [f64; 5],
    /// Motor counts of the tick before.
    pub last_counts: [i32; 5],
    /// Filtered wrench of soil on plate without bias in N and N m.
    pub wrench: [f64; 6],
    /// Bias of the force sensor in N and N m.
    pub bias: [f64; 6],
    /// Sum of the readings of a bias that is being taken.
    pub bias_sum: [f64; 6],
    /// Readings that are still to come.
    pub bias_left: u32,
}

impl Filters {
    /// Takes in a reading whose numbers are finite; `ticks` since the one before. Returns whether a bias is complete.
    pub(crate) fn update(&mut self, params: &Params, sensed: &Sensed, ticks: f64) -> bool {
        if !self.offset_known {
            self.reference(params, sensed, &MotorAngles::default());
        }
        let motor = angles(&sensed.motor_counts, &self.motor_zero, &params.motor_rad_per_count);
        let count = angles(&sensed.external_counts, &self.external_zero, &params.external_rad_per_count);
        let external = self.within_counts(params, sensed, &count);
        if self.primed {
            for i in 0..5 {
                let counts = f64::from(sensed.motor_counts[i]) - f64::from(self.last_counts[i]);
                let rate = counts * params.motor_rad_per_count[i] / (ticks * TICK_S);
                self.motor_rate_rad_s[i] += params.velocity_smoothing * (rate - self.motor_rate_rad_s[i]);
                self.motor_rad[i] += params.motor_smoothing * (motor[i] - self.motor_rad[i]);
                self.external_rad[i] += params.external_smoothing * (external[i] - self.external_rad[i]);
            }
        } else {
            self.motor_rad = motor;
            self.external_rad = external;
            self.motor_rate_rad_s = [0.0; 5];
        }
        self.last_counts = sensed.motor_counts;
        let complete = self.update_bias(params, &sensed.wrench);
        for i in 0..6 {
            let force = sensed.wrench[i] - self.bias[i];
            let weight = if self.primed && !complete { params.force_smoothing } else { 1.0 };
            self.wrench[i] += weight * (force - self.wrench[i]);
        }
        self.primed = true;
        complete
    }

    /// A count of an external encoder says between which two angles it is, some 0.75 mm at the tip. Between them it is taken to
    /// follow the motor, whose counts are a hundred times finer; while the motor goes through its free play, it waits at the
    /// edge of the count. So it is never further off than a count.
    fn within_counts(&mut self, params: &Params, sensed: &Sensed, count: &[f64; 5]) -> [f64; 5] {
        for (i, (within, count)) in self.within_rad.iter_mut().zip(count).enumerate() {
            let step = params.external_rad_per_count[i];
            let (low, high) = if step > 0.0 { (*count, count + step) } else { (count + step, *count) };
            let moved = f64::from(sensed.motor_counts[i]) - f64::from(self.last_counts[i]);
            let follows = *within + moved * params.motor_rad_per_count[i];
            let guess = if self.primed { follows } else { 0.5 * (low + high) };
            *within = guess.max(low).min(high);
        }
        self.within_rad
    }

    /// Makes the motor coordinates of the present posture these, zero at the stops, to a count.
    pub(crate) fn reference(&mut self, params: &Params, sensed: &Sensed, motors: &MotorAngles) {
        let zero = |counts: &[i32; 5], rad_per_count: &[f64; 5]| {
            #[allow(
                clippy::cast_possible_truncation,
                reason = "a conversion that saturates, of a small angle"
            )]
            std::array::from_fn(|i| counts[i].wrapping_sub((motors.0[i] / rad_per_count[i]).round() as i32))
        };
        self.motor_zero = zero(&sensed.motor_counts, &params.motor_rad_per_count);
        self.external_zero = zero(&sensed.external_counts, &params.external_rad_per_count);
        self.offset_known = true;
        self.primed = false;
    }

    fn update_bias(&mut self, params: &Params, wrench: &[f64; 6]) -> bool {
        if self.bias_left == 0 {
            return false;
        }
        for (sum, reading) in self.bias_sum.iter_mut().zip(wrench) {
            *sum += reading;
        }
        self.bias_left -= 1;
        if self.bias_left > 0 {
            return false;
        }
        let count = f64::from(params.config().force_sensor.bias_ticks);
        self.bias = self.bias_sum.map(|sum| sum / count);
        true
    }

    /// Begins a new bias.
    pub(crate) fn start_bias(&mut self, params: &Params) {
        self.bias_sum = [0.0; 6];
        self.bias_left = params.config().force_sensor.bias_ticks;
    }
}

/// Angles of counts; the difference is taken in f64, where no counter can overflow.
fn angles(counts: &[i32; 5], zero: &[i32; 5], rad_per_count: &[f64; 5]) -> [f64; 5] {
    std::array::from_fn(|i| (f64::from(counts[i]) - f64::from(zero[i])) * rad_per_count[i])
}

/// What one tick knows of the arm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Estimate {
    pub(crate) motor: JointAngles,
    /// By the external encoders alone.
    pub(crate) external: JointAngles,
    /// By the external encoders, with the stretch of the elbow's cables that they do not see (A.3); before homing the same.
    pub(crate) joints: JointAngles,
    pub(crate) rates: JointVelocities,
    /// Pose by the external encoders alone. This and what follows is zero before homing.
    pub(crate) seen: TaskPose,
    /// Pose of the joints, stretch included.
    pub(crate) pose: TaskPose,
    /// Position of the tip by the motor encoders; only known once `locate_motor_tip` was called.
    pub(crate) motor_position_m: [f64; 3],
    pub(crate) jacobian: Jacobian,
    pub(crate) gravity: JointTorques,
    /// Soil on plate along x, y, z.
    pub(crate) force_xyz_n: [f64; 3],
    /// Soil on plate along r, t, z of the base joint.
    pub(crate) force_rtz_n: [f64; 3],
    /// Soil on plate along the sensor's z axis.
    pub(crate) normal_force_n: f64,
    /// Whether the angles are those of the joints and not counted from where the arm stood.
    pub(crate) homed: bool,
}

impl Estimate {
    /// # Errors
    /// Those of the kinematics, at a posture where they have no answer.
    pub(crate) fn new(params: &Params, filters: &Filters, homed: bool) -> Result<Self, KinematicsError> {
        let (arm, map) = (params.arm(), params.arm().transmission());
        let motor = map.joint_angles(&MotorAngles(filters.motor_rad))?;
        let external = map.joint_angles(&MotorAngles(filters.external_rad))?;
        let rates = map.joint_velocities(&MotorVelocities(filters.motor_rate_rad_s))?;
        let mut estimate = Self {
            motor,
            external,
            joints: external,
            rates,
            seen: TaskPose::default(),
            pose: TaskPose::default(),
            motor_position_m: [0.0; 3],
            jacobian: Jacobian([[0.0; 5]; 5]),
            gravity: JointTorques::default(),
            force_xyz_n: [0.0; 3],
            force_rtz_n: [0.0; 3],
            normal_force_n: 0.0,
            homed,
        };
        if !homed {
            return Ok(estimate);
        }
        let force = [filters.wrench[0], filters.wrench[1], filters.wrench[2]];
        let mut here = arm.at(&external)?;
        estimate.seen = here.pose();
        // Two passes: the torque of the first is that at the encoders' posture, as in the thesis, and leaves 0.05 deg.
        for _ in 0..2 {
            let [r, t, z] = here.sensor_to_rtz(force);
            let soil = here.rtz_to_base([r, t, z]);
            let torque = here.jacobian()?.joint_torques(&TaskForce([soil[0], soil[1], soil[2], 0.0, 0.0]))?;
            let elbow = Joint::Elbow.index();
            estimate.joints.0[elbow] = external.0[elbow] + params.elbow_rad_per_nm * torque.0[elbow];
            here = arm.at(&estimate.joints)?;
        }
        estimate.pose = here.pose();
        estimate.jacobian = here.jacobian()?;
        if params.config().gains.gravity_compensation {
            estimate.gravity = here.gravity_torques();
        }
        let [r, t, z] = here.sensor_to_rtz(force);
        estimate.force_xyz_n = here.rtz_to_base([r, t, z]);
        estimate.force_rtz_n = [r, t, z];
        estimate.normal_force_n = filters.wrench[2];
        Ok(estimate)
    }

    /// Apart, because only stiffness control needs it.
    pub(crate) fn locate_motor_tip(&mut self, params: &Params) -> Result<(), KinematicsError> {
        self.motor_position_m = params.arm().forward(&self.motor)?.position_m();
        Ok(())
    }
}
