//! A driver of one's own in a process of its own, behind a socket. The reference is `docs/live.md`.

mod frames;
mod serve;
mod socket;

pub use crate::frame::FrameError;
pub use frames::{DRIVE_BYTES, DRIVER_VERSION, DriveFrame, READINGS_BYTES, ReadingsFrame};
pub use serve::{DriverServer, ServeError};
pub use socket::{Exchanges, SocketDriver};
