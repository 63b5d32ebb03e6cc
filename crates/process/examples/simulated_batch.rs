//! Writes the log of a simulated batch, and on stdout what only the simulation knows of its strokes, as CSV:
//! `cargo run -p soilctl-process --example simulated_batch -- PATH SOIL RADIUS_M SEED TRUTH_SCALE BASE,ALPHA,SLANT,DELTA...`
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, reason = "an example")]

#[path = "../tests/simulated/mod.rs"]
mod simulated;

use simulated::Wanted;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize| args[place].parse::<f64>().expect("a number");
    let strokes: Vec<Wanted> = args[5..]
        .iter()
        .map(|text| {
            let v: Vec<f64> = text.split(',').map(|part| part.parse().expect("a number")).collect();
            Wanted { base_deg: v[0], alpha_deg: v[1], slant_m: v[2], delta_deg: v[3] }
        })
        .collect();
    let seed = args[3].parse().expect("a whole number");
    let found = simulated::batch(args[0].as_ref(), &args[1], number(2), &strokes, seed, number(4));
    println!("depth_m,failure_n,limit_n,failure_depth_m,failure_alpha_deg");
    for s in found {
        println!("{},{},{},{},{}", s.depth_m, s.failure_n, s.limit_n, s.failure_depth_m, s.failure_alpha_deg);
    }
}
