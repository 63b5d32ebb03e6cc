use crate::posture::Posture;
use crate::velocity::check_radius;
use crate::{Arm, JointAngles, JointTorques, KinematicsError};

impl Arm {
    /// The force in N (x, y, z) that the plate's lower edge presses with, from the torques of base, shoulder and
    /// elbow beyond those that hold the arm's weight.
    ///
    /// The wrist and twist joints are taken as locked: only the position rows and the first three columns of
    /// `J^-T` enter, so that metres and radians are not mixed. The torques of the other two joints are not used.
    /// The force is taken to act at the tip.
    ///
    /// # Errors
    /// [`KinematicsError::Singular`] if the tip is within 1 mm of the base axis or in line with the upper arm;
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if a number is not finite, an angle is
    /// above 1000 rad or a torque above 1e6 N m.
    pub fn tip_force(
        &self,
        joints: &JointAngles,
        torques: &JointTorques,
    ) -> Result<[f64; 3], KinematicsError> {
        let [base, shoulder, elbow, ..] = torques.checked()?;
        let p = Posture::new(self, joints)?;
        check_radius(&p)?;
        // The map from the tip's velocity to the rates of upper arm and of all behind the elbow; forces go by its transpose.
        let l1 = self.config().links.upper_arm_m;
        let [upper_r, elbow_r] = p.tip_two_bar(l1, [1.0, 0.0])?;
        let [upper_z, elbow_z] = p.tip_two_bar(l1, [0.0, 1.0])?;
        let upper_arm = shoulder - elbow;
        let force_r = upper_r * upper_arm + elbow_r * elbow;
        let force_z = upper_z * upper_arm + elbow_z * elbow;
        let force_t = (base + p.tip[1] * force_r) / p.tip[0];
        Ok(p.in_world([force_r, force_t, force_z]))
    }
}
