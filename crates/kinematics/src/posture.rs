use crate::{Arm, JointAngles, KinematicsError};

/// The sines, cosines and lengths of one posture, shared by everything computed from it.
///
/// `r` is the horizontal direction in the arm's plane, `t` the one at right angles to it (both turn with the base
/// joint), `z` is up. Heights are above the shoulder.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Posture {
    /// theta_1 + theta_2.
    pub(crate) theta_12: f64,
    pub(crate) s0: f64,
    pub(crate) c0: f64,
    pub(crate) s1: f64,
    pub(crate) c1: f64,
    pub(crate) s2: f64,
    pub(crate) s12: f64,
    pub(crate) c12: f64,
    pub(crate) s3: f64,
    pub(crate) c3: f64,
    pub(crate) s4: f64,
    pub(crate) c4: f64,
    /// Direction of the hand along r, t and z (eq. B.2 turned back by theta_0; its z has c4 c12).
    pub(crate) hand: [f64; 3],
    /// cos n2, never negative.
    pub(crate) cos_n2: f64,
    /// Shoulder to elbow, along r and z.
    pub(crate) upper_arm: [f64; 2],
    /// Shoulder to wrist, along r and z.
    pub(crate) wrist: [f64; 2],
    /// Shoulder's axis to tip, along r, t and z.
    pub(crate) tip: [f64; 3],
}

impl Posture {
    pub(crate) fn new(arm: &Arm, joints: &JointAngles) -> Result<Self, KinematicsError> {
        let [theta_0, theta_1, theta_2, theta_3, theta_4] = joints.checked()?;
        let links = &arm.config().links;
        let theta_12 = theta_1 + theta_2;
        let (s0, c0) = libm::sincos(theta_0);
        let (s1, c1) = libm::sincos(theta_1);
        let s2 = libm::sin(theta_2);
        let (s12, c12) = libm::sincos(theta_12);
        let (s3, c3) = libm::sincos(theta_3);
        let (s4, c4) = libm::sincos(theta_4);
        let hand = [s4 * c3 * c12 + c4 * s12, s4 * s3, c4 * c12 - s4 * c3 * s12];
        let (l1, l2, l4) = (links.upper_arm_m, arm.forearm_m(), links.hand_m);
        let upper_arm = [l1 * s1, l1 * c1];
        let wrist = [upper_arm[0] + l2 * s12, upper_arm[1] + l2 * c12];
        let tip = [wrist[0] + l4 * hand[0], l4 * hand[1], wrist[1] + l4 * hand[2]];
        let cos_n2 = libm::hypot(c4, s4 * c3);
        Ok(Self {
            theta_12,
            s0,
            c0,
            s1,
            c1,
            s2,
            s12,
            c12,
            s3,
            c3,
            s4,
            c4,
            hand,
            cos_n2,
            upper_arm,
            wrist,
            tip,
        })
    }

    /// From r, t, z to x, y, z.
    pub(crate) fn in_world(&self, [r, t, z]: [f64; 3]) -> [f64; 3] {
        [r * self.c0 - t * self.s0, r * self.s0 + t * self.c0, z]
    }

    /// From x, y, z to r, t, z.
    pub(crate) fn in_arm_plane(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x * self.c0 + y * self.s0, y * self.c0 - x * self.s0, z]
    }
}
