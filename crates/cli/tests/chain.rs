//! The whole chain against the truth, for many seeds: `cargo xtask verify chain`. The tests of `demo` run one campaign every time.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that tells what it measured"
)]

use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::Value;

/// Soils of the thesis.
const SOILS: [&str; 4] = ["ticino_rained", "ticino_loose", "nevada_fine", "glass_beads"];
/// Seeds a soil, unless `SOILCTL_SEEDS` says another number.
const SEEDS: u32 = 10;
/// Models beside the one that the plant used, for the same measurements.
const OTHERS: [&str; 4] = ["chen", "caquot", "log-spiral", "coulomb"];

/// A demonstration in plane strain, as the other models are, and what these make of its measurements: least and largest friction angle, if they agree.
struct Campaign {
    soil: &'static str,
    seed: u32,
    answer: Value,
    others: Vec<Option<[f64; 2]>>,
}

fn json(arguments: &[&str]) -> Value {
    let done = Command::new(env!("CARGO_BIN_EXE_soilctl")).args(arguments).output().unwrap();
    serde_json::from_slice(&done.stdout).unwrap_or_else(|problem| {
        panic!("{arguments:?}: {problem}: {}", String::from_utf8_lossy(&done.stderr))
    })
}

fn range(value: &Value) -> Option<[f64; 2]> {
    Some([value[0].as_f64()?, value[1].as_f64()?])
}

/// The estimate of the demonstration with the density as weighed, by another model.
fn other(folder: &Path, model: &str, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
    let (density, tolerance) = (f64::midpoint(low, high), (high - low) / (high + low));
    let answer = json(&[
        "estimate",
        folder.join("measurements.csv").to_str().unwrap(),
        "--density",
        &density.to_string(),
        "--density-tol",
        &tolerance.to_string(),
        "--model",
        model,
        "--quiet",
        "--format",
        "json",
    ]);
    range(&answer["phi_deg"])
}

fn campaign(soil: &'static str, seed: u32) -> Campaign {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("demo");
    let words =
        ["demo", "--soil", soil, "--seed", &seed.to_string(), "--ends", "none", "--threads", "1", "--quiet"];
    let answer = json(&[&words[..], &["--format", "json", "--out", out.to_str().unwrap()]].concat());
    let weighed = range(&answer["density_weighed"]["density_known_kg_m3"]);
    let others = OTHERS.iter().map(|model| other(&out, model, weighed?)).collect();
    Campaign { soil, seed, answer, others }
}

/// All campaigns, one a core, in order.
fn campaigns(wanted: &[(&'static str, u32)]) -> Vec<Campaign> {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                while let Some((soil, seed)) = wanted.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let found = campaign(soil, *seed);
                    println!(
                        "{soil} {seed}: delta {}, {}",
                        found.answer["delta"]["error_deg"], found.answer["not_recovered"]
                    );
                    done.lock().unwrap().push(found);
                }
            });
        }
    });
    let mut all = done.into_inner().unwrap();
    all.sort_by_key(|c| (SOILS.iter().position(|soil| *soil == c.soil), c.seed));
    all
}

/// What became of the friction angle in some campaigns.
#[derive(Default)]
struct Angles {
    held: usize,
    agreed: usize,
    widths: Vec<f64>,
}

impl Angles {
    fn add(&mut self, range: Option<[f64; 2]>, truth: f64) {
        if let Some([low, high]) = range {
            self.agreed += 1;
            self.held += usize::from((low..=high).contains(&truth));
            self.widths.push(high - low);
        }
    }

    fn words(mut self, of: usize) -> String {
        let width = median(&mut self.widths);
        format!("held in {} of {of}, a soil found in {}, median width {width:.1} deg", self.held, self.agreed)
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// How often the truth is in the range of friction angles, with the bracket that the plant used and with other models.
fn tell(soil: &str, campaigns: &[&Campaign]) {
    let truth = |c: &Campaign| c.answer["truth"]["phi_deg"].as_f64().unwrap();
    for name in ["density_unknown", "density_weighed"] {
        let mut angles = Angles::default();
        campaigns.iter().for_each(|c| angles.add(range(&c.answer[name]["phi_deg"]), truth(c)));
        println!("{soil}, bracket, {name}: {}", angles.words(campaigns.len()));
    }
    for (k, model) in OTHERS.into_iter().enumerate() {
        let mut angles = Angles::default();
        campaigns.iter().for_each(|c| angles.add(c.others.get(k).copied().flatten(), truth(c)));
        println!("{soil}, {model}, density_weighed: {}", angles.words(campaigns.len()));
    }
}

/// Campaigns in which the bracket holds the friction angle, and in which the interface friction is within 1.5 deg.
fn found(campaigns: &[Campaign]) -> [usize; 2] {
    let delta = |c: &&Campaign| c.answer["delta"]["error_deg"].as_f64().is_some_and(|e| e.abs() <= 1.5);
    let phi = |c: &&Campaign| c.answer["density_unknown"]["phi_holds_truth"] == true;
    [campaigns.iter().filter(phi).count(), campaigns.iter().filter(delta).count()]
}

/// The friction angle, the interface friction, and how often a force is within 10 % and within its standard deviation.
#[test]
#[ignore = "two minutes of one core a seed and soil: cargo xtask verify"]
fn chain_finds_the_truth() {
    let seeds = std::env::var("SOILCTL_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(SEEDS);
    let wanted: Vec<(&str, u32)> = SOILS.into_iter().flat_map(|s| (1..=seeds).map(move |k| (s, k))).collect();
    let all = campaigns(&wanted);
    for soil in SOILS {
        tell(soil, &all.iter().filter(|c| c.soil == soil).collect::<Vec<_>>());
    }
    let (mut errors, mut within_sd) = (Vec::new(), 0);
    for stroke in all.iter().flat_map(|c| c.answer["each"].as_array().into_iter().flatten()) {
        if stroke["used_for_phi"] == true
            && let Some(error) = stroke["error"].as_f64()
        {
            errors.push(error.abs());
            let sd = stroke["force_sd_n"].as_f64().unwrap_or(0.0)
                / stroke["limit_force_n"].as_f64().unwrap_or(1.0);
            within_sd += usize::from(error.abs() <= sd);
        }
    }
    let near = errors.iter().filter(|error| **error <= 0.1).count();
    let share = |count: usize| count as f64 / errors.len().max(1) as f64;
    let [phi, delta] = found(&all);
    println!(
        "{} campaigns: phi {phi}, delta within 1.5 deg {delta}; {} forces near the friction: median error {:.3}, \
         within 10 % {:.2}, within a standard deviation {:.2}",
        all.len(),
        errors.len(),
        median(&mut errors.clone()),
        share(near),
        share(within_sd)
    );
    assert!(phi as f64 >= 0.95 * all.len() as f64, "{phi} of {}", all.len());
    assert!(delta as f64 >= 0.95 * all.len() as f64, "{delta} of {}", all.len());
}
