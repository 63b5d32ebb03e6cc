//! The command line: global options and the soil and tool options that every verb calls the same.

use clap::Parser;
pub(crate) use soilctl_app::request::finite;
use soilctl_soil::STANDARD_GRAVITY_M_S2;

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

/// Loads on and properties of the soil, beside its friction and density.
#[derive(Debug, Clone, Copy, clap::Args)]
pub(crate) struct LoadArgs {
    /// Cohesion of the soil (Pa), at least 0
    #[arg(long, value_name = "PA", default_value_t = 0.0, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) cohesion: f64,

    /// Adhesion between soil and plate (Pa), at least 0
    #[arg(long, value_name = "PA", default_value_t = 0.0, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) adhesion: f64,

    /// Vertical pressure on the surface, on both sides of the plate (Pa), at least 0
    #[arg(long, value_name = "PA", default_value_t = 0.0, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) surcharge: f64,

    /// Gravity (m/s2), above 0
    #[arg(long, value_name = "M/S2", default_value_t = STANDARD_GRAVITY_M_S2, value_parser = finite,
          allow_negative_numbers = true)]
    pub(crate) gravity: f64,

    /// Slope of the surface (deg), positive when it rises ahead of the plate
    #[arg(long, value_name = "DEG", default_value_t = 0.0, value_parser = finite, allow_negative_numbers = true)]
    pub(crate) beta: f64,
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
