//! A recording of any program: joint states, a URDF, and wrenches if there are any.

mod load;
mod track;

pub(super) use load::load;
pub(crate) use track::Track;
