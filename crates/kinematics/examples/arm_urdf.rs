//! Writes the URDF of an arm file, or of the thesis's arm, to standard output.
//!
//! ```sh
//! cargo run -p soilctl-kinematics --example arm_urdf -- data/arm/thesis.toml > arm.urdf
//! ```
#![allow(clippy::print_stdout)]

use std::path::Path;

use soilctl_kinematics::{Arm, KinematicsError, urdf};

fn main() -> Result<(), KinematicsError> {
    let arm = match std::env::args_os().nth(1) {
        Some(path) => Arm::read(Path::new(&path))?,
        None => Arm::thesis(),
    };
    print!("{}", urdf(&arm));
    Ok(())
}
