//! A driver of one's own in Rust: `cargo run -p soilctl-live --example driver -- SOCKET`, and then `soilctl run PLAN --driver
//! SOCKET --socket live`. What it drives here is the simulated arm without soil; put your arm behind [`Hardware`] instead.

use std::path::PathBuf;
use std::process::ExitCode;

use soilctl_controller::Sensed;
use soilctl_kinematics::JointAngles;
use soilctl_live::driver::DriverServer;
use soilctl_plant::{Drive, Hardware, Plant, PlantError, PlantParams};

/// The arm. A real one would hold its bus here.
struct Arm {
    plant: Plant,
}

impl Hardware for Arm {
    type Error = PlantError;

    /// Torques out, readings in. With amplifiers off the torques must not act.
    fn exchange(&mut self, drive: &Drive) -> Result<Sensed, PlantError> {
        self.plant.exchange(drive)
    }
}

fn main() -> ExitCode {
    let Some(socket) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("usage: driver SOCKET");
        return ExitCode::from(2);
    };
    match drive(&socket) {
        Ok(ticks) => {
            eprintln!("the session is over after {ticks} ticks");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

pub(crate) fn drive(socket: &std::path::Path) -> Result<u64, Box<dyn std::error::Error>> {
    let start = JointAngles::from_degrees([0.0, 40.0, 90.0, 0.0, 30.0]);
    let mut arm = Arm { plant: Plant::new(PlantParams::thesis(), None, &start, 1)? };
    let mut server = DriverServer::bind(socket)?;
    let ticks = server.serve(&mut arm)?;
    std::fs::remove_file(socket)?;
    Ok(ticks)
}
