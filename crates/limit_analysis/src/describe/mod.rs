//! Problems as people write them: regions of soil, boundaries, structures, water, an objective, in a file or as structs.
//!
//! A [`Description`] is in metres, kPa and degrees and may be drawn as is convenient: polygons either way round, edges
//! that are cut differently on both sides, a water table anywhere. [`Description::described`] turns it into the
//! [`Statement`](soilctl_certificate::Statement) that is solved and proven:
//!
//! 1. `segments.rs` makes coordinates equal that differ by rounding only, `arrangement.rs` cuts all lines where they meet.
//! 2. `ground.rs` finds what is on either side of each piece and drops what bounds nothing; `faces.rs` walks around what is
//!    left. So T-junctions, plates and bodies cut out of the soil need no case of their own.
//! 3. `columns.rs` adds the vertical cuts that proofs need; `holds.rs` finds the condition on each boundary side.
//! 4. Where heads are given, `seepage/` finds how the water flows, and regions are cut so that its pressure is linear in each; `heads.rs`
//!    tells where open water stands.
//! 5. `size.rs` chooses units, `fill.rs`, `members.rs` and `convert.rs` write the statement.
//!
//! A description with load cases or sweeps stands for several: `cases/` makes them.

mod arrangement;
mod cases;
mod check;
mod columns;
mod convert;
mod described;
mod entry_place;
mod error;
mod faces;
mod file;
mod fill;
mod ground;
mod heads;
mod holds;
mod input;
mod members;
mod parts;
mod plan;
mod pullout;
mod ready;
mod reduce;
mod seepage;
mod segments;
mod size;
mod strength;

pub use cases::{Approach, Case, CaseEntry, Effect, Factors, MOST_CASES, Setting, SweepEntry};
pub use described::{Described, Quantity};
pub use entry_place::{Entry, Place, Section};
pub use error::DescriptionError;
pub use file::PROBLEM_SCHEMA;
pub use input::{
    Aim, AnisotropyEntry, Description, HeadEntry, RegionEntry, Seepage, Seismic, SoilEntry, Water,
};
pub use parts::{
    Action, BoundaryEntry, Hold, Interface, Kind, MemberEnd, MemberEntry, PlateEntry, Profile, Side,
    SoilInterface, StructureEntry,
};
pub(crate) use seepage::PoreField;
pub use seepage::{FlowUnit, Flowed, HeadFlow};
pub use strength::StrengthLaw;
pub(crate) use strength::greatest_phi_deg;
