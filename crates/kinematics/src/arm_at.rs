use crate::posture::Posture;
use crate::{Arm, JointAngles, KinematicsError};

/// An arm at one posture: what several computations share is done once.
#[derive(Debug, Clone, Copy)]
pub struct ArmAt<'a> {
    pub(crate) arm: &'a Arm,
    pub(crate) posture: Posture,
}

impl Arm {
    /// The arm at `joints`, for pose, Jacobian, weight and force of the same posture.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if an angle is not a finite number of at
    /// most 1000 rad.
    pub fn at(&self, joints: &JointAngles) -> Result<ArmAt<'_>, KinematicsError> {
        Ok(ArmAt { arm: self, posture: Posture::new(self, joints)? })
    }
}

impl ArmAt<'_> {
    /// A vector of the frame `ft_sensor` along r, t, z of the base joint.
    #[must_use]
    pub fn sensor_to_rtz(&self, [along, across, back]: [f64; 3]) -> [f64; 3] {
        let p = &self.posture;
        // The hand's axes are (-back, across, along); wrist, twist, then shoulder and elbow turn them.
        let (x, z) = (p.c4 * -back + p.s4 * along, p.c4 * along + p.s4 * back);
        let (x, t) = (p.c3 * x - p.s3 * across, p.s3 * x + p.c3 * across);
        [p.c12 * x + p.s12 * z, t, p.c12 * z - p.s12 * x]
    }

    /// A vector along r, t, z of the base joint along x, y, z.
    #[must_use]
    pub fn rtz_to_base(&self, rtz: [f64; 3]) -> [f64; 3] {
        self.posture.in_world(rtz)
    }
}
