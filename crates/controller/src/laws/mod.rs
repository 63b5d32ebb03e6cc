//! From wanted motion to joint torques.

mod accommodation;
pub(crate) mod hand;
mod lead;
mod pid;
mod safe_force;
mod skewing;
mod stiffness;

pub use accommodation::{accommodation_speed, beyond_dead_zone};
pub use lead::{LeadAngle, LeadBounds};
pub(crate) use pid::{joint_integral, joint_pid, velocity_pi};
pub use safe_force::SafeForceSet;
pub use skewing::Skew;
pub(crate) use stiffness::stiffness;
