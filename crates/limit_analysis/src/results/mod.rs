//! What a solution shows: flow, dissipation, stresses, contact stresses, failure surface, and files of them.
//!
//! Everything is computed from what certificates store, so a saved solution can be looked at as well as a fresh one. The
//! numbers are those that the proofs look at, but for rounding. They are in the units of the [`Statement`]: lengths in its
//! length, stresses in its unit weight times length, velocities in that of the structure, all per unit width.
//!
//! ```no_run
//! use soilctl_certificate::Solution;
//! use soilctl_limit_analysis::results::{FlowResults, MOVING, StressResults};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let solution = Solution::read("plate.json".as_ref())?;
//! if let Some(upper) = &solution.upper {
//!     let flow = FlowResults::new(&solution.statement, &upper.field)?;
//!     println!("{:?} {:?}", flow.velocity([0.5, -0.2]), flow.moving_ground(MOVING));
//! }
//! if let Some(lower) = &solution.lower {
//!     let stress = StressResults::new(&solution.statement, &lower.field)?;
//!     for contact in stress.contacts() {
//!         println!("{} on {} of length", contact.normal_force(), contact.length());
//!     }
//! }
//! # Ok(()) }
//! ```
//!
//! [`Statement`]: soilctl_certificate::Statement

mod boundary;
mod contact;
mod finder;
mod flow;
mod jumps;
mod members;
mod msh;
mod power;
mod reserve;
mod restored;
mod slip_stress;
mod strength;
mod stress;
mod surface;
#[cfg(test)]
mod tests;
mod units;
mod vtu;
mod vtu_file;
mod vtu_members;
mod vtu_space;
mod work;

pub use contact::{Contact, ContactPoint};
pub use flow::FlowResults;
pub use jumps::Jump;
pub use members::{BeamForces, Course, MemberForces, MemberStretch, farthest, greatest, least};
pub use power::Power;
pub use reserve::{Reserve, least_reserve};
pub use slip_stress::{SlipStress, slip_stress};
pub use stress::{Principal, StressResults};
pub use surface::{MOVING, Stretch};
pub use units::{Units, problem_units};
pub use vtu::write_vtu;
pub use vtu_members::write_members_vtu;
pub use vtu_space::{write_blocks_vtu, write_space_vtu};
pub use work::shear_work;

/// A point or a vector, x and y.
pub type Point = [f64; 2];
