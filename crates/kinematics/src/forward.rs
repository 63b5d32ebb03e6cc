use crate::{Arm, ArmAt, JointAngles, KinematicsError, TaskPose};

impl Arm {
    /// Where the plate is when the joints are at `joints` (eqs B.1 to B.3, B.7, B.8).
    ///
    /// Limits are not checked, since a joint may be read outside them; see [`Arm::check_limits`]. At `|n2| = 90
    /// deg` the hand has no pitch and `n1` means nothing, although it is a number. `n1` is continuous for
    /// `|theta_3| <= 90 deg`; beyond, with the wrist bent by more than a right angle, it jumps by a turn. Errata:
    /// B.1 lacks a parenthesis, the last term of B.2's z is `c4 c12`, and B.7 needs `atan2(s4 c3, c4)`.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if an angle is not a finite number of at
    /// most 1000 rad.
    pub fn forward(&self, joints: &JointAngles) -> Result<TaskPose, KinematicsError> {
        Ok(self.at(joints)?.pose())
    }
}

impl ArmAt<'_> {
    /// Where the plate is: what [`Arm::forward`] says.
    #[must_use]
    pub fn pose(&self) -> TaskPose {
        let p = &self.posture;
        let [x_m, y_m, height_m] = p.in_world(p.tip);
        TaskPose {
            x_m,
            y_m,
            z_m: self.arm.config().links.base_height_m + height_m,
            n1_rad: p.theta_12 + libm::atan2(p.s4 * p.c3, p.c4),
            // B.8's arcsine loses half of its digits near a right angle.
            n2_rad: libm::atan2(p.hand[1], p.cos_n2),
        }
    }
}
