#![doc = include_str!("../README.md")]

mod campaign;
mod campaign_json;
mod cell;
mod error;
mod header;
mod line_guard;
mod measurements;
mod pooled;
mod read;
mod row;
mod spread;
mod stored;
mod table;
mod text_column;
mod traces;

pub use campaign::{Campaign, Instrument};
pub use error::{Place, StrokesError};
pub use measurements::{Measurement, Uncertainty, measurements};
pub use pooled::{Kind, Pool, PooledBand, pool};
pub use read::{MAX_BYTES, MAX_ROWS};
pub use row::StrokeRow;
pub use table::{ReadOptions, StrokeTable};
pub use text_column::TextColumn;
pub use traces::{TraceSample, TraceTable};
