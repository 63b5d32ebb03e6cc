use serde::{Deserialize, Serialize};

use crate::KinematicsError;
use crate::error::check_size;

/// Position of the plate and the two angles of the hand: what the five joints can choose.
///
/// The position is that of the middle of the plate's lower edge in the base frame (on the table, below the shoulder,
/// x forwards, z up). `n1` is the pitch of the hand from the upward vertical in the arm's plane: at 180 degrees the
/// plate hangs straight down. `n2` is how far the hand leaves that plane; 0 keeps the lower edge level.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct TaskPose {
    /// Forwards, in m.
    pub x_m: f64,
    /// To the left, in m.
    pub y_m: f64,
    /// Up, in m.
    pub z_m: f64,
    /// Pitch in rad (eq. B.7); not reduced to one turn.
    pub n1_rad: f64,
    /// Out-of-plane angle in rad, -pi/2 to pi/2 (eq. B.8).
    pub n2_rad: f64,
}

impl TaskPose {
    /// A digging pose: radius from the base axis (m), base angle (rad), height (m) and tool angle alpha (rad),
    /// with a level lower edge.
    ///
    /// alpha is measured from the horizontal; below 90 degrees the lower edge is nearer to the base than the
    /// upper one, which is ahead, since strokes go towards the base: `n1 = 270 deg - alpha`.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if a number is no length or angle.
    pub fn digging(
        radius_m: f64,
        base_rad: f64,
        height_m: f64,
        tool_angle_rad: f64,
    ) -> Result<Self, KinematicsError> {
        check_size("radius or height", &[radius_m, height_m], 100.0, "m", "between -100 and 100 m")?;
        let angles = [base_rad, tool_angle_rad];
        check_size("base angle or tool angle", &angles, 10.0, "rad", "between -10 and 10 rad")?;
        let (sin, cos) = libm::sincos(base_rad);
        Ok(Self {
            x_m: radius_m * cos,
            y_m: radius_m * sin,
            z_m: height_m,
            n1_rad: 1.5 * std::f64::consts::PI - tool_angle_rad,
            n2_rad: 0.0,
        })
    }

    /// Tool angle alpha in rad, `270 deg - n1`, of a plate that strokes towards the base.
    #[must_use]
    pub fn tool_angle_rad(&self) -> f64 {
        1.5 * std::f64::consts::PI - self.n1_rad
    }

    /// x, y, z in m.
    #[must_use]
    pub const fn position_m(&self) -> [f64; 3] {
        [self.x_m, self.y_m, self.z_m]
    }
}
