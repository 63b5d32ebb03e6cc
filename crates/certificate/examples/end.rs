//! What a stress field in space about one end of a plate proves: `end FIELD.json`, with `phi_deg`, `delta_deg` and `stress`.

#![allow(clippy::print_stdout, reason = "an example shows what it finds")]

use std::time::Instant;

use serde::Deserialize;
use soilctl_certificate::{SpaceStress, prove_end};

#[derive(Deserialize)]
struct File {
    phi_deg: f64,
    delta_deg: f64,
    stress: SpaceStress,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        let file: File = serde_json::from_str(&std::fs::read_to_string(&path)?)?;
        let start = Instant::now();
        let proven = prove_end(file.phi_deg, file.delta_deg, &file.stress);
        println!("{path}: {} tetrahedra, {:.1?}", file.stress.tetrahedra.len(), start.elapsed());
        match proven {
            Ok(end) => {
                println!("{end:?}");
                let cos = file.delta_deg.to_radians().cos();
                for width in [2.0, 5.0, 10.0] {
                    println!("w/H = {width}: K = {:?}", end.per_width(width).map(|force| 2.0 * force / cos));
                }
            }
            Err(why) => println!("{why}"),
        }
    }
    Ok(())
}
