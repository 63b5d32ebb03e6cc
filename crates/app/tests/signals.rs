//! Effects that a controller hides, in logs of an arm that the twin does not know: found from signals that the twin has learnt. Minutes each.

#![allow(clippy::unwrap_used, reason = "tests")]

use std::fmt::Write as _;
use std::path::Path;

use serde_json::{Value, json};
use soilctl_app::diagnose::self_test_logs;
use soilctl_app::{Unwatched, diagnose, process, simulate};

/// The twin's plant, and what is different in the arm that made the logs: its mobilisation, the friction of its drives, and its noise.
const TWIN: &str = include_str!("../../../data/plant/default.toml");
const OTHER: [(&str, &str); 4] = [
    ("loose_mobilisation = 0.2 ", "loose_mobilisation = 0.24 "),
    ("gradual_exponent = 1.5 ", "gradual_exponent = 1.8 "),
    ("friction_nm = [0.5, 0.8, 0.68, 0.68, 0.3]", "friction_nm = [0.45, 0.9, 0.75, 0.6, 0.3]"),
    ("noise_n = 0.04 ", "noise_n = 0.06 "),
];

/// Four preparations of three strokes, at two tool angles and two radii.
fn plan() -> String {
    let mut text =
        "version = 1\nsoil = \"ticino_loose\"\nmodel = \"table\"\nplant = \"plant.toml\"\n".to_owned();
    for batch in 0..4 {
        text += "[[batches]]\nstrokes = [\n";
        for (stroke, base_deg) in [-25.0, 0.0, 25.0].into_iter().enumerate() {
            let (alpha_deg, depth_m) = [(90.0, 0.0254), (80.0, 0.02501)][(batch + stroke) % 2];
            let radius_m = if batch / 2 == 0 { 0.4318 } else { 0.3048 };
            writeln!(
                text,
                "  {{ radius_m = {radius_m}, base_deg = {base_deg:.1}, alpha_deg = {alpha_deg:.1}, depth_m = {depth_m}, \
                 delta_set_deg = 23.0 }},"
            )
            .unwrap();
        }
        text += "]\n";
    }
    text
}

/// A model file of the soil as it is, with one effect or none.
fn model_file(effect: Option<(&str, &str, f64)>) -> Value {
    let value = |value: f64, unit: &str| json!({ "value": value, "sd": 0.0, "unit": unit });
    let effects: Vec<Value> = effect
        .into_iter()
        .map(|(id, name, size)| json!({ "id": id, "parameters": { name: value(size, "1") } }))
        .collect();
    json!({
        "schema": "soilctl.model-file/1", "model": "table", "status": "hand", "effects": effects,
        "soil": {
            "phi_deg": value(42.9, "deg"), "delta_deg": value(23.0, "deg"), "delta_offset_deg": value(0.0, "deg"),
            "density_kg_m3": value(1430.0, "kg/m3"), "gravity_m_s2": 9.80665,
        },
        "reference": {
            "depth_m": 0.025, "alpha_deg": 85.0, "delta_set_deg": 23.0, "speed_mps": null, "time_s": null,
            "base_deg": [-25.0, 25.0], "batches": [],
        },
    })
}

/// Logs of the other arm with an effect, diagnosed with the twin; `store` keeps what the twin has learnt.
fn found(folder: &Path, store: &Path, effect: Option<(&str, &str, f64)>, seed: u64) -> diagnose::Answer {
    let other = OTHER.iter().fold(TWIN.to_owned(), |text, (twin, other)| {
        assert!(text.contains(twin), "{twin}");
        text.replace(twin, other)
    });
    let logs = folder.join("logs");
    std::fs::create_dir_all(logs.join("out")).unwrap();
    std::fs::write(folder.join("plant.toml"), other).unwrap();
    std::fs::write(folder.join("plan.toml"), plan()).unwrap();
    std::fs::write(folder.join("hidden.json"), model_file(effect).to_string()).unwrap();
    let request = simulate::Request {
        file: folder.join("plan.toml"),
        out: logs.clone(),
        seed: Some(seed),
        model_file: Some(folder.join("hidden.json")),
        ..simulate::Request::default()
    };
    simulate::run(&request, &Unwatched).unwrap();
    let strokes = logs.join("strokes.csv");
    process::run(&process::Request::of_folder(&logs, &strokes), &Unwatched).unwrap();
    // An experimenter knows the friction angle from a direct shear test.
    let known = logs.join("campaign.json");
    let mut campaign: Value = serde_json::from_slice(&std::fs::read(&known).unwrap()).unwrap();
    campaign["phi_independent_deg"] = json!(42.0);
    campaign["phi_independent_sd"] = json!(2.0);
    std::fs::write(&known, campaign.to_string()).unwrap();
    std::fs::write(logs.join("plant.toml"), TWIN).unwrap();
    let out = store.to_owned();
    let request = diagnose::Request { dir: logs, out: Some(out), ..diagnose::Request::default() };
    diagnose::run(&request, &Unwatched).unwrap().answer
}

#[test]
#[ignore = "takes many minutes: some 150 simulated strokes"]
#[allow(clippy::print_stdout, reason = "what was found, for who runs it")]
fn what_a_controller_hides_is_found_in_other_signals() {
    let folder = tempfile::tempdir().unwrap();
    let store = folder.path().join("store");
    let cases = [
        (None, "none"),
        (Some(("interface_friction_offset", "offset_deg", 4.0)), "interface_friction_offset"),
        (Some(("force_drift", "drift_n", 0.5)), "force_drift"),
        (Some(("force_bias", "bias_n", 0.3)), "force_bias"),
        (Some(("ft_crosstalk", "crosstalk", 0.08)), "ft_crosstalk"),
    ];
    for (number, (effect, expected)) in cases.into_iter().enumerate() {
        let answer = found(&folder.path().join(number.to_string()), &store, effect, 21 + number as u64);
        let names: Vec<&str> = answer.effects.iter().map(|effect| effect.id.name()).collect();
        println!("{expected}: {} {names:?} of {:?}", answer.status, answer.equivalence_set);
        let both = ["interface_friction_offset", "ft_crosstalk"];
        if effect.is_none() {
            assert_eq!(answer.status, expected, "{names:?}");
        } else if both.contains(&expected) {
            // They turn the slip alike: where both stay open, the right one is first.
            assert_eq!(names.first(), Some(&expected), "{:?}", answer.equivalence_set);
        } else {
            assert_eq!((answer.status.as_str(), &names[..]), ("named", &[expected][..]));
        }
        if effect.is_some() {
            // The simulated arm with what was found, in the soil that signals ask for beside it, comes nearer to all signals together.
            let gap = |of: &dyn Fn(&diagnose::SignalAnswer) -> f64| {
                (answer.signals.iter().map(|signal| of(signal).powi(2)).sum::<f64>()
                    / answer.signals.len() as f64)
                    .sqrt()
            };
            let before = gap(&|signal| signal.gap_before);
            let after = gap(&|signal| signal.gap_after.unwrap());
            println!("  gap of all signals to the simulated arm {before:.2}, with what was found {after:.2}");
            assert!(after < 0.7 * before);
            assert!(Path::new(answer.twin.as_deref().unwrap()).ends_with("twin.json"));
        }
    }
}

/// Campaigns in which nothing is hidden, of arms that the twin does not know: none of these two, in a soil each, gets a firm name (docs/diagnosis.md has how often
/// one does). A run that is repeated takes what is there.
#[test]
#[ignore = "takes many minutes: some 480 simulated strokes"]
#[allow(clippy::print_stdout, reason = "what was found, for who runs it")]
fn nothing_is_named_where_nothing_is_hidden() {
    let folder = tempfile::tempdir().unwrap();
    let request = self_test_logs::Request {
        folder: folder.path().to_owned(),
        campaigns: 2,
        hidden: Some("none".into()),
        seed: 5,
        ..self_test_logs::Request::default()
    };
    let answer = self_test_logs::run(&request, &Unwatched).unwrap();
    println!("{:?}", answer.confusion);
    assert_eq!(answer.campaigns.len(), 2);
    assert!(
        answer.campaigns.iter().all(|of| of.said.status != "named" && of.said.strokes == 12),
        "{:?}",
        answer.campaigns
    );
    // All of it is there: nothing is simulated again, and another effect is another run.
    let clock = std::time::Instant::now();
    let again = self_test_logs::run(&request, &Unwatched).unwrap();
    assert_eq!(again.campaigns, answer.campaigns);
    assert!(clock.elapsed().as_secs() < 10);
    let other = self_test_logs::Request { hidden: Some("backlash".into()), ..request };
    let message = self_test_logs::run(&other, &Unwatched).unwrap_err().to_string();
    assert!(message.contains("another --hidden (none; this one: backlash)"), "{message}");
}
