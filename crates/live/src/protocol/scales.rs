//! How large forces and leads are drawn beside the arm, wherever it is shown.

/// Length of an arrow of force, in m a newton.
pub const FORCE_M_PER_N: f64 = 0.005;
/// Length of the lead's arrow over the lead.
pub const LEAD_SCALE: f64 = 5.0;
