use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::error::check_size;
use crate::jacobian::check_cos_n2;
use crate::{Arm, JointAngles, KinematicsError, LIMIT_TOLERANCE_RAD, Singularity, TaskPose};

/// The tip must stay this far in front of the base axis, in m; on the axis the base angle is anything.
pub(crate) const LEAST_RADIUS_M: f64 = 1e-3;

impl Arm {
    /// The joints that bring the plate to `pose`, in closed form (eqs B.35 to B.45).
    ///
    /// Of the several solutions it takes the one with a bent elbow (`theta_2 > 0`), the arm reaching forwards
    /// (`r' > 0`, where r' is the tip's coordinate in the arm's plane) and `|theta_3| <= pi/2`. With a straight
    /// wrist any theta_3 gives the pose; the answer is 0. At theta_3 = 90 deg the same posture is also written
    /// with -90 deg and the wrist bent back; either may be the answer.
    ///
    /// Errata: in B.36 to B.39 the radius and angle are those of the tip, and the offset of theta_0 is signed;
    /// B.41 and B.42 need the height above the shoulder; theta_3 and theta_4 change branch only if theta_p is
    /// negative.
    ///
    /// # Errors
    /// [`KinematicsError::Unreachable`] if the arm is too short or cannot fold that far,
    /// [`KinematicsError::OutOfLimits`] naming the first joint that cannot go there,
    /// [`KinematicsError::Singular`] if the tip is within 1 mm of the base axis or the hand is at right angles to
    /// the arm's plane, and [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if a coordinate is
    /// not finite, a position is beyond 100 m, n1 beyond two turns or n2 beyond a quarter turn.
    pub fn inverse(&self, pose: &TaskPose) -> Result<JointAngles, KinematicsError> {
        let position = pose.position_m();
        check_size("task position", &position, 100.0, "m", "between -100 and 100 m")?;
        check_size("pitch n1", &[pose.n1_rad], 2.0 * TAU, "rad", "between -4 pi and 4 pi rad")?;
        check_size("out-of-plane angle n2", &[pose.n2_rad], FRAC_PI_2, "rad", "between -pi/2 and pi/2 rad")?;
        let links = &self.config().links;
        let (sin_n1, cos_n1) = libm::sincos(pose.n1_rad);
        let (sin_n2, cos_n2) = libm::sincos(pose.n2_rad);
        check_cos_n2(cos_n2)?;

        // The hand leaves the arm's plane sideways by l4 sin n2, so the base points beside the tip by that much.
        let sideways = links.hand_m * sin_n2;
        let radius = libm::hypot(pose.x_m, pose.y_m);
        let inside = (radius - sideways) * (radius + sideways);
        let forwards = if inside > 0.0 { inside.sqrt() } else { 0.0 };
        if forwards < LEAST_RADIUS_M {
            let (place, measure) = (Singularity::BaseAxis, "r' in m");
            return Err(KinematicsError::Singular { place, measure, value: forwards, least: LEAST_RADIUS_M });
        }
        let theta_0 = libm::atan2(pose.y_m, pose.x_m) - libm::atan2(sideways, forwards);

        let wrist = [
            forwards - links.hand_m * cos_n2 * sin_n1,
            pose.z_m - links.base_height_m - links.hand_m * cos_n2 * cos_n1,
        ];
        let (theta_1, theta_2) = self.elbow_triangle(wrist)?;

        let pitch = within_half_turn(pose.n1_rad - theta_1 - theta_2);
        let (sin_pitch, cos_pitch) = libm::sincos(pitch);
        let branch = if pitch < 0.0 { -1.0 } else { 1.0 };
        let along = branch * cos_n2 * sin_pitch;
        let theta_3 = if sin_n2 == 0.0 { 0.0 } else { libm::atan2(branch * sin_n2, along.max(0.0)) };
        let theta_4 = branch * libm::atan2(libm::hypot(sin_n2, along), cos_n2 * cos_pitch);

        self.within_limits([theta_0, theta_1, theta_2, theta_3, theta_4])
    }

    /// Shoulder and elbow from the wrist's place relative to the shoulder (eqs B.41, B.42).
    ///
    /// The half-angle form keeps all digits where B.41's arccosine loses half of them.
    fn elbow_triangle(&self, [r, z]: [f64; 2]) -> Result<(f64, f64), KinematicsError> {
        let (l1, l2) = (self.config().links.upper_arm_m, self.forearm_m());
        let distance_m = libm::hypot(r, z);
        let (nearest_m, farthest_m) = ((l1 - l2).abs(), l1 + l2);
        if distance_m > farthest_m || distance_m < nearest_m {
            return Err(KinematicsError::Unreachable { distance_m, nearest_m, farthest_m });
        }
        let folded = (farthest_m - distance_m) * (farthest_m + distance_m);
        let stretched = (distance_m - nearest_m) * (distance_m + nearest_m);
        let theta_2 = 2.0 * libm::atan2(folded.sqrt(), stretched.sqrt());
        let (s2, c2) = libm::sincos(theta_2);
        let theta_1 = FRAC_PI_2 - libm::atan2(z, r) - libm::atan2(l2 * s2, l1 + l2 * c2);
        Ok((theta_1, theta_2))
    }

    /// Moves each angle by whole turns into its limits, if there is such a turn.
    fn within_limits(&self, angles: [f64; 5]) -> Result<JointAngles, KinematicsError> {
        let (lower, upper) = (self.lower_limits().0, self.upper_limits().0);
        let mut joints = JointAngles(angles);
        for i in 0..5 {
            let inside = |a: f64| a >= lower[i] - LIMIT_TOLERANCE_RAD && a <= upper[i] + LIMIT_TOLERANCE_RAD;
            let turns = [angles[i], angles[i] - TAU, angles[i] + TAU];
            if let Some(angle) = turns.into_iter().find(|&angle| inside(angle)) {
                joints.0[i] = angle;
            } else {
                // For the message.
                joints.0[i] = within_half_turn(angles[i]);
            }
        }
        self.check_limits(&joints)?;
        Ok(joints)
    }
}

/// The same direction between -pi and pi; angles already there keep their bits.
fn within_half_turn(angle: f64) -> f64 {
    if angle.abs() <= PI { angle } else { angle - TAU * (angle / TAU).round() }
}
