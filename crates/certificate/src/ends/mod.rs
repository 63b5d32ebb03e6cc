//! Structures of finite width: what is proven in space.
//!
//! - [`plate`] reads from a statement what kind of structure is covered: a thin straight plate from the surface of a
//!   half-space of one soil downwards.
//! - [`mechanism`] proves an upper bound by rigid blocks in translation.
//! - [`space`] proves a lower bound by a stress field in space about one end.
//! - [`splice`] has what a lower bound in plane strain must obey besides, so that it holds for every width.

mod chain;
mod flow_rule;
mod mechanism;
mod plate;
mod position;
mod space;
mod splice;
#[cfg(test)]
mod tests;

pub use mechanism::{prove_mechanism, show_mechanism};
pub use space::{
    EndForce, ShownFace, ShownPart, ShownSpace, SpaceSection, SpaceStress, prove_end, prove_space, show_space,
};
pub(crate) use splice::{Splice, SpliceLimit};
