//! Whether a force rises beyond what the soil explains while a plate goes on: then something may be buried ahead.
//!
//! What the soil explains are strokes of the same kind: their force over the way, in depths, with its scatter. A stroke is looked at a fixed number of
//! times, once for each tenth of a depth, and alarms by a test of prediction (Student's t) that is shared out over the looks (Bonferroni): if the
//! scatter is normal, a stroke without anything ahead alarms with no more than the probability that was asked for, however neighbouring
//! looks hang together. Nothing of it is tuned. By bounds on the force near a rigid block ([`Ratios`]) an alarm says where it may be ([`region`]).

mod course;
mod expected;
mod ratios;
mod region;

pub use course::{CELL_DEPTHS, Course, CourseSample};
pub use expected::{Alarm, Expected, FEWEST_REFERENCES, Judged, Look, Test};
pub use ratios::{Ratio, Ratios};
pub use region::{Place, Region, region};
