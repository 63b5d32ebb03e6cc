//! A log: read once, kept small, played by each page for itself.

mod load;
mod player;
mod sample;
mod track;

pub(crate) use load::load;
pub(crate) use player::Player;
pub(crate) use track::Track;
