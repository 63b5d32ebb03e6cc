//! Plant, soil and controller on one core, against the bar of 10 times real time (25 is the aim).

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a bench may stop, and says more than criterion"
)]

#[path = "../tests/rig/mod.rs"]
mod rig;

use std::time::Instant;

use criterion::Criterion;
use soilctl_controller::{Params, Request, SequenceId, TICK_S};
use soilctl_plant::PlantParams;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let plant = PlantParams::thesis();
    let sand = rig::ground(&plant, "ticino_loose", "table");
    let start = rig::above(0.4318, 0.0, 80.0, rig::SURFACE_Z_M + 0.02);
    let mut simulation = rig::homed(Params::thesis(), plant, Some(sand), &start);
    criterion.bench_function("tick/hold", |b| b.iter(|| simulation.tick(None, &mut |_| {}).unwrap()));

    let stroke = rig::spec(0.4318, 80.0, 0.0254, 23.0);
    simulation.tick(Some(Request::Stroke(stroke)), &mut |_| {}).unwrap();
    let (clock, mut ticks) = (Instant::now(), 0_u32);
    let done = simulation.run_sequence(SequenceId::InsertStrokePullout, 60_000, &mut |_| ticks += 1).unwrap();
    let (spent, simulated) = (clock.elapsed().as_secs_f64(), f64::from(ticks) * TICK_S);
    println!(
        "whole stroke (done: {done}): {simulated:.1} s simulated in {spent:.2} s, {:.1} times real time",
        simulated / spent
    );
    criterion.final_summary();
}
