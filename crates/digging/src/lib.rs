#![doc = include_str!("../README.md")]

mod choice;
mod error;
mod excavation;
mod forces;
mod insertion;
mod learn;
mod load;
mod machine;
mod soils;
mod stance;
mod surface;
mod trench;

pub use choice::{Aim, Cost, Task};
pub use error::DiggingError;
pub use excavation::{End, Excavation, Made, again, excavate};
pub use forces::{Bite, Borne, Contact, borne, sliding_n};
pub use insertion::insertion_n;
pub use learn::{Knowledge, Taught};
pub use load::{Load, Push, load};
pub use machine::{Dug, Machine, Sample};
pub use soils::Soils;
pub use stance::{Way, way};
pub use surface::Surface;
pub use trench::{Pass, Rules, Trench, next_pass, passes};
