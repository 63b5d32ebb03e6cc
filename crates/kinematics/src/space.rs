//! Vectors in joint space, motor space and task space: types of their own, so that one is never taken for another.

use serde::{Deserialize, Serialize};

use crate::KinematicsError;
use crate::error::check_size;

/// Angles beyond this are no posture but a fault: 1000 rad is 159 turns, and the sine of larger angles loses digits
/// that the arm needs.
pub(crate) const MOST_RADIANS: f64 = 1000.0;
/// Largest speed, force or torque accepted, in SI units.
const MOST_RATE: f64 = 1e6;

macro_rules! vector {
    ($(#[$doc:meta])* $name:ident, $quantity:literal, $most:expr, $unit:literal, $allowed:literal) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
        #[serde(transparent)]
        pub struct $name(pub [f64; 5]);

        impl $name {
            /// Refuses NaN, infinities and absurd sizes, so that what is computed from it is finite.
            pub(crate) fn checked(&self) -> Result<[f64; 5], KinematicsError> {
                check_size($quantity, &self.0, $most, $unit, $allowed)?;
                Ok(self.0)
            }
        }
    };
}

macro_rules! degrees {
    ($name:ident) => {
        impl $name {
            /// From degrees.
            #[must_use]
            pub fn from_degrees(degrees: [f64; 5]) -> Self {
                Self(degrees.map(f64::to_radians))
            }

            /// In degrees.
            #[must_use]
            pub fn degrees(&self) -> [f64; 5] {
                self.0.map(f64::to_degrees)
            }
        }
    };
}

vector!(
    /// Joint angles theta_0 to theta_4 in rad. Valid: finite, at most 1000 rad.
    JointAngles, "joint angle", MOST_RADIANS, "rad", "between -1000 and 1000 rad"
);
vector!(
    /// Joint speeds in rad/s. Valid: finite, at most 1e6 rad/s.
    JointVelocities, "joint velocity", MOST_RATE, "rad/s", "between -1e6 and 1e6 rad/s"
);
vector!(
    /// Joint torques in N m, positive in the direction of the joint's angle. Valid: finite, at most 1e6 N m.
    JointTorques, "joint torque", MOST_RATE, "N m", "between -1e6 and 1e6 N m"
);
vector!(
    /// Motor angles in rad, behind gearhead and capstan: for base, shoulder and wrist one unit is one radian of the
    /// joint. Elements 2 and 3 are the two motors of the elbow differential. Valid: finite, at most 1000 rad.
    MotorAngles, "motor angle", MOST_RADIANS, "rad", "between -1000 and 1000 rad"
);
vector!(
    /// Motor speeds in rad/s, in the same place as [`MotorAngles`]. Valid: finite, at most 1e6 rad/s.
    MotorVelocities, "motor velocity", MOST_RATE, "rad/s", "between -1e6 and 1e6 rad/s"
);
vector!(
    /// Motor torques in N m, in the same place as [`MotorAngles`]. Valid: finite, at most 1e6 N m.
    MotorTorques, "motor torque", MOST_RATE, "N m", "between -1e6 and 1e6 N m"
);
vector!(
    /// Rates of x, y, z in m/s and of n1, n2 in rad/s; also a small displacement in m and rad. Valid: finite,
    /// at most 1e6.
    TaskVelocity, "task velocity", MOST_RATE, "m/s or rad/s", "between -1e6 and 1e6 m/s or rad/s"
);
vector!(
    /// Forces along x, y, z in N and moments that work on n1, n2 in N m. Valid: finite, at most 1e6.
    TaskForce, "task force", MOST_RATE, "N or N m", "between -1e6 and 1e6 N or N m"
);
degrees!(JointAngles);
degrees!(MotorAngles);
