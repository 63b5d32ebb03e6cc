//! What a recording of any robot tells: free air, contacts, and the forces at which soil failed.
//!
//! ```sh
//! cargo run -p soilctl-process --example foreign_log -- bag.mcap arm.urdf blade_edge 0.08 0.1
//! ```

#![allow(clippy::print_stdout, reason = "it is for reading")]

use std::error::Error;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_process::log::{Candidate, LogSettings, read_log};
use soilctl_process::table::StrokeRecord;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [bag, urdf, plate, surface_z_m, width_m, rest @ ..] = arguments.as_slice() else {
        return Err("give: BAG URDF PLATE_LINK SURFACE_Z WIDTH [START END]...".into());
    };
    let times: Vec<f64> = rest.iter().map(|text| text.parse()).collect::<Result<_, _>>()?;
    let windows: Vec<[f64; 2]> = times.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
    let settings = LogSettings {
        // Without a URDF the one in the log counts; a log of soilctl says all of this itself.
        urdf: (urdf != "-").then(|| std::fs::read_to_string(urdf)).transpose()?,
        plate_frame: Some(plate.clone()),
        surface_z_m: Some(surface_z_m.parse()?),
        width_m: Some(width_m.parse()?),
        windows: (!windows.is_empty()).then_some(windows),
        ..LogSettings::default()
    };
    let mut lines = Vec::new();
    let log = read_log(Path::new(bag), &settings, &AtomicBool::new(false), &mut |found| match found {
        Candidate::Rejected(no) => lines.push(format!("none {:.2} {:.2} {}", no.from_s, no.to_s, no.reason)),
        Candidate::Stroke(stroke) => {
            let number = lines.len().to_string();
            lines.push(match StrokeRecord::new(&stroke, number, bag.clone()) {
                Ok(record) => format!("stroke {}", serde_json::to_string(&record).unwrap_or_default()),
                Err(reason) => format!("none {:.2} {:.2} {reason}", stroke.start_s, stroke.end_s),
            });
        }
    })?;
    if let Some(foreign) = log.foreign {
        println!("air {:?}", foreign.air);
        foreign.troubles.iter().for_each(|trouble| println!("trouble {trouble}"));
        foreign.contacts.iter().for_each(|contact| println!("contact {contact:?}"));
    }
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
