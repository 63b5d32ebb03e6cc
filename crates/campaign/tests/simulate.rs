//! Campaigns: the same bytes whatever the threads, resumed after an interruption, replayed.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_campaign::{CampaignError, Content, Notice, Options, Plan, Report, simulate};
use soilctl_effects::ModelFile;
use soilctl_session::read::{Item, scan};
use soilctl_session::{SessionError, topics};

const PLAN: &str = r#"
version = 1
soil = "ticino_loose"
model = "chen"
[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = -15.0, alpha_deg = 80.0, depth_m = 0.012, delta_set_deg = 23.0 }]
[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = 15.0, alpha_deg = 90.0, depth_m = 0.012, delta_set_deg = 23.0 }]
"#;

fn plan() -> Plan {
    Plan::from_toml(PLAN, "plan.toml", Path::new("")).unwrap()
}

fn run(out: &Path, seed: u64, threads: usize) -> Result<Report, CampaignError> {
    let options = Options { out, seed, threads, content: Content::Whole, only: None };
    simulate(&plan(), None, &options, &AtomicBool::new(false), &|_| {})
}

fn files(dir: &Path) -> BTreeMap<String, Vec<u8>> {
    std::fs::read_dir(dir)
        .unwrap()
        .map(|entry| {
            let path = entry.unwrap().path();
            (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read(&path).unwrap())
        })
        .collect()
}

/// One thread, two threads, and an interruption after the first batch: not a byte differs. The logs are whole and replay.
#[test]
fn the_same_bytes_however_it_is_run() {
    let (one, two, resumed) =
        (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let report = run(one.path(), 3, 1).unwrap();
    assert!(report.complete);
    for batch in &report.batches {
        assert_eq!((batch.strokes_done, batch.failures.len()), (1, 0), "{:?}", batch.failures);
    }
    let expected = files(one.path());
    assert_eq!(
        expected.keys().collect::<Vec<_>>(),
        ["batch_000.mcap", "batch_001.mcap", "campaign.json", "simulation.json"]
    );
    // A batch alone is that of the whole campaign, which then takes it over.
    let alone = Options { out: two.path(), seed: 3, threads: 2, content: Content::Whole, only: Some(&[1]) };
    let second = simulate(&plan(), None, &alone, &AtomicBool::new(false), &|_| {}).unwrap();
    assert!(second.complete && second.batches[..] == report.batches[1..]);
    assert!(files(two.path())["batch_001.mcap"] == expected["batch_001.mcap"]);
    assert_eq!(run(two.path(), 3, 2).unwrap(), Report { resumed: 1, ..report.clone() });
    assert!(files(two.path()) == expected);

    let (stop, options) = (
        AtomicBool::new(false),
        Options { out: resumed.path(), seed: 3, threads: 1, content: Content::Whole, only: None },
    );
    let first = simulate(&plan(), None, &options, &stop, &|notice| {
        if matches!(notice, Notice::Finished { .. }) {
            stop.store(true, Ordering::Relaxed);
        }
    })
    .unwrap();
    assert_eq!((first.complete, first.batches.len()), (false, 1));
    // What a killed run leaves behind.
    std::fs::write(resumed.path().join("batch_001.mcap.part"), b"half a log").unwrap();
    let rest = run(resumed.path(), 3, 1).unwrap();
    assert_eq!((rest.complete, rest.resumed), (true, 1));
    assert!(files(resumed.path()) == expected);

    for batch in &report.batches {
        let log = one.path().join(&batch.log);
        let replay = soilctl_session::replay(&log, 0).unwrap();
        assert!(replay.is_identical() && replay.ending.is_whole(), "{:?}", replay.first_difference);
        assert_eq!(replay.steps, batch.steps);
    }
    let message = run(one.path(), 4, 1).unwrap_err().to_string();
    assert!(message.contains("another seed (3; this one: 4)"), "{message}");
}

/// Messages of a log that strokes are read from and a replay needs, with their times, and all records.
fn essence(log: &Path) -> (Vec<String>, Vec<String>) {
    let (mut messages, mut others) = (Vec::new(), BTreeSet::new());
    scan::<SessionError>(log, &mut |item| {
        match item {
            Item::Message(message) => {
                let topic = message.channel.topic.as_str();
                if [topics::STEP, topics::KEYFRAME, topics::TF_STATIC].contains(&topic) {
                    messages.push(format!("{topic} {} {:?}", message.log_time_ns, message.data));
                } else {
                    others.insert(topic.to_owned());
                }
            }
            Item::Metadata { name, content } => messages.push(format!("{name} {content:?}")),
            _ => {}
        }
        Ok(())
    })
    .unwrap();
    (messages, others.into_iter().collect())
}

/// A log of steps alone has all that is in the whole one but what follows from it and the truth, and replays.
#[test]
fn a_log_of_steps_is_the_whole_one_without_what_follows() {
    let (whole, steps) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    run(whole.path(), 3, 2).unwrap();
    let options = Options { out: steps.path(), seed: 3, threads: 2, content: Content::Steps, only: None };
    let report = simulate(&plan(), None, &options, &AtomicBool::new(false), &|_| {}).unwrap();
    let sizes = |dir: &Path| files(dir).values().map(Vec::len).sum::<usize>();
    assert!(
        3 * sizes(steps.path()) < 2 * sizes(whole.path()),
        "{} {}",
        sizes(steps.path()),
        sizes(whole.path())
    );
    for batch in &report.batches {
        let [of_whole, of_steps] = [whole.path(), steps.path()].map(|dir| essence(&dir.join(&batch.log)));
        assert!(of_steps.0 == of_whole.0);
        assert_eq!((of_whole.1.len(), &of_steps.1[..]), (7, &[topics::ROBOT_DESCRIPTION.to_owned()][..]));
        let replay = soilctl_session::replay(&steps.path().join(&batch.log), 0).unwrap();
        assert!(replay.is_identical() && replay.ending.is_whole(), "{:?}", replay.first_difference);
    }
}

fn patch(effects: &str) -> ModelFile {
    let value = |value: f64, unit: &str| format!(r#"{{"value": {value}, "sd": 0.0, "unit": "{unit}"}}"#);
    let text = format!(
        r#"{{"schema": "soilctl.model-file/1", "model": "chen", "status": "hand", "soil": {{"phi_deg": {}, "delta_deg": {},
        "delta_offset_deg": {}, "density_kg_m3": {}, "gravity_m_s2": 9.80665}}, "effects": [{effects}],
        "reference": {{"depth_m": 0.012, "alpha_deg": 85.0, "delta_set_deg": 23.0, "speed_mps": null, "time_s": null,
        "base_deg": null, "batches": []}}}}"#,
        value(42.0, "deg"),
        value(23.0, "deg"),
        value(0.0, "deg"),
        value(1450.0, "kg/m3"),
    );
    ModelFile::parse(&text, "patch.json").unwrap()
}

fn effect(id: &str, parameter: &str, value: f64) -> String {
    format!(
        r#"{{"id": "{id}", "parameters": {{"{parameter}": {{"value": {value}, "sd": 0.0, "unit": "1"}}}}}}"#
    )
}

#[test]
fn an_effect_that_the_plant_cannot_show_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let file = patch(&effect("rate_effect", "n", 0.05));
    let options = Options { out: dir.path(), seed: 1, threads: 1, content: Content::Whole, only: None };
    let error = simulate(&plan(), Some((&file, "patch.json")), &options, &AtomicBool::new(true), &|_| {});
    let message = error.unwrap_err().to_string();
    assert!(message.starts_with("patch.json: the effect `rate_effect` cannot be simulated: "), "{message}");
    assert!(files(dir.path()).is_empty());
}
