//! Time and memory against the number of elements, up to 50 000: `cargo bench -p soilctl-limit-analysis --bench scaling`.
//!
//! One adaptive run of the plate (90, 40, 25) on one thread, without a gap to stop at. Each solve is timed on its own;
//! the exponent between neighbours of a kind says how time grows. Memory is the peak of the process so far.
#![allow(clippy::print_stdout, reason = "a benchmark's answer")]
#![allow(clippy::unwrap_used, reason = "a benchmark may stop")]

use soilctl_limit_analysis::{EmbeddedPlate, Options, Solve, bound};

/// Peak memory of this process in MB, where the system tells.
fn peak_mb() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM"));
    let kilobytes = line.and_then(|l| l.split_whitespace().nth(1)).and_then(|n| n.parse::<f64>().ok());
    kilobytes.map_or(f64::NAN, |k| k / 1024.0)
}

fn print(kind: &str, solve: &Solve, last: &mut Option<Solve>) {
    let exponent = last.map_or(f64::NAN, |l| {
        (solve.seconds / l.seconds).ln() / (solve.elements as f64 / l.elements as f64).ln()
    });
    println!(
        "{kind} {:>6} {:>4} {:>9.2} {:>9.3} {:>9.2} {:>9.0}",
        solve.elements,
        solve.iterations,
        solve.seconds,
        solve.proof_seconds,
        exponent,
        peak_mb()
    );
    *last = Some(*solve);
}

fn main() {
    let plate = EmbeddedPlate { phi_deg: 40.0, delta_deg: 25.0, ..EmbeddedPlate::default() };
    let options = Options { max_gap: 0.0, max_seconds: 1e9, max_elements: 50_000, ..Options::default() };
    println!("bound elements steps  solver/s   proof/s  exponent   peak/MB");
    let (mut upper, mut lower) = (None, None);
    let bounds = bound(&plate.problem().unwrap(), &options, &mut |level, _| {
        print("upper", &level.upper, &mut upper);
        if let Some(solve) = &level.lower {
            print("lower", solve, &mut lower);
        }
    });
    println!("gap {:.3} %", 100.0 * bounds.unwrap().gap());
}
