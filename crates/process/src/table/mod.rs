//! Processed strokes as files: the stroke table with what it says of each failure, and traces.

mod at_failure;
mod clock;
mod files;
mod record;

pub use clock::put_on_one_clock;
pub use files::{write_table, write_trace};
pub use record::{FailureRow, StrokeRecord};
pub use soilctl_columns::Form;
