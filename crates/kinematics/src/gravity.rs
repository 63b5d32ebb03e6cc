use crate::{Arm, ArmAt, JointAngles, JointTorques, KinematicsError};

impl Arm {
    /// Torques in N m that the joints must give to hold the arm still in air, counterweights included.
    ///
    /// They are the derivatives of [`Arm::potential_energy_j`]. The thesis only says that the arm is balanced;
    /// what is left depends on the masses in the arm file, which are assumed.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if an angle is not a finite number of at
    /// most 1000 rad.
    pub fn gravity_torques(&self, joints: &JointAngles) -> Result<JointTorques, KinematicsError> {
        Ok(self.at(joints)?.gravity_torques())
    }

    /// Potential energy of all masses and counterweights in J; zero with every mass at the height of the table.
    ///
    /// # Errors
    /// As [`Arm::gravity_torques`].
    pub fn potential_energy_j(&self, joints: &JointAngles) -> Result<f64, KinematicsError> {
        let frames = self.frames(joints)?;
        let config = self.config();
        let (masses, weights) = (&config.masses, &config.counterweights);
        let bodies = [
            (masses.base.mass_kg, frames.column, masses.base.com_m),
            (masses.upper_arm.mass_kg, frames.upper_arm, masses.upper_arm.com_m),
            (weights.shoulder.mass_kg, frames.upper_arm, -weights.shoulder.behind_m),
            (masses.forearm.mass_kg, frames.forearm, masses.forearm.com_m),
            (weights.elbow.mass_kg, frames.forearm, -weights.elbow.behind_m),
            (masses.twist.mass_kg, frames.twist, masses.twist.com_m),
            (masses.hand.mass_kg, frames.hand, masses.hand.com_m),
        ];
        let moment: f64 =
            bodies.into_iter().map(|(mass, frame, along)| mass * frame.point_m([0.0, 0.0, along])[2]).sum();
        Ok(config.gravity_m_s2 * moment)
    }
}

impl ArmAt<'_> {
    /// Torques in N m that hold the arm still in air: what [`Arm::gravity_torques`] says.
    #[must_use]
    pub fn gravity_torques(&self) -> JointTorques {
        let p = &self.posture;
        let config = self.arm.config();
        let (links, masses, weights) = (&config.links, &config.masses, &config.counterweights);
        let beyond_elbow =
            masses.forearm.mass_kg + weights.elbow.mass_kg + masses.twist.mass_kg + masses.hand.mass_kg;
        // Moments of mass (kg m) that turn with upper arm, forearm and hand.
        let upper_arm = masses.upper_arm.mass_kg * masses.upper_arm.com_m + beyond_elbow * links.upper_arm_m
            - weights.shoulder.mass_kg * weights.shoulder.behind_m;
        let forearm = masses.forearm.mass_kg * masses.forearm.com_m
            + masses.twist.mass_kg * (links.forearm_m + masses.twist.com_m)
            + masses.hand.mass_kg * self.arm.forearm_m()
            - weights.elbow.mass_kg * weights.elbow.behind_m;
        let hand = masses.hand.mass_kg * masses.hand.com_m;

        let g = config.gravity_m_s2;
        let elbow = -g * (forearm * p.s12 + hand * p.hand[0]);
        JointTorques([
            0.0,
            elbow - g * upper_arm * p.s1,
            elbow,
            g * hand * p.s4 * p.s3 * p.s12,
            -g * hand * (p.c4 * p.c3 * p.s12 + p.s4 * p.c12),
        ])
    }
}
