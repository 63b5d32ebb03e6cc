//! Pore pressures of water that flows, as a statement takes them: linear in each of some triangles.
//!
//! The flow is found on triangles that are each cut into sixteen, in the end into sixty-four, and its pressures at the corners of the large ones are kept
//! (`field.rs`). Two more rounds make triangles smaller where the pressure between corners was missed (`mesh.rs`). Bounds are
//! proven for the pressures as kept; how far these are from those of the finer triangles is told with the flow.

mod field;
mod flowed;
mod mesh;

pub(crate) use field::PoreField;
pub(super) use field::Uncut;
pub use flowed::{FlowUnit, Flowed, HeadFlow};
