//! What a force of the plate on the soil asks of the arm's motors.

use soilctl_controller::Params;
use soilctl_kinematics::{JointAngles, JointTorques, MotorTorques, TaskForce};

use crate::DiggingError;

/// A force of the plate on the soil in the arm's plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// Its size in N.
    pub force_n: f64,
    /// Its inclination to the plate's normal in rad, positive downwards.
    pub inclination_rad: f64,
    /// How far up the plate from the lower edge it acts, in m: a third of the slant length in soil whose pressure grows with depth.
    pub up_m: f64,
}

/// Torques of an arm that holds itself and pushes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Torques of the joints, without friction.
    pub joints: JointTorques,
    /// Torques of the motors, without friction.
    pub motors: MotorTorques,
    /// The greatest share of a limit of a joint or motor, friction of the drives among it.
    pub share: f64,
    /// Sum of the squared currents of all motors in A2, friction among it: heat in W for each ohm of winding.
    pub heat_a2: f64,
    /// Force towards the base in N: work in J for each metre of way.
    pub ahead_n: f64,
}

/// The load of a push in a posture, standing still or as slow as one pushes soil. Drives rub against their load with `friction_nm` (N m, by motor).
///
/// The force acts on the plate's face, so that its moment about the edge, `-up F cos(inclination)` on the pitch, goes along with it through `J^T`.
///
/// # Errors
/// [`DiggingError::Kinematics`] for a posture outside the limits, or numbers that are none.
pub fn load(
    params: &Params,
    angles: &JointAngles,
    push: &Push,
    friction_nm: &[f64; 5],
) -> Result<Load, DiggingError> {
    let arm = params.arm();
    arm.check_limits(angles)?;
    let pose = arm.forward(angles)?;
    let alpha = pose.tool_angle_rad();
    let below = alpha - std::f64::consts::FRAC_PI_2 + push.inclination_rad;
    let (outward, up) = (-push.force_n * libm::cos(below), -push.force_n * libm::sin(below));
    let radius = libm::hypot(pose.x_m, pose.y_m);
    let [cos, sin] = [pose.x_m / radius, pose.y_m / radius];
    let moment = -push.up_m * push.force_n * libm::cos(push.inclination_rad);
    let force = TaskForce([outward * cos, outward * sin, up, moment, 0.0]);
    let pushing = arm.jacobian(angles)?.joint_torques(&force)?.0;
    let holding = arm.gravity_torques(angles)?.0;
    let joints = JointTorques(std::array::from_fn(|i| pushing[i] + holding[i]));
    let motors = arm.transmission().motor_torques(&joints)?;
    let limits = arm.config().joints.all().map(|joint| joint.max_torque_nm);
    let config = &params.config().motors;
    let shares = |torques: [f64; 5], limits: [f64; 5]| {
        torques.iter().zip(limits).map(|(torque, limit)| torque.abs() / limit).fold(0.0, f64::max)
    };
    // Friction stands against whichever way a drive turns, which is not known of each while the arm gives way: at most.
    let rubbing = std::array::from_fn(|i| motors.0[i].abs() + friction_nm[i]);
    let to_motor = arm.transmission().joint_to_motor();
    let turning = std::array::from_fn(|joint| {
        let friction: f64 = (0..5).map(|motor| to_motor[motor][joint].abs() * friction_nm[motor]).sum();
        joints.0[joint].abs() + friction
    });
    let heat_a2 = rubbing.iter().zip(config.current_a_per_nm).map(|(t, a)| (t * a) * (t * a)).sum();
    Ok(Load {
        joints,
        motors,
        share: shares(turning, limits).max(shares(rubbing, config.max_torque_nm)),
        heat_a2,
        ahead_n: -outward,
    })
}
