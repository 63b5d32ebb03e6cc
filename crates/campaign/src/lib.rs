#![doc = include_str!("../README.md")]

mod describe;
mod effects;
mod error;
mod journal;
mod plan;
mod run;
mod seed;
mod setting;
mod step;
mod truth;
mod unlike;

pub use error::CampaignError;
pub use journal::BatchReport;
pub use plan::{Plan, demonstration, file};
pub use run::{Notice, Options, Report, logged_truth, simulate};
pub use setting::Setting;
pub use soilctl_plant::{SoilPreset, presets};
pub use soilctl_session::Content;
pub use truth::{BatchTruth, StrokeTruth, TrueFailure, read_truth};
pub use unlike::{default_plant, unlike_plant};
