//! The command line: global options, and those that several verbs call the same.

use std::path::{Path, PathBuf};

use clap::Parser;
pub(crate) use soilctl_app::request::finite;

use crate::error::CliError;
use crate::output::Format;
use crate::verbs::Verb;

/// From the force at which a plate fails soil to the soil's friction angle and density.
///
/// Angles are in degrees, everything else in SI units. Exit codes: 0 done; 1 done, and the answer is negative;
/// 2 wrong usage or bad input; 3 done in part.
#[derive(Debug, Parser)]
#[command(name = "soilctl", version, subcommand_required = true, arg_required_else_help = false)]
pub(crate) struct Cli {
    /// Form of the answer on stdout
    #[arg(long, global = true, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,

    /// No progress and no notes on stderr
    #[arg(long, global = true)]
    pub(crate) quiet: bool,

    #[command(subcommand)]
    pub(crate) verb: Verb,
}

/// Where the joints, forces and links of a bag of another program are.
#[derive(Debug, Clone, Default, clap::Args)]
pub(crate) struct TopicArgs {
    /// Topic of the joint states [default: /joint_states, or the only one]
    #[arg(long, value_name = "TOPIC")]
    pub(crate) joint_topic: Option<String>,

    /// Topic of the wrenches of soil on plate [default: /wrench, or the only one]
    #[arg(long, value_name = "TOPIC")]
    pub(crate) wrench_topic: Option<String>,

    /// URDF of the arm [default: the one in the bag]
    #[arg(long, value_name = "FILE")]
    pub(crate) urdf: Option<PathBuf>,

    /// Link of the wrenches [default: the frame in their headers]
    #[arg(long, value_name = "LINK")]
    pub(crate) sensor_frame: Option<String>,

    /// Height of the soil in the URDF's root frame (m)
    #[arg(long, value_name = "M", value_parser = finite, allow_negative_numbers = true)]
    pub(crate) surface_z: Option<f64>,
}

impl TopicArgs {
    /// The text of the URDF that was given.
    pub(crate) fn urdf_text(&self) -> Result<Option<String>, CliError> {
        self.urdf.as_deref().map(read_text).transpose()
    }
}

/// A text file that an option names.
pub(crate) fn read_text(path: &Path) -> Result<String, CliError> {
    std::fs::read_to_string(path)
        .map_err(|problem| CliError::File { path: path.display().to_string(), problem })
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::Cli;

    /// What clap checks of a command line only when it is used: names that clash, defaults that make no sense.
    #[test]
    fn options_of_all_verbs_go_together() {
        Cli::command().debug_assert();
    }
}
