use crate::{
    JointAngles, JointTorques, JointVelocities, KinematicsError, MotorAngles, MotorTorques, MotorVelocities,
};

/// The map between joints and motors: signs, the elbow differential and the coupling of elbow and shoulder.
///
/// Motors 2 and 3 drive the differential together: their difference bends the elbow, their sum twists the
/// forearm. The elbow's cables run over the shoulder's pulleys, so that a shoulder motion moves them too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transmission {
    home: JointAngles,
    to_motor: [[f64; 5]; 5],
    to_joint: [[f64; 5]; 5],
}

impl Transmission {
    /// `r_c` and `r_d` are the coupling and differential ratios, `home` where the motors' coordinates are zero.
    pub(crate) fn new([s0, s1, s2, s3, s4]: [f64; 5], home: JointAngles, r_c: f64, r_d: f64) -> Self {
        let to_motor = [
            [s0, 0.0, 0.0, 0.0, 0.0],
            [0.0, s1, 0.0, 0.0, 0.0],
            [0.0, -s2 * r_c, s2, -0.5 * r_d * s3, 0.0],
            [0.0, s2 * r_c, -s2, -0.5 * r_d * s3, 0.0],
            [0.0, 0.0, 0.0, 0.0, s4],
        ];
        let to_joint = [
            [s0, 0.0, 0.0, 0.0, 0.0],
            [0.0, s1, 0.0, 0.0, 0.0],
            [0.0, s1 * r_c, 0.5 * s2, -0.5 * s2, 0.0],
            [0.0, 0.0, -s3 / r_d, -s3 / r_d, 0.0],
            [0.0, 0.0, 0.0, 0.0, s4],
        ];
        Self { home, to_motor, to_joint }
    }

    /// Matrix from joint to motor speeds (eq. B.46; erratum: the term of theta_3 has the same sign in both rows
    /// of the differential, else the matrix is singular). Rows: motors, columns: joints.
    #[must_use]
    pub const fn joint_to_motor(&self) -> [[f64; 5]; 5] {
        self.to_motor
    }

    /// Matrix from motor to joint speeds, the inverse of [`Transmission::joint_to_motor`] (eq. B.47; erratum: the
    /// coupling term carries the shoulder's sign). Rows: joints, columns: motors.
    #[must_use]
    pub const fn motor_to_joint(&self) -> [[f64; 5]; 5] {
        self.to_joint
    }

    /// Joint angles at which all motor coordinates are zero.
    #[must_use]
    pub const fn home(&self) -> JointAngles {
        self.home
    }

    /// Motor angles of joint angles, counted from home.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] for anything but finite numbers of at most
    /// 1000 rad.
    pub fn motor_angles(&self, joints: &JointAngles) -> Result<MotorAngles, KinematicsError> {
        let angles = joints.checked()?;
        let from_home = std::array::from_fn(|i| angles[i] - self.home.0[i]);
        Ok(MotorAngles(times(&self.to_motor, from_home)))
    }

    /// Joint angles of motor angles.
    ///
    /// # Errors
    /// As [`Transmission::motor_angles`].
    pub fn joint_angles(&self, motors: &MotorAngles) -> Result<JointAngles, KinematicsError> {
        let from_home = times(&self.to_joint, motors.checked()?);
        Ok(JointAngles(std::array::from_fn(|i| from_home[i] + self.home.0[i])))
    }

    /// Motor speeds of joint speeds.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] for anything but finite numbers of at most
    /// 1e6 rad/s.
    pub fn motor_velocities(&self, joints: &JointVelocities) -> Result<MotorVelocities, KinematicsError> {
        Ok(MotorVelocities(times(&self.to_motor, joints.checked()?)))
    }

    /// Joint speeds of motor speeds.
    ///
    /// # Errors
    /// As [`Transmission::motor_velocities`].
    pub fn joint_velocities(&self, motors: &MotorVelocities) -> Result<JointVelocities, KinematicsError> {
        Ok(JointVelocities(times(&self.to_joint, motors.checked()?)))
    }

    /// Motor torques that do the work of joint torques: the transpose of [`Transmission::motor_to_joint`].
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] for anything but finite numbers of at most
    /// 1e6 N m.
    pub fn motor_torques(&self, joints: &JointTorques) -> Result<MotorTorques, KinematicsError> {
        Ok(MotorTorques(transpose_times(&self.to_joint, joints.checked()?)))
    }

    /// Joint torques that do the work of motor torques: the transpose of [`Transmission::joint_to_motor`].
    ///
    /// # Errors
    /// As [`Transmission::motor_torques`].
    pub fn joint_torques(&self, motors: &MotorTorques) -> Result<JointTorques, KinematicsError> {
        Ok(JointTorques(transpose_times(&self.to_motor, motors.checked()?)))
    }
}

fn times(matrix: &[[f64; 5]; 5], vector: [f64; 5]) -> [f64; 5] {
    matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
}

fn transpose_times(matrix: &[[f64; 5]; 5], vector: [f64; 5]) -> [f64; 5] {
    std::array::from_fn(|column| (0..5).map(|row| matrix[row][column] * vector[row]).sum())
}
