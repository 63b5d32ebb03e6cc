//! Measured strokes in and out of files: the stroke table `strokes.csv` and the campaign description
//! `campaign.json` beside it.
//!
//! [`StrokeTable`] is one row a stroke, typed and checked; columns it does not know are kept as text.
//! [`measurements`] turns rows into what an estimator needs: a force with its standard deviation for each
//! geometry. [`TraceTable`] is the recorded course of each stroke, `traces.csv`. [`Campaign`] is what was known about the instrument and the preparation. Units are in the names;
//! every error says where, which value, what is allowed and what to do.
//!
//! ```
//! use soilctl_strokes::{ReadOptions, StrokeTable, Uncertainty, measurements};
//!
//! let csv = "alpha_deg,depth_m,width_m,force_n\n80,0.025,0.127,5.1\n80,0.025,0.127,5.5\n";
//! let table = StrokeTable::from_reader(csv.as_bytes(), "strokes.csv", ReadOptions::default())?;
//! let found = measurements(&table, Uncertainty::Required)?;
//! assert_eq!(found[0].label, "80 deg, 25 mm");
//! assert!((found[0].force_n - 5.3).abs() < 1e-12 && found[0].count == 2);
//! # Ok::<(), soilctl_strokes::StrokesError>(())
//! ```

mod allowed;
mod campaign;
mod campaign_json;
mod cell;
mod columns;
mod error;
mod header;
mod line_guard;
mod measurements;
mod read;
mod row;
mod spread;
mod table;
mod text_column;
mod traces;
mod write;

pub use campaign::{Campaign, Instrument};
pub use error::{Place, StrokesError};
pub use measurements::{Measurement, Uncertainty, measurements};
pub use read::{MAX_BYTES, MAX_ROWS, ReadOptions};
pub use row::StrokeRow;
pub use table::StrokeTable;
pub use text_column::TextColumn;
pub use traces::{TraceSample, TraceTable};
