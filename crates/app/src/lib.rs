//! The use cases of soilctl, each a module with a `Request`, a function `run` and an `Answer`:
//!
//! ```text
//! Request (plain data, defaults, ranges)  ->  run(&request, &watch)  ->  Answer (plain data, JSON schema)
//! ```
//!
//! The command line turns arguments into requests and answers into words; Python binds the same types; figures and pages are
//! drawn from answers by the crate `pages`. Nothing here prints, draws or knows how it was called; what goes on during long work is
//! told to a [`Watch`].

mod answer;
pub mod arm;
pub mod bound;
pub mod certify;
pub mod demo;
pub mod diagnose;
mod error;
pub mod estimate;
pub mod files;
mod finite;
pub mod limits;
pub mod log;
pub mod predict;
pub mod process;
pub mod replay;
pub mod report;
pub mod request;
pub mod shear;
pub mod simulate;
pub mod solve;
pub mod table;
pub mod table_file;
mod table_source;
pub mod text;
pub mod topics;
mod use_cases;
mod watch;

pub use answer::{Answer, Outcome, document, schema};
pub use error::AppError;
pub use finite::check as check_finite;
pub use table_source::TableSource;
pub use use_cases::{USE_CASES, UseCase};
pub use watch::{Interrupted, Unwatched, Watch};
