//! Estimates with unknown loads beside samplers, in one run: `cargo bench -p soilctl-estimator --bench samplers`. Needs
//! Python 3.11 with venv and, at first, the package index.
//!
//! An estimate encloses all that is consistent; a sampler sees some of it, and its ranges grow as it goes on. Told is how
//! long it takes until they are a share of the estimate's ranges in each unknown. Forces in Python have formulas of their own,
//! which are compared first.
#![allow(clippy::print_stdout, reason = "a benchmark's answer")]
#![allow(clippy::unwrap_used, reason = "a benchmark may stop")]

#[path = "../../limit_analysis/benches/peers/environment.rs"]
mod environment;

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use serde_json::{Map, Value, json};
use soilctl_earth_pressure::{Case, ForceModel, Loads, model};
use soilctl_estimator::{Observation, Quantity, Setup, Unknowns, estimate};
use soilctl_soil::{Angle, Interface, Plate, STANDARD_GRAVITY_M_S2, Soil};

/// How long a sampler may take, in s.
const SECONDS: f64 = 60.0;
const BAND: f64 = 0.05;
const PHI_DEG: f64 = 36.0;
const DELTA_DEG: (f64, f64) = (21.0, 23.0);
const DENSITY_KG_M3: f64 = 1600.0;
const SLOPE_DEG: f64 = 1.0;
const LOADS: Loads = Loads { cohesion_pa: 200.0, adhesion_pa: 60.0, surcharge_pa: 40.0 };

fn truth(quantity: Quantity) -> f64 {
    match quantity {
        Quantity::Friction => PHI_DEG,
        Quantity::InterfaceFriction => f64::midpoint(DELTA_DEG.0, DELTA_DEG.1),
        Quantity::Slope => SLOPE_DEG,
        Quantity::Density => DENSITY_KG_M3,
        Quantity::Cohesion => LOADS.cohesion_pa,
        Quantity::Adhesion => LOADS.adhesion_pa,
        Quantity::Surcharge => LOADS.surcharge_pa,
    }
}

/// Where a sampler may walk.
fn prior(quantity: Quantity, unknowns: &Unknowns) -> (f64, f64) {
    match quantity {
        Quantity::Friction => (20.0, 60.0),
        Quantity::InterfaceFriction => DELTA_DEG,
        Quantity::Slope => unknowns.slope_deg,
        Quantity::Density => (300.0, 4000.0),
        Quantity::Cohesion => unknowns.cohesion_pa,
        Quantity::Adhesion => unknowns.adhesion_pa(),
        Quantity::Surcharge => unknowns.surcharge_pa,
    }
}

/// Twelve strokes: four tool angles at three depths, and the force of each.
fn strokes(coulomb: &dyn ForceModel) -> Vec<(Plate, f64)> {
    let soil = Soil::new(Angle::from_degrees(PHI_DEG), DENSITY_KG_M3).unwrap();
    let interface =
        Interface::new(Angle::from_degrees(truth(Quantity::InterfaceFriction)), LOADS.adhesion_pa).unwrap();
    let mut found = Vec::new();
    for depth in [0.015, 0.03, 0.06] {
        for alpha in [65.0, 75.0, 85.0, 88.0] {
            let [alpha, slope] = [alpha, SLOPE_DEG].map(Angle::from_degrees);
            let plate = Plate::new(alpha, slope, depth, 0.127).unwrap();
            let prediction = coulomb.predict(&Case::of(&plate, &soil, &interface)).unwrap();
            found.push((plate, prediction.force_n(&plate, &soil, &LOADS)));
        }
    }
    found
}

fn samplers(python: &Path, folder: &Path, problem: &Value) {
    let mut child = Command::new(python)
        .arg(folder.join("samplers.py"))
        // One core, as the estimate.
        .envs([("OMP_NUM_THREADS", "1"), ("OPENBLAS_NUM_THREADS", "1")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(problem.to_string().as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let line: Value = serde_json::from_str(line).unwrap();
        let seconds: Vec<String> = line["seconds"]
            .as_array()
            .unwrap()
            .iter()
            .map(|s| s.as_f64().map_or_else(|| "-".to_owned(), |s| format!("{s:.2} s")))
            .collect();
        println!(
            "{:<38} {:>9} {:>9} {:>9} {:>9}   {:>10} soils, {:.1} % of the width, {:.3} % beyond",
            line["method"].as_str().unwrap(),
            seconds[0],
            seconds[1],
            seconds[2],
            seconds[3],
            line["soils"],
            100.0 * line["share"].as_f64().unwrap(),
            100.0 * line["beyond"].as_f64().unwrap().max(0.0),
        );
    }
}

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers");
    let python = environment::python(&folder);
    let coulomb = model("coulomb").unwrap();
    let strokes = strokes(&*coulomb);
    let observed = |(plate, force): &(Plate, f64)| {
        // Surfaces of observations are level: slopes are unknowns.
        let level = Plate::new(plate.tool_angle(), Angle::ZERO, plate.depth_m(), plate.width_m()).unwrap();
        Observation::new("stroke", level, *force, BAND * force).unwrap()
    };
    let observations: Vec<Observation> = strokes.iter().map(observed).collect();
    let known = Unknowns::known(&LOADS, SLOPE_DEG);
    let four = Unknowns { cohesion_pa: (0.0, 500.0), ..known };
    let five = Unknowns { surcharge_pa: (0.0, 100.0), ..four };
    let six = Unknowns { slope_deg: (-1.0, 3.0), ..five };
    println!(
        "{:<38} {:>9} {:>9} {:>9} {:>9}",
        "share of the estimate's ranges", "80 %", "90 %", "95 %", "99 %"
    );
    for (count, unknowns) in [(4, four), (5, five), (6, six)] {
        let mut setup = Setup::new(&*coulomb, observations.clone(), DELTA_DEG);
        setup.unknowns = Some(unknowns);
        let mut best = f64::INFINITY;
        let mut ranges = Vec::new();
        for _ in 0..5 {
            let start = Instant::now();
            ranges = estimate(&setup).unwrap().joint.unwrap().ranges;
            best = best.min(start.elapsed().as_secs_f64());
        }
        println!("\n{count} unknowns: the estimate, all of it: {best:.3} s");
        let names: Vec<String> = ranges.iter().map(|(quantity, _)| format!("{quantity:?}")).collect();
        let others = [
            Quantity::Friction,
            Quantity::InterfaceFriction,
            Quantity::Slope,
            Quantity::Density,
            Quantity::Cohesion,
            Quantity::Adhesion,
            Quantity::Surcharge,
        ];
        let known: Map<String, Value> = others
            .into_iter()
            .filter(|quantity| !names.contains(&format!("{quantity:?}")))
            .map(|quantity| (format!("{quantity:?}"), json!(truth(quantity))))
            .collect();
        let stroke = |((plate, force), observation): (&(Plate, f64), &Observation)| {
            json!({
                "alpha_deg": plate.tool_angle().degrees(),
                "slant_m": observation.plate().slant_length_m(),
                "width_m": plate.width_m(),
                "force_n": force,
                "low_n": observation.low_n(),
                "high_n": observation.high_n(),
            })
        };
        let problem = json!({
            "names": names,
            "known": known,
            "truth": ranges.iter().map(|(quantity, _)| truth(*quantity)).collect::<Vec<f64>>(),
            "ranges": ranges.iter().map(|(_, range)| range).collect::<Vec<_>>(),
            "prior": ranges.iter().map(|(quantity, _)| prior(*quantity, &unknowns)).collect::<Vec<_>>(),
            "strokes": strokes.iter().zip(&observations).map(stroke).collect::<Vec<_>>(),
            "gravity_m_s2": STANDARD_GRAVITY_M_S2,
            "seconds": SECONDS,
        });
        samplers(&python, &folder, &problem);
    }
}
