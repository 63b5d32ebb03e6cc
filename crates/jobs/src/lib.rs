#![doc = include_str!("../README.md")]

mod canonical;
mod error;
mod journal;
mod save;
mod shard;
mod store;
mod team;

pub use canonical::{canonical, fnv1a, sha256};
pub use error::JobsError;
pub use journal::{Inputs, Journal};
pub use save::{Beside, write_atomically};
pub use shard::Shard;
pub use store::{Job, Store};
pub use team::each;
