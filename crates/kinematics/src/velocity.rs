use crate::inverse::LEAST_RADIUS_M;
use crate::jacobian::check_cos_n2;
use crate::posture::Posture;
use crate::{Arm, JointAngles, JointVelocities, KinematicsError, Singularity, TaskVelocity};

/// Speeds are refused where `|sin theta_2|`, or the sine between upper arm and tip, is below this.
pub(crate) const LEAST_SINE: f64 = 1e-3;

/// Joint speeds for a wanted motion of the plate, and what of that motion they leave out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocitySolution {
    /// The joint speeds.
    pub joints: JointVelocities,
    /// Wanted minus achieved rates of n1 and n2, in rad/s: exactly zero away from the straight wrist. The velocity of
    /// the tip has no shortfall.
    pub shortfall_rad_s: [f64; 2],
}

impl Arm {
    /// The joint speeds that move the plate with `velocity` at `joints`.
    ///
    /// The straight wrist (`theta_4 = 0`) is singular and lies inside the digging range. Only the twist joint is
    /// affected: its column of the Jacobian vanishes there like sin theta_4. So the other joints follow in closed
    /// form and the twist joint alone is damped, for `|sin theta_4|` below the configured region; what it does
    /// not deliver is made up by the base, shoulder and elbow, so that **the tip moves exactly as asked** and
    /// only the orientation falls short. In the arm's plane (`theta_3 = 0`) that concerns n2 alone; r, z and n1
    /// are undamped.
    ///
    /// # Errors
    /// [`KinematicsError::Singular`] if the tip is within 1 mm of the base axis, the elbow is straight or folded,
    /// the hand is at right angles to the arm's plane, or a damped motion would need a tip in line with the upper
    /// arm; [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if a number is not finite, an angle
    /// is above 1000 rad or a speed above 1e6 m/s or rad/s.
    pub fn inverse_velocity(
        &self,
        joints: &JointAngles,
        velocity: &TaskVelocity,
    ) -> Result<VelocitySolution, KinematicsError> {
        let [vx, vy, vz, n1_rate, n2_rate] = velocity.checked()?;
        let p = Posture::new(self, joints)?;
        check_cos_n2(p.cos_n2)?;
        check_radius(&p)?;
        let links = &self.config().links;
        let (l1, l2, l4) = (links.upper_arm_m, self.forearm_m(), links.hand_m);
        let [r, t, _] = p.tip;
        let [hand_r, sin_n2, hand_z] = p.hand;
        let [vr, vt, vz] = p.in_arm_plane([vx, vy, vz]);

        // Base first, then the wrist's velocity in the arm's plane: take away what the turning hand contributes.
        let base = (vt - l4 * p.cos_n2 * n2_rate) / r;
        let tilt = sin_n2 / p.cos_n2;
        let wrist_r = vr + t * base - l4 * (hand_z * n1_rate - tilt * hand_r * n2_rate);
        let wrist_z = vz + l4 * (hand_r * n1_rate + tilt * hand_z * n2_rate);
        let arm = [p.upper_arm, [p.wrist[0] - p.upper_arm[0], p.wrist[1] - p.upper_arm[1]]];
        let [shoulder, forearm] =
            two_bar(arm, p.s2, l1 * l2, [wrist_r, wrist_z], Singularity::StraightElbow, "|sin theta_2|")?;

        // The twist's column divided by sin theta_4 leaves a regular system: `grip` is sin(theta_4) theta_3'.
        let pitch = n1_rate - forearm;
        let grip = p.c3 / p.cos_n2 * n2_rate - p.c4 * p.s3 * pitch;
        let wrist = p.c3 * pitch + p.s3 * p.c4 / p.cos_n2 * n2_rate;
        let region = self.config().wrist_singularity;
        let nearness = p.s4 / region.sin_region;
        if nearness.abs() >= 1.0 {
            let rates = [base, shoulder, forearm - shoulder, grip / p.s4, wrist];
            return Ok(VelocitySolution { joints: JointVelocities(rates), shortfall_rad_s: [0.0; 2] });
        }
        let damping = region.damping * region.damping * (1.0 - nearness * nearness);
        let twist = grip * p.s4 / (p.s4 * p.s4 + damping);
        let missing = grip - p.s4 * twist;

        // What the tip lacks now, made up by the first three joints.
        let base_more = missing * l4 * p.c3 / r;
        let lack = [t * base_more - missing * l4 * p.s3 * p.c12, missing * l4 * p.s3 * p.s12];
        let (shoulder_more, forearm_more) = if missing * p.s3 == 0.0 {
            (0.0, 0.0)
        } else {
            let [shoulder, forearm] = p.tip_two_bar(l1, lack)?;
            (shoulder, forearm)
        };
        let shortfall_rad_s =
            [-missing * p.s3 * p.c4 / (p.cos_n2 * p.cos_n2) - forearm_more, missing * p.c3 / p.cos_n2];
        let elbow = (forearm + forearm_more) - (shoulder + shoulder_more);
        let rates = [base + base_more, shoulder + shoulder_more, elbow, twist, wrist];
        Ok(VelocitySolution { joints: JointVelocities(rates), shortfall_rad_s })
    }
}

pub(crate) fn check_radius(posture: &Posture) -> Result<(), KinematicsError> {
    let value = posture.tip[0].abs();
    if value >= LEAST_RADIUS_M {
        return Ok(());
    }
    let (place, measure) = (Singularity::BaseAxis, "|r'| in m");
    Err(KinematicsError::Singular { place, measure, value, least: LEAST_RADIUS_M })
}

impl Posture {
    /// Angular rates of upper arm and of all behind the elbow, taken as one piece, that move the tip by `[r, z]`.
    pub(crate) fn tip_two_bar(&self, l1: f64, velocity: [f64; 2]) -> Result<[f64; 2], KinematicsError> {
        let arm = [self.upper_arm, [self.tip[0] - self.upper_arm[0], self.tip[2] - self.upper_arm[1]]];
        let reach = l1 * libm::hypot(arm[1][0], arm[1][1]);
        let sine = if reach > 0.0 { (arm[1][0] * self.c1 - arm[1][1] * self.s1) * l1 / reach } else { 0.0 };
        let measure = "the sine between upper arm and elbow-to-tip";
        two_bar(arm, sine, reach, velocity, Singularity::TipInLine, measure)
    }
}

/// Angular rates of two bars in a row (vectors along r and z, angles from z towards r) for the velocity of their end.
///
/// `sine` is that of the angle from the first to the second, `product` that of their lengths.
fn two_bar(
    [first, second]: [[f64; 2]; 2],
    sine: f64,
    product: f64,
    [r, z]: [f64; 2],
    place: Singularity,
    measure: &'static str,
) -> Result<[f64; 2], KinematicsError> {
    if sine.abs() < LEAST_SINE {
        return Err(KinematicsError::Singular { place, measure, value: sine.abs(), least: LEAST_SINE });
    }
    let area = product * sine;
    Ok([(second[0] * r + second[1] * z) / area, -(first[0] * r + first[1] * z) / area])
}
