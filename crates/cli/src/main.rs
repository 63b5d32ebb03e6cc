//! The program `soilctl`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(soilctl_cli::run(std::env::args_os()))
}
