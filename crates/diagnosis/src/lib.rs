#![doc = include_str!("../README.md")]

mod channels;
mod data;
mod diagnosis;
mod error;
mod explanation;
mod fit;
mod gap;
mod generic;
mod grid;
mod localise;
mod next;
mod parts;
mod patch;
mod search;
pub mod self_test;
mod settle;
mod setup;
mod spec;
mod surface;
mod tables;
mod testability;
mod traces;
mod verdict;

pub use data::{Data, Prior};
pub use diagnosis::{Diagnosis, FoundEffect, diagnose};
pub use error::DiagnosisError;
pub use explanation::{Dependence, Explanation};
pub use gap::{Comparison, FittedSoil, Gap};
pub use localise::Where;
pub use next::NextExperiment;
pub use parts::Part;
pub use surface::Surface;
pub use testability::{Expected, LEAST_LAMBDA, Testable};
pub use traces::{AddedTraces, Course, Phase, RecordedTraces, courses, typical_course};
pub use verdict::Status;
