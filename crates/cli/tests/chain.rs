//! The whole chain against the truth, many seeds: minutes to hours, with `cargo xtask verify`.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that tells what it measured"
)]

use std::process::Command;

use serde_json::Value;

/// Soils of the thesis.
const SOILS: [&str; 4] = ["ticino_rained", "ticino_loose", "nevada_fine", "glass_beads"];
/// Seeds a soil, unless `SOILCTL_SEEDS` says another number.
const SEEDS: u32 = 25;

fn demo(soil: &str, seed: u32) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_soilctl"))
        .args(["demo", "--soil", soil, "--seed", &seed.to_string(), "--quiet", "--format", "json", "--out"])
        .arg(folder.path().join("demo"))
        .output()
        .unwrap();
    serde_json::from_slice(&done.stdout).unwrap_or_else(|problem| {
        panic!("{soil} {seed}: {problem}: {}", String::from_utf8_lossy(&done.stderr))
    })
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// How often the truth is in the range of friction angles, the interface friction within 1.5 deg, a force within 10 % and within its
/// standard deviation.
#[test]
#[ignore = "two to three minutes of one core a seed and soil: cargo xtask verify"]
fn chain_finds_the_truth() {
    let seeds = std::env::var("SOILCTL_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(SEEDS);
    let (mut campaigns, mut hold, mut weighed_hold, mut delta_near) = (0, 0, 0, 0);
    let (mut errors, mut within_sd) = (Vec::new(), 0);
    for soil in SOILS {
        let (mut held, mut widths) = ([0, 0], [Vec::new(), Vec::new()]);
        for seed in 1..=seeds {
            let answer = demo(soil, seed);
            campaigns += 1;
            for (k, name) in ["density_unknown", "density_weighed"].into_iter().enumerate() {
                let region = &answer[name];
                held[k] += u32::from(region["phi_holds_truth"] == true);
                if let (Some(low), Some(high)) =
                    (region["phi_deg"][0].as_f64(), region["phi_deg"][1].as_f64())
                {
                    widths[k].push(high - low);
                }
            }
            let off = answer["delta"]["error_deg"].as_f64();
            delta_near += u32::from(off.is_some_and(|error| error.abs() <= 1.5));
            for stroke in answer["each"].as_array().into_iter().flatten() {
                if stroke["used_for_phi"] == true
                    && let Some(error) = stroke["error"].as_f64()
                {
                    errors.push(error.abs());
                    let sd = stroke["force_sd_n"].as_f64().unwrap_or(0.0)
                        / stroke["limit_force_n"].as_f64().unwrap_or(1.0);
                    within_sd += u32::from(error.abs() <= sd);
                }
            }
            println!("{soil} {seed}: delta {off:?}, {}", answer["not_recovered"]);
        }
        println!(
            "{soil}: phi holds the truth in {} of {seeds} (density weighed {}), median width {:.1} deg ({:.1})",
            held[0],
            held[1],
            median(&mut widths[0]),
            median(&mut widths[1])
        );
        hold += held[0];
        weighed_hold += held[1];
    }
    let near = errors.iter().filter(|error| **error <= 0.1).count();
    let share = |count: usize| count as f64 / errors.len().max(1) as f64;
    println!(
        "{campaigns} campaigns: phi {hold} (weighed {weighed_hold}), delta within 1.5 deg {delta_near}; {} forces near the friction: \
         median error {:.3}, within 10 % {:.2}, within a standard deviation {:.2}",
        errors.len(),
        median(&mut errors.clone()),
        share(near),
        share(within_sd as usize)
    );
    assert!(f64::from(hold) >= 0.95 * f64::from(campaigns), "{hold} of {campaigns}");
    assert!(f64::from(delta_near) >= 0.95 * f64::from(campaigns), "{delta_near} of {campaigns}");
}
