//! Memory of `process` over the size of a log: minutes, with `cargo xtask verify`. Linux tells a process's peak in /proc.
#![cfg(target_os = "linux")]
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that tells what it measured"
)]

use std::fmt::Write as _;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// A stroke gives some 36 MB after decompression.
const STROKES: [usize; 3] = [3, 12, 120];
/// Peaks may differ by so much.
const SPREAD: f64 = 1.2;
/// Depths in m: memory goes with the longest stroke, and the deep one, the first of every log, is the longest.
const DEPTH_M: [f64; 2] = [0.032, 0.025];

/// A log of one preparation with so many strokes, in fourteen places.
fn simulate(folder: &Path, strokes: usize) -> PathBuf {
    let mut plan =
        String::from("version = 1\nsoil = \"ticino_loose\"\nmodel = \"table\"\n[[batches]]\nstrokes = [\n");
    for k in 0..strokes {
        let (base_deg, radius_m) = (10.0 * (k % 7) as f64 - 30.0, [0.4318, 0.36][k / 7 % 2]);
        let place = format!("radius_m = {radius_m}, base_deg = {base_deg:.1}, alpha_deg = 90.0");
        let depth_m = DEPTH_M[usize::from(k > 0)];
        writeln!(plan, "    {{ {place}, depth_m = {depth_m}, delta_set_deg = 21.0 }},").unwrap();
    }
    plan.push_str("]\n");
    let (file, out) = (folder.join(format!("{strokes}.toml")), folder.join(strokes.to_string()));
    std::fs::write(&file, plan).unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_soilctl"))
        .args(["simulate", "--quiet", "--out"])
        .args([&out, &file])
        .stdout(Stdio::null())
        .status();
    assert!(done.unwrap().success());
    out.join("batch_000.mcap")
}

/// Peak of the resident memory of `soilctl process` in MB, and how many strokes it found.
fn peak_mb(log: &Path) -> (f64, usize) {
    let answer = log.with_extension("json");
    let mut process = Command::new(env!("CARGO_BIN_EXE_soilctl"))
        .args(["process", "--quiet", "--threads", "1", "--format", "json"])
        .arg(log)
        .stdout(File::create(&answer).unwrap())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", process.id());
    let mut peak_kb = 0.0_f64;
    while process.try_wait().unwrap().is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let now = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let now = now.and_then(|words| words.split_whitespace().next()).and_then(|word| word.parse().ok());
        peak_kb = peak_kb.max(now.unwrap_or(0.0));
        std::thread::sleep(Duration::from_millis(5));
    }
    let answer: serde_json::Value = serde_json::from_slice(&std::fs::read(answer).unwrap()).unwrap();
    (peak_kb / 1e3, answer["strokes"].as_array().map_or(0, Vec::len))
}

#[test]
#[ignore = "two minutes of simulation, 1.7 GB of logs: cargo xtask verify"]
fn memory_does_not_grow_with_the_log() {
    let folder = tempfile::tempdir().unwrap();
    let peaks: Vec<f64> = STROKES
        .into_iter()
        .map(|strokes| {
            let log = simulate(folder.path(), strokes);
            let (peak, found) = peak_mb(&log);
            let size = log.metadata().unwrap().len() as f64 / 1e6;
            println!("{found} of {strokes} strokes, file of {size:.0} MB: {peak:.1} MB");
            assert!(10 * found >= 9 * strokes);
            peak
        })
        .collect();
    let (least, most) =
        peaks.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), p| (low.min(*p), high.max(*p)));
    assert!(most <= SPREAD * least, "{peaks:?} MB");
}
