use soilctl_kinematics::{Joint, KinematicsError, TaskVelocity, Wrist};

use crate::Params;
use crate::estimate::Estimate;
use crate::trajectory::Setpoint;

/// Eq. 3.2 with its first `J^-1` read as `J^T`: springs at the tip that turn with the base, damping on the motors.
///
/// Position rows only: the wrist is off and held by its worm gear. No row holds the twist joint either, so it is
/// servoed to its wanted angle; then base, shoulder and elbow alone decide the tip's force, which has the direction of the
/// position error. The error is the difference of positions, not `J` times that of the joints, since they are known.
pub(crate) fn stiffness(
    params: &Params,
    wanted: &Setpoint,
    est: &Estimate,
) -> Result<[f64; 5], KinematicsError> {
    let actual = est.motor_position_m;
    let error: [f64; 3] = std::array::from_fn(|i| wanted.position_m[i] - actual[i]);
    let springs = params.stiffness.to_cartesian(est.joints.0[0])?;
    let displacement = TaskVelocity([error[0], error[1], error[2], 0.0, 0.0]);
    let mut torques = springs.joint_torques(&est.jacobian, &displacement, Wrist::Locked)?.0;
    let gains = &params.config().gains;
    for (i, torque) in torques.iter_mut().enumerate().take(3) {
        *torque -= gains.motor_d_nms_per_rad[i] * est.rates.0[i];
    }
    let twist = Joint::Twist.index();
    torques[twist] = gains.motor_p_nm_per_rad[twist] * (wanted.joints.0[twist] - est.motor.0[twist])
        - gains.motor_d_nms_per_rad[twist] * est.rates.0[twist];
    torques[Joint::Wrist.index()] = 0.0;
    Ok(torques)
}
