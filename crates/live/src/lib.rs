#![doc = include_str!("../README.md")]

mod client;
mod clock;
pub mod driver;
mod ending;
mod error;
mod frame;
pub mod hand;
mod host;
mod links;
pub mod local;
mod playback;
pub mod protocol;
mod real_time;
mod rig;
mod server;
mod servo;
mod timing;

pub use client::{Client, Commander};
pub use ending::Ending;
pub use error::LiveError;
pub use host::{Host, Report, Session, Stopper};
pub use playback::{Playback, Played};
pub use real_time::may_run_in_real_time;
pub use rig::Rig;
pub use timing::{BIN_ENDS_US, Histogram, Timing};
