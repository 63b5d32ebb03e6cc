#![doc = include_str!("../README.md")]

mod error;
mod guard;
mod head;
mod response;
mod secret;
mod server;
mod serving;
mod site;
mod socket;

pub use error::WebError;
pub use guard::Guard;
pub use secret::{is_same, random_hex};
pub use serving::{Counts, Port, Serving, Settings};
pub use site::{Content, Feed, Heard, Site};
