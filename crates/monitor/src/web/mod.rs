//! HTTP and WebSocket on one port.

mod guard;
mod head;
mod page;
mod response;
mod server;
mod socket;

pub(crate) use guard::Guard;
pub(crate) use server::{Server, Shared, random_hex};
