//! Structures of finite width: what is proven in space.
//!
//! - [`plate`] reads from a statement what kind of structure is covered: a thin straight plate from the surface of a
//!   half-space of one soil downwards.
//! - [`mechanism`] proves an upper bound by rigid blocks in translation.
//! - [`splice`] has what a lower bound in plane strain must obey besides, so that it holds for every width.

mod chain;
mod flow_rule;
mod mechanism;
mod plate;
mod position;
mod splice;
#[cfg(test)]
mod tests;

pub use mechanism::{prove_mechanism, show_mechanism};
pub(crate) use splice::{Splice, SpliceLimit};
