//! The plate (90, 40, 25) against what a user would otherwise do, in one run: `cargo bench -p soilctl-limit-analysis --bench
//! peers`. Needs Python 3.11 with venv and, at first, the package index.
//!
//! - ours: cones on adapted meshes, proven bounds, one thread;
//! - the same kind of programs in Python (cvxpy with Clarabel) on a uniform mesh, nothing proven;
//! - cones cut down to pyramids of 36 sides, a linear program: ours by Clarabel, the Python one by HiGHS in limited time;
//! - Chen and Liu's closed form.
#![allow(clippy::print_stdout, reason = "a benchmark's answer")]
#![allow(clippy::unwrap_used, reason = "a benchmark may stop")]

#[path = "peers/environment.rs"]
mod environment;

use std::path::Path;
use std::process::Command;

use soilctl_earth_pressure::{Case, ChenLiu, ForceModel};
use soilctl_limit_analysis::{EmbeddedPlate, Options, Solve, bound};

const PLATE: EmbeddedPlate = EmbeddedPlate {
    alpha_deg: 90.0,
    beta_deg: 0.0,
    phi_deg: 40.0,
    delta_deg: 25.0,
    cohesion: 0.0,
    adhesion: 0.0,
    surcharge: 0.0,
};

/// Horizontal force in units of unit weight times length squared, to the coefficient of the inclined force.
fn row(name: &str, bound: &str, elements: usize, value: Option<f64>, seconds: f64) {
    let factor = 2.0 / (PLATE.alpha_deg + PLATE.delta_deg).to_radians().sin();
    let value = value.map_or_else(|| "none".to_owned(), |v| format!("{:.3}", factor * v));
    println!("{name:<34} {bound:<6} {elements:>6} {value:>9} {seconds:>8.1} s");
}

fn ours(name: &str, options: &Options) {
    let print = |kind: &str, s: &Solve| row(name, kind, s.elements, s.proven, s.seconds + s.proof_seconds);
    let start = std::time::Instant::now();
    let result = bound(&PLATE.problem().unwrap(), options, &mut |level, _| {
        print("upper", &level.upper);
        if let Some(lower) = &level.lower {
            print("lower", lower);
        }
    });
    match result {
        Ok(b) => println!("{name}: gap {:.2} % in {:.1} s", 100.0 * b.gap(), b.seconds),
        Err(e) => println!("{name}: {e} ({:.1} s)", start.elapsed().as_secs_f64()),
    }
}

fn uniform(python: &Path, folder: &Path, name: &str, arguments: &[&str]) {
    let output = Command::new(python).arg(folder.join("uniform_plate.py")).args(arguments).output().unwrap();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        let elements = line["elements"].as_u64().unwrap() as usize;
        // Also "optimal_inaccurate": nothing is proven there anyway.
        let done = line["status"].as_str().is_some_and(|s| s.starts_with("optimal"));
        let value = line["value"].as_f64().filter(|_| done);
        row(name, line["bound"].as_str().unwrap(), elements, value, line["seconds"].as_f64().unwrap());
    }
}

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers");
    let python = environment::python(&folder);
    println!("{:<34} {:<6} {:>6} {:>9} {:>10}", "what", "bound", "elem.", "K", "time");
    let chen = ChenLiu.predict(&Case::level_deg(90.0, 40.0, 25.0)).unwrap().k_net().0;
    println!("{:<34} {:<6} {:>6} {chen:>9.3}", "Chen and Liu", "upper", "");
    let limits = Options { max_gap: 0.0, max_work: u64::MAX, ..Options::default() };
    ours("ours, cones", &Options { max_elements: 5000, ..limits.clone() });
    uniform(&python, &folder, "cvxpy, Clarabel, uniform", &["--per-unit", "8"]);
    uniform(&python, &folder, "cvxpy, Clarabel, uniform", &["--per-unit", "16"]);
    ours("ours, pyramids of 36, Clarabel", &Options { max_elements: 900, segments: Some(36), ..limits });
    let linear = ["--per-unit", "4", "--segments", "36", "--seconds", "60"];
    uniform(&python, &folder, "cvxpy, Clarabel, pyramids of 36", &linear);
    uniform(
        &python,
        &folder,
        "cvxpy, HiGHS, pyramids of 36",
        &[&linear[..], &["--solver", "HIGHS"]].concat(),
    );
}
