//! HTTP and WebSocket on one port.

mod guard;
mod head;
mod page;
mod response;
mod server;
mod shared;
mod socket;

pub(crate) use guard::Guard;
pub(crate) use server::{Server, random_hex};
pub(crate) use shared::Shared;
