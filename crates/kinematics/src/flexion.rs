use crate::error::check_size;
use crate::space::MOST_RADIANS;
use crate::{Arm, JointAngles, KinematicsError, TaskForce};

/// Passes of the compensation; each gains about two digits on an arm as stiff as Hong's.
const PASSES: usize = 6;
/// The last pass may not move a joint by more than this, in rad.
const SETTLED_RAD: f64 = 1e-6;

/// How far shoulder and elbow give way between the encoders and the joints, in rad per N m.
///
/// Rows: shoulder and elbow, columns: torque at shoulder and elbow. It is the inverse of the matrix of eq. A.2. A
/// compliance can describe a joint that does not give way at all (zeros), such as the shoulder, whose encoder sits on
/// the joint; the stiffness cannot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compliance {
    /// The matrix, in rad/(N m).
    pub rad_per_nm: [[f64; 2]; 2],
}

impl Compliance {
    /// Only the elbow gives way, by torque over `stiffness_nm_per_rad`.
    ///
    /// # Errors
    /// [`KinematicsError::OutOfRange`] unless the stiffness is from 1e-6 to 1e9 N m/rad.
    pub fn of_elbow(stiffness_nm_per_rad: f64) -> Result<Self, KinematicsError> {
        Ok(Self { rad_per_nm: [[0.0, 0.0], [0.0, 1.0 / checked_stiffness(stiffness_nm_per_rad)?]] })
    }

    /// The elbow's own stiffness in N m/rad, the `k_elbow` of eq. A.3; none if it does not give way.
    #[must_use]
    pub fn elbow_stiffness_nm_per_rad(&self) -> Option<f64> {
        let own = self.rad_per_nm[1][1];
        (own > 0.0).then(|| 1.0 / own)
    }
}

impl Arm {
    /// The elbow compliance in the arm file.
    #[must_use]
    pub fn elbow_compliance(&self) -> Compliance {
        let stiffness = self.config().flexion.elbow_stiffness_nm_per_rad;
        Compliance { rad_per_nm: [[0.0, 0.0], [0.0, 1.0 / stiffness]] }
    }

    /// Torques in N m at shoulder and elbow of a force in N (x, y, z) at the tip.
    ///
    /// # Errors
    /// As [`Arm::jacobian`], and [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if the force
    /// is not finite or above 1e6 N.
    pub fn shoulder_elbow_torques(
        &self,
        joints: &JointAngles,
        [x, y, z]: [f64; 3],
    ) -> Result<[f64; 2], KinematicsError> {
        let torques = self.jacobian(joints)?.joint_torques(&TaskForce([x, y, z, 0.0, 0.0]))?;
        Ok([torques.0[1], torques.0[2]])
    }

    /// The true joints behind encoders that do not see the stretch, when the soil presses on the plate with
    /// `soil_on_plate_n` (x, y, z, in N).
    ///
    /// The soil's force turns the joints further in its own direction: `q = q_encoder + C tau(q)`. Eq. A.3 takes the
    /// torque at the encoder's posture and simplifies the lever; here it is the torque at the true posture, found in
    /// six passes.
    ///
    /// # Errors
    /// [`KinematicsError::OutOfRange`] if the passes do not settle, because the arm is far too soft for this force or
    /// an element of the compliance is above 1 rad/(N m); otherwise as [`Arm::shoulder_elbow_torques`].
    pub fn compensate_flexion(
        &self,
        encoder: &JointAngles,
        soil_on_plate_n: [f64; 3],
        compliance: &Compliance,
    ) -> Result<JointAngles, KinematicsError> {
        let [shoulder, elbow] = compliance.rad_per_nm;
        let all = [shoulder[0], shoulder[1], elbow[0], elbow[1]];
        check_size("compliance", &all, 1.0, "rad/(N m)", "between -1 and 1 rad/(N m)")?;
        let mut joints = *encoder;
        let mut change = 0.0;
        for _ in 0..PASSES {
            let [tau_1, tau_2] = self.shoulder_elbow_torques(&joints, soil_on_plate_n)?;
            let next_1 = encoder.0[1] + shoulder[0] * tau_1 + shoulder[1] * tau_2;
            let next_2 = encoder.0[2] + elbow[0] * tau_1 + elbow[1] * tau_2;
            change = (next_1 - joints.0[1]).abs().max((next_2 - joints.0[2]).abs());
            joints.0[1] = next_1;
            joints.0[2] = next_2;
        }
        if change > SETTLED_RAD {
            return Err(KinematicsError::OutOfRange {
                quantity: "change in the last pass of the flexion compensation",
                value: change,
                unit: "rad",
                allowed: "at most 1e-6 rad: the arm is too soft for this force, so check stiffness and force",
            });
        }
        joints.checked()?;
        Ok(joints)
    }
}

/// The elbow's offset in rad as in eq. A.3, `|F| r cos(theta_4 - delta) / k_elbow`, to reproduce the thesis.
///
/// `force_n` is the size of the force in the arm's plane and `force_angle_rad` (delta) its angle from the plate's
/// normal (the hand's x axis) towards the tip; `lever_m` (r) the distance from the elbow to where it acts. Exact
/// for a straight wrist; [`Arm::compensate_flexion`] needs no such simplification.
///
/// # Errors
/// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if the stiffness is below 1e-6 or above 1e9
/// N m/rad, or a number not finite or too large (force 1e6 N, lever 100 m, angles 1000 rad).
pub fn thesis_elbow_offset_rad(
    force_n: f64,
    lever_m: f64,
    wrist_rad: f64,
    force_angle_rad: f64,
    stiffness_nm_per_rad: f64,
) -> Result<f64, KinematicsError> {
    check_size("force", &[force_n], 1e6, "N", "between -1e6 and 1e6 N")?;
    check_size("lever", &[lever_m], 100.0, "m", "between -100 and 100 m")?;
    let angles = [wrist_rad, force_angle_rad];
    check_size("wrist or force angle", &angles, MOST_RADIANS, "rad", "between -1000 and 1000 rad")?;
    let stiffness = checked_stiffness(stiffness_nm_per_rad)?;
    Ok(force_n * lever_m * libm::cos(wrist_rad - force_angle_rad) / stiffness)
}

fn checked_stiffness(value: f64) -> Result<f64, KinematicsError> {
    let (quantity, unit, allowed) = ("elbow stiffness", "N m/rad", "at least 1e-6 and at most 1e9 N m/rad");
    check_size(quantity, &[value], 1e9, unit, allowed)?;
    if value < 1e-6 {
        return Err(KinematicsError::OutOfRange { quantity, value, unit, allowed });
    }
    Ok(value)
}
