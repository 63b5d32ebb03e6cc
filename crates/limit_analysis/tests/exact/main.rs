//! Bounds on problems whose answer is known, through the whole adaptive run. One file a kind of problem; what takes
//! minutes runs with `cargo xtask verify`.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::print_stdout, reason = "the bounds, for docs/verification.md")]

#[path = "../common/mod.rs"]
mod common;
mod cuts;
mod footings;
mod frames;
mod grounds;
mod infinite;
mod layers;
mod prandtl;
mod rankine;
mod rates;
mod rows;
mod slides;
mod strips;
mod toes;

use soilctl_certificate::{Statement, prove_lower, prove_upper};
use soilctl_limit_analysis::{Bounds, IDENTITY, Options, Problem, bound};

/// A run to a mesh size, however slow the machine; what it reports is what the checker proves.
fn solve(statement: Statement, max_elements: usize) -> Bounds {
    let problem = Problem::new(statement).unwrap();
    let options = Options { max_gap: 1e-6, max_work: u64::MAX, max_elements, ..Options::default() };
    let bounds = bound(&problem, &options, &mut |_, _| {}).unwrap();
    assert_eq!(prove_lower(problem.statement(), &bounds.lower.field).unwrap(), bounds.lower.value);
    assert_eq!(prove_upper(problem.statement(), &bounds.upper.field).unwrap(), bounds.upper.value);
    // The gap's parts add up to it.
    assert!(bounds.identity_residual() < IDENTITY, "{:?}", bounds.levels);
    bounds
}

/// The exact value, known to lie within an interval, lies between the bounds too; and these are as close as asked for, and what
/// the documentation shows. Names stand there, so each is of one problem.
#[track_caller]
fn brackets(name: &str, bounds: &Bounds, [low, high]: [f64; 2], gap: f64) {
    let (lower, upper) = (bounds.lower.value, bounds.upper.value);
    println!("{name}: {lower:.5} to {upper:.5}, gap {:.2} %, {:.0} s", 100.0 * bounds.gap(), bounds.seconds);
    assert!(lower <= high && upper >= low, "{name}: {lower} to {upper} against {low} to {high}");
    assert!(bounds.gap() < gap, "{name}: {lower} to {upper}");
    rows::row(name, bounds, [low, high]);
}
