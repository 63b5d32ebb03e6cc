#![doc = include_str!("../README.md")]

mod cdr;
mod error;
mod export;
mod fields;
mod frames;
mod info;
mod keyframe;
mod logger;
pub mod messages;
mod own;
pub mod read;
mod record;
mod recover;
mod replay;
mod setup;
mod strokes;
pub mod topics;
mod write;

pub use error::SessionError;
pub use export::{Export, Row, TABLES, export, export_until, table_rows};
pub use info::{Info, TopicInfo, info, info_until};
pub use keyframe::KEYFRAME_VERSION;
pub use logger::{LogReport, Logger, Pace, Recorder};
pub use own::is_own;
pub use record::{KEYFRAME_STEPS, StepRecord, Truth};
pub use recover::{Recovery, recover, recover_until};
pub use replay::{Difference, Replay, replay, replay_until};
pub use setup::{
    CONFIGURATION_RECORD, Content, END_RECORD, FORMAT_VERSION, SESSION_RECORD, STROKE_RECORD, SessionSetup,
};
pub use soilctl_columns::{Cell, Form};
pub use write::LogWriter;
