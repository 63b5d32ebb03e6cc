//! A log of our own controller.

mod load;
mod reel;
mod sample;
mod track;

pub(super) use load::load;
pub(super) use reel::OwnReel;
pub(crate) use track::Track;
