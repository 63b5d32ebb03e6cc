//! Controller, plant, soil and log on one core, against real time, which is what the arm itself takes. The bar is 10 times, the aim 25.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark")]

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use criterion::{Criterion, SamplingMode};
use soilctl_campaign::{Content, Options, Plan, simulate};
use soilctl_controller::TICK_S;

const PLAN: &str = r#"
version = 1
soil = "ticino_loose"
model = "table"
[[batches]]
strokes = [
    { radius_m = 0.4318, base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.025, delta_set_deg = 23.0 },
    { radius_m = 0.3048, base_deg = 0.0, alpha_deg = 70.0, depth_m = 0.024, delta_set_deg = 23.0 },
]
"#;

/// Steps of a campaign of two strokes, its log written.
fn batch() -> u64 {
    let folder = tempfile::tempdir().unwrap();
    let plan = Plan::from_toml(PLAN, "plan", Path::new("")).unwrap();
    let options = Options { out: folder.path(), seed: 1, threads: 1, content: Content::Whole, only: None };
    let report = simulate(&plan, None, &options, &AtomicBool::new(false), &|_| {}).unwrap();
    report.batches.iter().map(|batch| batch.steps).sum()
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("simulate");
    group.sampling_mode(SamplingMode::Flat);
    group.bench_function("two strokes and their log", |b| b.iter(batch));
    group.finish();
    let clock = Instant::now();
    let simulated_s = batch() as f64 * TICK_S;
    let spent_s = clock.elapsed().as_secs_f64();
    println!("{simulated_s:.1} s simulated in {spent_s:.2} s: {:.1} times real time", simulated_s / spent_s);
    criterion.final_summary();
}
