#![doc = include_str!("../README.md")]

mod cell;
mod column;
mod declare;
mod error;
mod parquet_table;
mod range;
mod writer;

pub use cell::{Cell, Kind};
pub use column::{About, Column, Columns, Field, Source, markdown};
pub use error::ColumnsError;
pub use range::Range;
pub use writer::{Form, TableWriter};
