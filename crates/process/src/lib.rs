#![doc = include_str!("../README.md")]

pub mod ahead;
mod blocks;
mod campaign;
mod depth_law;
mod error;
mod failure;
pub mod foreign;
mod friction;
pub mod log;
mod recorded;
mod robot;
mod slip;
pub mod table;
mod trace;

pub use campaign::{
    AngleGroup, CampaignStatistics, CampaignStroke, Dependence, campaign_statistics, meant_angles_deg,
};
pub use depth_law::{DepthLaw, DepthPoint, depth_law};
pub use error::ProcessError;
pub use failure::{
    Analysis, Change, Evidence, FailurePoint, FailureSettings, ForceNoise, Indiscernible, Kind, Method,
    Outcome, Saturation, TwoLines, failure_force,
};
pub use friction::{
    RubbingPeak, SWEEP_ALPHA_DEG, SweepEstimate, SweepStroke, interface_friction, rubbing_peak,
};
pub use recorded::{Evaluated, Recorded, Setting, evaluate};
pub use robot::{Robot, RobotSample};
pub use slip::Slip;
pub use trace::{Channels, FEWEST_SAMPLES, Trace};
