#![doc = include_str!("../README.md")]

mod change;
mod error;
mod map;
mod points;
mod read;
mod stroke;

pub use change::{Change, Shift, change};
pub use error::HeightsError;
pub use map::{Grid, HeightMap, MOST_CELLS, MOST_HEIGHT_M};
pub use read::{
    Cloud, Clouds, Format, Moment, Reading, Source, Taken, cloud, clouds, is_recording, of_cloud, read,
    read_after, read_clouds,
};
pub use stroke::{Break, NoBreak, Plate, Profile, Stroke, Volume, stroke};
