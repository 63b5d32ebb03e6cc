//! A device that leads the plate by hand and feels the soil's force, behind a socket of its own at the rate of the controller. The
//! reference is `docs/dig.md`.

mod device;
mod frames;

pub(crate) use device::{DeviceReport, Devices};
pub use frames::{DEVICE_HAND, HAND_BYTES, HandFlags, HandFrame, TOUCH_BYTES, TouchFrame};
