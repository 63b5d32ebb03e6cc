use crate::error::check_size;
use crate::{
    Arm, ArmAt, JointAngles, JointTorques, JointVelocities, KinematicsError, Singularity, TaskForce,
    TaskVelocity,
};

/// The pitch `n1` is refused where cos n2 is below this: its rates grow as the inverse.
pub(crate) const LEAST_COS_N2: f64 = 1e-6;

/// Derivatives of the pose with respect to the joints.
///
/// Rows: x, y, z (m/rad), n1, n2 (rad/rad). Columns: theta_0 to theta_4. Every element is finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jacobian(pub [[f64; 5]; 5]);

impl Arm {
    /// The Jacobian at `joints` (eqs B.9 to B.34, with B.28, B.29, B.33 and B.34 corrected).
    ///
    /// Its determinant is `-r' l1 l2 sin(theta_2) sin(theta_4) / cos(n2)`, where r' is the tip's coordinate in
    /// the arm's plane.
    ///
    /// # Errors
    /// [`KinematicsError::Singular`] where cos n2 is below 1e-6 and n1 has no derivatives;
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if an angle is not a finite number of at
    /// most 1000 rad.
    pub fn jacobian(&self, joints: &JointAngles) -> Result<Jacobian, KinematicsError> {
        self.at(joints)?.jacobian()
    }
}

impl ArmAt<'_> {
    /// The Jacobian: what [`Arm::jacobian`] says.
    ///
    /// # Errors
    /// [`KinematicsError::Singular`] where cos n2 is below 1e-6 and n1 has no derivatives.
    pub fn jacobian(&self) -> Result<Jacobian, KinematicsError> {
        let p = &self.posture;
        check_cos_n2(p.cos_n2)?;
        let links = &self.arm.config().links;
        let (l4, cos2) = (links.hand_m, p.cos_n2 * p.cos_n2);
        let [r, t, height] = p.tip;
        let elbow_to_tip = [r - p.upper_arm[0], height - p.upper_arm[1]];
        // Columns of velocities along r, t, z.
        let positions = [
            [-t, r, 0.0],
            [height, 0.0, -r],
            [elbow_to_tip[1], 0.0, -elbow_to_tip[0]],
            [-l4 * p.s4 * p.s3 * p.c12, l4 * p.s4 * p.c3, l4 * p.s4 * p.s3 * p.s12],
            [
                l4 * (p.c4 * p.c3 * p.c12 - p.s4 * p.s12),
                l4 * p.c4 * p.s3,
                -l4 * (p.c4 * p.c3 * p.s12 + p.s4 * p.c12),
            ],
        ];
        let mut rows = [[0.0; 5]; 5];
        for (column, position) in positions.into_iter().enumerate() {
            let [x, y, z] = p.in_world(position);
            rows[0][column] = x;
            rows[1][column] = y;
            rows[2][column] = z;
        }
        rows[3] = [0.0, 1.0, 1.0, -p.s3 * p.s4 * p.c4 / cos2, p.c3 / cos2];
        rows[4] = [0.0, 0.0, 0.0, p.s4 * p.c3 / p.cos_n2, p.c4 * p.s3 / p.cos_n2];
        Ok(Jacobian(rows))
    }
}

pub(crate) fn check_cos_n2(value: f64) -> Result<(), KinematicsError> {
    if value >= LEAST_COS_N2 {
        return Ok(());
    }
    let (place, measure) = (Singularity::SidewaysHand, "cos n2");
    Err(KinematicsError::Singular { place, measure, value, least: LEAST_COS_N2 })
}

impl Jacobian {
    /// Velocity of the pose, `J q_dot`; the same map takes small joint differences (rad) to pose differences (m,
    /// rad).
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] unless all numbers are finite, the
    /// speeds at most 1e6 rad/s and the matrix one of [`Arm::jacobian`] (at most 1e14).
    pub fn task_velocity(&self, joints: &JointVelocities) -> Result<TaskVelocity, KinematicsError> {
        let rates = joints.checked()?;
        self.check()?;
        Ok(TaskVelocity(self.0.map(|row| row.iter().zip(rates).map(|(a, b)| a * b).sum())))
    }

    /// Joint torques that do the same work as a force at the tip, `J^T f`.
    ///
    /// If `force` is what the arm presses onto the soil, these are the torques that the joints must give.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] unless all numbers are finite, the forces at
    /// most 1e6 N and the matrix one of [`Arm::jacobian`] (at most 1e14).
    pub fn joint_torques(&self, force: &TaskForce) -> Result<JointTorques, KinematicsError> {
        let force = force.checked()?;
        self.check()?;
        Ok(JointTorques(std::array::from_fn(|column| {
            (0..5).map(|row| self.0[row][column] * force[row]).sum()
        })))
    }

    /// The matrix is public, so that it may have been made by anyone.
    fn check(&self) -> Result<(), KinematicsError> {
        self.0.iter().try_for_each(|row| {
            check_size("Jacobian element", row, 1e14, "m/rad or 1", "at most 1e14 in size; use Arm::jacobian")
        })
    }
}
