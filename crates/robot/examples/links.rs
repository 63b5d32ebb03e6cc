//! Prints where the links of a robot are: `links robot.urdf shoulder=0.5 elbow=1.2`; without a file, those of our arm.
#![allow(clippy::print_stdout, reason = "a program")]
use std::collections::BTreeMap;
use std::error::Error;

use soilctl_kinematics::{Arm, urdf};
use soilctl_robot::Urdf;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).peekable();
    let text = match arguments.next_if(|argument| !argument.contains('=')) {
        Some(file) => std::fs::read_to_string(file)?,
        None => urdf(&Arm::thesis()),
    };
    let mut positions = BTreeMap::new();
    for argument in arguments {
        let (joint, value) =
            argument.split_once('=').ok_or("a position is written joint=0.5, in rad or m")?;
        positions.insert(joint.to_owned(), value.parse::<f64>()?);
    }

    let robot = Urdf::parse(&text)?;
    let poses = robot.link_poses(&|joint| positions.get(joint).copied());
    for (link, pose) in robot.links().iter().zip(poses) {
        let place = pose.map_or_else(
            || "nowhere: it hangs on a joint without a position".to_owned(),
            |pose| {
                let [x, y, z]: [f64; 3] = pose.translation.vector.into();
                format!("{x:8.4} {y:8.4} {z:8.4} m")
            },
        );
        println!("{:20} {place}", link.name);
    }
    for note in robot.notes() {
        println!("note: {note}");
    }
    Ok(())
}
