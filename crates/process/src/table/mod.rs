//! Processed strokes as files: the stroke table with what it says of each failure, and traces.

mod clock;
mod csv_file;
mod parquet_file;
mod record;
mod traces;

pub use clock::put_on_one_clock;
pub use csv_file::write_csv;
pub use parquet_file::write_parquet;
pub use record::StrokeRecord;
pub use traces::{TRACES_HEADER, write_trace};
