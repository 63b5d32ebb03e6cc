#![doc = include_str!("../README.md")]

mod commands;
pub mod config;
mod error;
mod estimate;
mod events;
mod fault;
pub mod laws;
mod monitor;
mod motion;
mod outputs;
mod params;
mod plan;
mod requests;
mod sensed;
pub mod sequence;
mod state;
mod step;
pub mod trajectory;
mod tuning;
mod validate;

pub use commands::{Commands, Request, Tunable};
pub use config::{ControllerConfig, StrokeLaw};
pub use error::ControllerError;
pub use estimate::Filters;
pub use events::{Event, EventKind, Events, Finish, MOST_EVENTS, Refusal, TrajectoryKind};
pub use fault::{Fault, FaultRecord, Mode};
pub use monitor::Monitors;
pub use outputs::{Outputs, Telemetry};
pub use params::{DEFAULT, Params, TICK_RATE_HZ, TICK_S};
pub use plan::{MOST_STROKES, StrokePlan, StrokeSpec};
pub use sensed::Sensed;
pub use sequence::SequenceId;
pub use state::{STATE_VERSION, State};
pub use step::step;
pub use trajectory::{HandLimit, HandTarget, Trajectory};
pub use tuning::Tuning;
