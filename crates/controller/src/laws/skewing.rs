use soilctl_kinematics::{JointTorques, KinematicsError, TaskPose, TaskVelocity, Wrist};

use crate::Params;

/// By how much the tip's force turns away from the error that it answers, in rad, -pi to pi, positive from outwards to upwards.
///
/// Skewing (section 5.3.1, figure 5-6): springs in the joints press the plate elsewhere than it is to go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Skew {
    /// Under the joint PID of eq. 3.1: its proportional gains, on motor and external encoders together.
    pub pid_rad: f64,
    /// Under the Cartesian stiffness of eq. 3.2.
    pub stiffness_rad: f64,
}

impl Skew {
    /// For a small error of the tip at a pose, in the vertical plane through the base axis; `error_rad` is its direction, 0 outwards
    /// and pi/2 upwards. Wrist and twist are locked.
    ///
    /// # Errors
    /// Those of [`Arm::inverse`](soilctl_kinematics::Arm::inverse) for a pose that the arm cannot take, and
    /// [`KinematicsError::Singular`] where the tip cannot be moved in the plane.
    pub fn new(params: &Params, pose: &TaskPose, error_rad: f64) -> Result<Self, KinematicsError> {
        let arm = params.arm();
        let joints = arm.inverse(pose)?;
        let jacobian = arm.jacobian(&joints)?;
        let (sin, cos) = libm::sincos(joints.0[0]);
        let (up, out) = libm::sincos(error_rad);
        let inclination = |[x, y, z]: [f64; 3]| libm::atan2(z, x * cos + y * sin);
        let turned = |force: [f64; 3]| {
            let angle = inclination(force) - error_rad;
            angle - std::f64::consts::TAU * libm::round(angle / std::f64::consts::TAU)
        };

        // Shoulder and elbow move the tip in the plane: rows r and z of the Jacobian.
        let row = |column: usize| jacobian.0[0][column] * cos + jacobian.0[1][column] * sin;
        let ([a, b], [c, d]) = ([row(1), row(2)], [jacobian.0[2][1], jacobian.0[2][2]]);
        let det = a * d - b * c;
        let [shoulder, elbow] = [(d * out - b * up) / det, (a * up - c * out) / det];
        let gains = &params.config().gains;
        let gain = |joint: usize| gains.motor_p_nm_per_rad[joint] + gains.external_p_nm_per_rad[joint];
        let pid = JointTorques([0.0, gain(1) * shoulder, gain(2) * elbow, 0.0, 0.0]);

        let error = TaskVelocity([out * cos, out * sin, up, 0.0, 0.0]);
        let springs = params.stiffness.to_cartesian(joints.0[0])?;
        let stiffness = springs.joint_torques(&jacobian, &error, Wrist::Locked)?;
        Ok(Self {
            pid_rad: turned(arm.tip_force(&joints, &pid)?),
            stiffness_rad: turned(arm.tip_force(&joints, &stiffness)?),
        })
    }
}
