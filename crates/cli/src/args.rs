//! The command line: global options, and those that several verbs call the same.

use clap::Parser;

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
