//! Shear-box records: from force against displacement to one friction angle a load.
//!
//! The steps are those of Hong (2001), appendix D: zero of the load cell off, half the friction loop off,
//! three-point moving average at low loads, peak of `atan(tau / sigma)`, the closest three of four runs.

mod analysis;
mod friction_loop;
mod peak;
mod run;
mod select;
mod settings;

pub use analysis::{LoadSummary, RawAnalysis, analyse_runs};
pub use friction_loop::{FrictionLoop, parse_friction_loop, read_friction_loop};
pub use peak::{RunResult, TraceSample};
pub use run::{RawRun, RawSample, parse_runs, read_runs};
pub use settings::{RawSettings, ShearBox};
