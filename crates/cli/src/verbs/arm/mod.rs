//! `soilctl arm`: what the arm and its controller's settings are like, without moving anything.

mod figure;
mod skewing;

use std::path::{Path, PathBuf};

use clap::Subcommand;
use schemars::JsonSchema;
use serde::Serialize;
pub(crate) use skewing::SkewingAnswer;
use soilctl_kinematics::{Arm, urdf};

use super::Outcome;
use crate::error::CliError;
use crate::output::{Answer, Output};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Without --arm the arm is that of the thesis, without --controller the settings are those that soilctl brings \
    along."
)]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// By how much joint springs turn the plate's force away from where the plate is to go, and Cartesian springs do not
    Skewing(skewing::Args),
    /// Prints the arm as a URDF, for viewers and ROS tools
    Urdf {
        /// Arm file (.toml)
        #[arg(long, value_name = "FILE")]
        arm: Option<PathBuf>,
    },
}

/// An arm as a URDF.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct UrdfAnswer {
    /// The URDF document.
    urdf: String,
}

impl Answer for UrdfAnswer {
    const SCHEMA: &'static str = "soilctl.arm-urdf/1";

    fn text(&self) -> String {
        self.urdf.clone()
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    match &args.action {
        Action::Skewing(args) => skewing::run(args, output)?,
        Action::Urdf { arm } => output.answer(&UrdfAnswer { urdf: urdf(&read(arm.as_deref())?) })?,
    }
    Ok(Outcome::Done)
}

fn read(path: Option<&Path>) -> Result<Arm, CliError> {
    Ok(path.map_or_else(|| Ok(Arm::thesis()), Arm::read)?)
}
