#![doc = include_str!("../README.md")]

mod arm;
mod clock;
mod columns;
mod error;
mod gaps;
mod inspect;
mod joints;
mod look;
mod meshes;
mod table;
mod trouble;
mod units;

pub use arm::{Motion, Settings, State, motion};
pub use clock::{Clock, Repaired, Step, Times, WALL_CLOCK_S, repair};
pub use columns::{Columns, Series, Wanted, columns};
pub use error::MotionError;
pub use gaps::TopicClock;
pub use inspect::{Inspection, TopicReport, inspect};
pub use joints::{Joints, usual_interval};
pub use look::{Look, look};
pub use meshes::meshes;
pub use soilctl_mesh::{Mesh, Part, Sought};
pub use table::{Header, Table, table, write_table};
pub use trouble::{Oddity, Trouble};
pub use units::{MOST_M, MOST_RAD};
