#![doc = include_str!("../README.md")]

mod bounds;
mod chain;
mod error;
mod mimic;
mod model;
mod notes;
mod numbers;
mod poses;
mod read;
mod tree;
mod turn;
mod urdf;
mod words;
mod xml;

pub use bounds::{MOST_BYTES, MOST_DEPTH, MOST_LINKS, MOST_SIZE};
pub use chain::Chain;
pub use error::RobotError;
pub use model::{Geometry, Joint, JointKind, Limits, Link, Mimic, Visual};
pub use urdf::Urdf;
