//! Logs a second on one core, from zstd and uncompressed, against what a user would otherwise write in Python or Rust, in one run; then a
//! recording of another program against the crates `mcap` and `cdr-encoding`: `cargo bench -p soilctl-process`, after `cargo xtask setup`, which gets Python's packages. The bars: 120 MB/s of decompressed bytes
//! from zstd, 200 MB/s uncompressed, ten times Python.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark")]

mod rust_peer;

use std::path::Path;
use std::process::Command;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use criterion::{Criterion, SamplingMode, Throughput};
use soilctl_campaign::{Content, Options, Plan, simulate};
use soilctl_process::log::{Candidate, LogSettings, read_log};

const PLAN: &str = r#"
version = 1
soil = "nevada_fine"
model = "table"
[[batches]]
strokes = [
    { radius_m = 0.4318, base_deg = -20.0, alpha_deg = 80.0, depth_m = 0.025, delta_set_deg = 22.0 },
    { radius_m = 0.4318, base_deg = 0.0, alpha_deg = 90.0, depth_m = 0.020, delta_set_deg = 22.0 },
    { radius_m = 0.4318, base_deg = 20.0, alpha_deg = 70.0, depth_m = 0.022, delta_set_deg = 22.0 },
    { radius_m = 0.3048, base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.024, delta_set_deg = 22.0 },
]
"#;

/// The strokes of a log with a failure force.
fn strokes(log: &Path) -> usize {
    strokes_with(log, &LogSettings::default())
}

fn strokes_with(log: &Path, settings: &LogSettings) -> usize {
    let mut count = 0;
    read_log(log, settings, &AtomicBool::new(false), &mut |found| {
        count += usize::from(matches!(found, Candidate::Stroke(_)));
    })
    .unwrap();
    count
}

fn main() {
    let folder = tempfile::tempdir().unwrap();
    let plan = Plan::from_toml(PLAN, "plan", Path::new("")).unwrap();
    let options = Options { out: folder.path(), seed: 1, threads: 1, content: Content::Whole, only: None };
    simulate(&plan, None, &options, &AtomicBool::new(false), &|_| {}).unwrap();
    let zstd = folder.path().join("batch_000.mcap");
    let plain = folder.path().join("plain.mcap");
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (python, peers) = (here.join("../../.venv/bin/python"), here.join("benches/peer"));
    assert!(python.exists(), "no {}: run `cargo xtask setup`", python.display());
    let run = |script: &str, arguments: &[&Path]| {
        let done = Command::new(&python).arg(peers.join(script)).args(arguments).output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        done.stdout
    };
    run("uncompress.py", &[&zstd, &plain]);
    let megabytes = plain.metadata().unwrap().len() as f64 / 1e6;
    println!("{} strokes, {megabytes:.0} MB after decompression", strokes(&zstd));
    assert_eq!(strokes(&zstd), strokes(&plain));

    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("process");
    group.sampling_mode(SamplingMode::Flat);
    group.throughput(Throughput::Bytes(plain.metadata().unwrap().len()));
    for (name, log) in [("zstd", &zstd), ("uncompressed", &plain)] {
        group.bench_function(name, |b| b.iter(|| strokes(log)));
    }
    group.finish();

    for (name, log) in [("zstd", &zstd), ("uncompressed", &plain)] {
        let clock = Instant::now();
        strokes(log);
        let ours_s = clock.elapsed().as_secs_f64();
        println!("{name}: {:.0} MB/s", megabytes / ours_s);
        let clock = Instant::now();
        rust_peer::wrenches_of_steps(log);
        let peer_s = clock.elapsed().as_secs_f64();
        println!(
            "{name}: Rust, mcap, six numbers of each step: {:.0} MB/s, {:.2} times our time",
            megabytes / peer_s,
            peer_s / ours_s
        );
        for how in ["wrench", "decoder"] {
            let answer: serde_json::Value =
                serde_json::from_slice(&run("read_steps.py", &[Path::new(how), log])).unwrap();
            let seconds = answer["seconds"].as_f64().unwrap();
            println!(
                "{name}: Python, {how}: {:.1} MB/s, {:.1} times slower",
                megabytes / seconds,
                seconds / ours_s
            );
        }
    }
    let other = here.join("../../data/other_arm");
    let settings = LogSettings {
        urdf: Some(std::fs::read_to_string(other.join("arm.urdf")).unwrap()),
        plate_frame: Some("blade_edge".into()),
        surface_z_m: Some(0.08),
        width_m: Some(0.1),
        ..LogSettings::default()
    };
    let bag = other.join("bag/bag.mcap");
    let (joints, wrenches) = rust_peer::columns(&bag);
    println!(
        "a recording of another program: {joints} joint states, {wrenches} wrenches, {} strokes",
        strokes_with(&bag, &settings)
    );
    let mut group = criterion.benchmark_group("another program's recording");
    group.sampling_mode(SamplingMode::Flat);
    group.throughput(Throughput::Elements((joints + wrenches) as u64));
    group.bench_function("process", |b| b.iter(|| strokes_with(&bag, &settings)));
    group.bench_function("soilctl-bag alone, into columns", |b| b.iter(|| rust_peer::our_columns(&bag)));
    group.bench_function("mcap and cdr-encoding, into columns", |b| b.iter(|| rust_peer::columns(&bag)));
    group.finish();
    criterion.final_summary();
}
