use std::fmt;

use serde::{Deserialize, Serialize};

/// A joint of the arm, from the base outwards; its number is the index of the thesis's theta.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Joint {
    /// theta_0: turns the arm's plane about the vertical.
    Base,
    /// theta_1: upper arm from the vertical, positive forwards and down.
    Shoulder,
    /// theta_2: forearm from the upper arm.
    Elbow,
    /// theta_3: twists the forearm about its own length.
    Twist,
    /// theta_4: hand from the forearm.
    Wrist,
}

impl Joint {
    /// All joints in order.
    pub const ALL: [Self; 5] = [Self::Base, Self::Shoulder, Self::Elbow, Self::Twist, Self::Wrist];

    /// Index into the arrays of the joint and motor types, 0 to 4.
    #[must_use]
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Name in files, messages and the URDF.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Base => "base",
            Self::Shoulder => "shoulder",
            Self::Elbow => "elbow",
            Self::Twist => "twist",
            Self::Wrist => "wrist",
        }
    }
}

impl fmt::Display for Joint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
