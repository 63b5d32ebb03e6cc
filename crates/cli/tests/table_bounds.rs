//! `soilctl table build --model bounds` and what goes with it, from outside.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod common;

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use common::{json, refused, soilctl};
use serde_json::Value;
use soilctl_earth_pressure::table::{
    BracketRow, BracketRules, BracketTable, CellStatus, read_bracket, write_bracket,
};

/// Six cases of the coarsest mesh. The plate leans so far that no mechanism in space covers it: ends would take four times as long.
const TINY: [&str; 12] = [
    "table",
    "build",
    "--alpha",
    "122:124:2",
    "--phi",
    "30:35:5",
    "--delta",
    "30:35:5",
    "--max-elements",
    "600",
    "--max-gap",
    "0.1",
];

fn tiny<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    [&TINY[..], rest].concat()
}

/// Six cases with ends.
fn square<'a>(rest: &[&'a str]) -> Vec<&'a str> {
    let mut words = tiny(rest);
    (words[3], words[5], words[7]) = ("85:90:5", "25:30:5", "0:30:30");
    words
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

fn beside(path: &Path, ending: &str) -> std::path::PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    name.into()
}

// Interrupted by a signal.
#[cfg(unix)]
#[test]
fn threads_shards_interruptions_and_extensions_do_not_change_a_byte() {
    let dir = tempfile::tempdir().unwrap();
    let file = |name: &str| dir.path().join(name);
    let name = |path: &Path| path.to_str().unwrap().to_owned();
    let whole = file("whole.csv");
    let (code, answer) = json(&tiny(&["--threads", "2", "--out", &name(&whole)]));
    assert_eq!((code, &answer["action"], &answer["finished"]), (0, &"build".into(), &true.into()));
    assert_eq!((&answer["table"]["filled"], &answer["table"]["quantity"]), (&6.into(), &"bracket".into()));
    let (rows, sidecar) = (text(&whole), text(&beside(&whole, ".json")));

    // Shards on one thread, united in the wrong order.
    let shards: Vec<String> = [3, 1, 2].iter().map(|i| name(&file(&format!("{i}.csv")))).collect();
    for (shard, out) in ["3/3", "1/3", "2/3"].iter().zip(&shards) {
        assert_eq!(json(&tiny(&["--threads", "1", "--shard", shard, "--out", out])).0, 0);
    }
    let united = file("united.csv");
    let (code, answer) =
        json(&["table", "merge", &shards[0], &shards[1], &shards[2], "--out", &name(&united)]);
    assert_eq!((code, &answer["action"]), (0, &"merge".into()));
    assert_eq!((text(&united), text(&beside(&united, ".json"))), (rows.clone(), sidecar.clone()));

    // Another grid that shares half of its cases, and is then extended.
    let extended = name(&file("extended.csv"));
    let mut smaller = tiny(&["--out", &extended]);
    smaller[3] = "124:126:2";
    assert_eq!(json(&smaller).0, 0);
    let (_, plan) = json(&tiny(&["--dry-run", "--out", &extended]));
    assert_eq!((&plan["action"], &plan["cases"], &plan["done"]), (&"plan".into(), &6.into(), &3.into()));
    assert_eq!(json(&tiny(&["--threads", "4", "--out", &extended])).0, 0);
    // What was there stays there.
    let of_both: Vec<String> = text(Path::new(&extended)).lines().map(str::to_owned).collect();
    assert!(of_both.len() == 10 && rows.lines().all(|row| of_both.iter().any(|r| r == row)));

    // A run that lost power after two cases, in the middle of writing the third.
    let broken = file("broken.csv");
    let journal = beside(&broken, ".partial.jsonl");
    interrupt(&broken, &journal);
    let lines: Vec<String> = text(&journal).lines().map(str::to_owned).collect();
    std::fs::write(&journal, format!("{}\n{}\n{{\"found\":{{\"sol", lines[0], lines[1])).unwrap();
    let (_, plan) = json(&tiny(&["--dry-run", "--out", &name(&broken)]));
    assert_eq!((&plan["done"], &plan["measured"]), (&1.into(), &1.into()));
    assert!(plan["seconds"].as_f64().unwrap() > 0.0);
    assert_eq!(json(&tiny(&["--threads", "2", "--out", &name(&broken)])).0, 0);
    assert_eq!((text(&broken), text(&beside(&broken, ".json"))), (rows, sidecar));
    assert!(!journal.exists());
}

/// Files below a folder with their bytes, by name.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            found.push((name, std::fs::read(&path).unwrap()));
        }
    }
    found.sort();
    found
}

#[test]
fn shards_fill_one_store_at_a_time_and_nothing_is_solved_twice() {
    let dir = tempfile::tempdir().unwrap();
    let name = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (store, alone) = (name("store"), name("alone.csv"));
    let mut running: Vec<_> = ["1/3", "2/3", "3/3"]
        .into_iter()
        .map(|shard| {
            let args = tiny(&["--threads", "1", "--shard", shard, "--store", &store, "--quiet"]);
            Command::new(env!("CARGO_BIN_EXE_soilctl")).args(args).stdout(Stdio::null()).spawn().unwrap()
        })
        .collect();
    // One is killed in the middle of its work.
    running[1].kill().unwrap();
    let codes: Vec<_> = running.iter_mut().map(|child| child.wait().unwrap().code()).collect();
    // Windows gives what was killed a code.
    let killed = if cfg!(windows) { Some(1) } else { None };
    assert_eq!(codes, [Some(0), killed, Some(0)]);
    let (_, plan) = json(&tiny(&["--dry-run", "--store", &store]));
    let done = plan["done"].as_u64().unwrap();
    assert!((4..=6).contains(&done), "{plan}");
    // The whole grid takes what is there.
    let table = name("table.csv");
    let (code, answer) = json(&tiny(&["--threads", "2", "--store", &store, "--out", &table]));
    assert_eq!((code, &answer["finished"], &answer["file"]), (0, &true.into(), &table.as_str().into()));
    assert!(!beside(Path::new(&table), ".partial.jsonl").exists());
    // Another run with a store of its own leaves the same bytes; of the files of the first none has changed since.
    let other = name("other");
    let (code, _) = json(&tiny(&["--threads", "1", "--store", &other, "--out", &alone]));
    assert_eq!(code, 0);
    assert_eq!(text(Path::new(&table)), text(Path::new(&alone)));
    let bytes = files(Path::new(&store));
    assert_eq!(bytes.len(), 6);
    assert_eq!(files(Path::new(&other)), bytes);
    // Other rules are other cases.
    let mut coarser = tiny(&["--dry-run", "--store", &store]);
    coarser[11] = "0.2";
    assert_eq!(json(&coarser).1["done"], 0);
    let message = refused(&["table", "build", "--model", "chen", "--store", &store]);
    assert!(message.contains("--store is for --model bounds"), "{message}");
    let message = refused(&["table", "build", "--shard", "1/2"]);
    assert!(message.contains("--out"), "{message}");
}

/// Runs until at least one case is in the journal, then presses Ctrl-C.
fn interrupt(out: &Path, journal: &Path) {
    let args = tiny(&["--threads", "1", "--format", "json", "--out", out.to_str().unwrap()]);
    let child = Command::new(env!("CARGO_BIN_EXE_soilctl"))
        .args(args)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let start = Instant::now();
    while !std::fs::read_to_string(journal).is_ok_and(|text| text.lines().count() > 1) {
        assert!(start.elapsed() < Duration::from_secs(300), "no case was solved");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let done = child.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(3), "{}", String::from_utf8_lossy(&done.stderr));
    let answer: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!((&answer["action"], &answer["finished"]), (&"build".into(), &false.into()));
    assert_eq!(answer["file"], journal.to_str().unwrap());
    assert!(!out.exists());
}

#[test]
fn a_table_is_saved_shown_checked_and_used() {
    let dir = tempfile::tempdir().unwrap();
    let (out, saved) = (dir.path().join("t.csv"), dir.path().join("proofs"));
    let (file, folder) = (out.to_str().unwrap(), saved.to_str().unwrap());
    json(&square(&["--save", folder, "--out", file]));
    // A proof that got lost: its case is solved once more, to the same bits.
    let proof = saved.join("alpha_85_phi_30_delta_30.json");
    std::fs::remove_file(&proof).unwrap();
    let (_, plan) = json(&square(&["--dry-run", "--save", folder, "--out", file]));
    assert_eq!(plan["done"], 5);
    let before = text(&out);
    json(&square(&["--save", folder, "--out", file]));
    assert_eq!(text(&out), before);

    // A table of an earlier version gets what it lacks of ends, to the same bits.
    let (table, sidecar) = read_bracket(&out).unwrap();
    let plane = |row: &BracketRow| BracketRow { ends_lower: None, ends_upper: None, ends_term: None, ..*row };
    let rows = table.rows().iter().map(plane).collect();
    let older = BracketTable::new(table.name(), table.rules(), rows).unwrap();
    write_bracket(&older, &sidecar.source, &out).unwrap();
    let (_, plan) = json(&square(&["--dry-run", "--out", file]));
    assert_eq!(plan["done"], 0);
    json(&square(&["--out", file]));
    assert_eq!(text(&out), before);

    let (_, shown) = json(&["table", "show", file]);
    let cells = shown["cells"].as_array().unwrap();
    assert_eq!((cells.len(), &shown["gaps"]["uncertified"]), (6, &0.into()));
    let (code, proven) = json(&["certify", proof.to_str().unwrap()]);
    // Beside each the proof of a plate with ends.
    assert_eq!((code, std::fs::read_dir(&saved).unwrap().count()), (0, 12));
    let (code, ended) = json(&["certify", proof.with_extension("ends.json").to_str().unwrap()]);
    assert!(code == 0 && ended["width"].as_f64().unwrap() > 4.0, "{ended}");
    let cell = &cells[2];
    for side in ["lower", "upper"] {
        let force = proven[side]["proven"].as_f64().unwrap();
        let k = cell[side].as_f64().unwrap();
        assert!((2.0 * force / f64::sin(115_f64.to_radians()) / k - 1.0).abs() < 1e-12);
    }

    let (code, checked) = json(&["table", "check", file]);
    assert_eq!((code, &checked["consistent"]), (0, &true.into()));
    let (_, used) =
        json(&["predict", "--model-table", file, "--alpha", "85", "--phi", "30", "--delta", "30"]);
    assert_eq!(used["model"], "table-file");
    assert!((used["k_net_lower"].as_f64().unwrap() / cell["lower"].as_f64().unwrap() - 1.0).abs() < 1e-12);
    for words in [&["table", "show", file][..], &["table", "check", file]] {
        let shown = String::from_utf8(soilctl(words).stdout).unwrap();
        assert!(shown.contains("gap: mean") && shown.contains("not proven: 0"), "{shown}");
    }
}

#[test]
fn the_check_finds_crossed_unproven_and_shrinking_brackets() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("t.csv");
    let file = path.to_str().unwrap();
    // Brackets over alpha and delta, the same for both friction angles but for a factor.
    let write = |brackets: [(u32, u32, f64, f64, bool); 4]| {
        let mut rows = Vec::new();
        for (phi_deg, factor) in [(30.0, 1.0), (40.0, 2.0)] {
            for (alpha, delta, lower, upper, certified) in brackets {
                let (lower, upper) = (factor * lower, factor * upper);
                rows.push(BracketRow {
                    alpha_deg: f64::from(alpha),
                    phi_deg,
                    delta_deg: f64::from(delta),
                    lower,
                    upper,
                    gap: BracketRow::relative_gap(lower, upper),
                    certified,
                    lower_elements: 1,
                    upper_elements: 1,
                    status: CellStatus::Solved,
                    ends_lower: None,
                    ends_upper: None,
                    ends_term: None,
                });
            }
        }
        let rules = BracketRules { max_gap: 0.01, max_elements: 12000 };
        write_bracket(&BracketTable::new("t", rules, rows).unwrap(), "a test", &path).unwrap();
    };
    // Brackets that overlap do not contradict growth, however they lie.
    let good = [
        (80, 0, 2.5, 2.6, true),
        (80, 5, 2.4, 2.7, true),
        (90, 0, 2.8, 2.9, true),
        (90, 5, 2.85, 2.95, true),
    ];
    write(good);
    assert_eq!(json(&["table", "check", file]).0, 0);
    let mut rows = good;
    rows[3] = (90, 5, 2.7, 2.75, true);
    write(rows);
    let (code, answer) = json(&["table", "check", file]);
    assert_eq!((code, &answer["violations"][0]["along"]), (1, &"delta".into()));
    let mut rows = good;
    rows[0].4 = false;
    write(rows);
    let (code, answer) = json(&["table", "check", file]);
    assert_eq!((code, &answer["brackets"]["gaps"]["uncertified"]), (1, &2.into()));
    let mut rows = good;
    rows[0] = (80, 0, 2.6, 2.5, true);
    write(rows);
    let (code, answer) = json(&["table", "check", file]);
    assert_eq!((code, answer["brackets"]["crossed"].as_array().unwrap().len()), (1, 2));
    assert!(
        refused(&["predict", "--model-table", file, "--alpha", "85", "--phi", "35", "--delta", "1"])
            .contains("is above the upper bound")
    );
}

#[test]
fn wrong_usage_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("t.csv");
    let out = out.to_str().unwrap();
    let build = |rest: &[&str]| refused(&[&["table", "build", "--out", out], rest].concat());
    assert!(build(&["--model", "chen", "--threads", "2"]).contains("--threads is for --model bounds"));
    assert!(build(&["--shard", "3/2"]).contains("I/N"));
    assert!(build(&["--max-gap", "0"]).contains("above 0"));
    assert!(build(&["--max-elements", "10"]).contains("600"));
    let parquet = dir.path().join("t.parquet");
    assert!(refused(&tiny(&["--out", parquet.to_str().unwrap()])).contains("ends in .csv"));
    // Upright is 90 deg: beyond alpha + delta of 175 deg no case can be stated.
    let steep = ["--alpha", "160:165:5", "--phi", "40:45:5", "--delta", "20:40:20"];
    assert!(build(&steep).contains("alpha + delta is 180 deg"));
    assert!(build(&["--grid", "narrow"]).contains("appendix-c"));

    let small = |gap: &'static str, out: &str| {
        json(
            &[
                &TINY[..4],
                &[
                    "--phi",
                    "20:25:5",
                    "--delta",
                    "0:25:25",
                    "--max-elements",
                    "700",
                    "--max-gap",
                    gap,
                    "--shard",
                    "1/3",
                    "--out",
                    out,
                ],
            ]
            .concat(),
        )
    };
    assert_eq!(small("0.2", out).0, 0);
    let message = build(&["--dry-run"]);
    assert!(message.contains("is there already") && message.contains("--max-gap 0.2"), "{message}");
    let other = dir.path().join("other.csv");
    assert_eq!(small("0.3", other.to_str().unwrap()).0, 0);
    let message = refused(&["table", "merge", out, other.to_str().unwrap(), "--out", "u.csv"]);
    assert!(message.contains("--max-gap 0.3") && message.contains("build them alike"), "{message}");
    let points = dir.path().join("points.csv");
    json(&["table", "build", "--model", "chen", "--out", points.to_str().unwrap()]);
    let message = refused(&["table", "merge", out, points.to_str().unwrap(), "--out", "u.csv"]);
    assert!(message.contains("not one of bounds"), "{message}");
    assert!(
        refused(&["table", "check", points.to_str().unwrap(), "--against", "appendix-c-num-ub"])
            .contains("needs a table of brackets")
    );
}

#[test]
fn a_dry_run_counts_and_writes_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("t.csv");
    let out = out.to_str().unwrap();
    for (options, cases) in
        [(&[][..], 287), (&["--grid", "wide"], 612), (&["--shard", "2/4"], 72), (&["--delta", "0:10:5"], 126)]
    {
        let fixed = ["table", "build", "--dry-run", "--threads", "2", "--out", out];
        let (code, plan) = json(&[&fixed[..], options].concat());
        assert_eq!((code, &plan["cases"], &plan["done"]), (0, &cases.into(), &0.into()), "{options:?}");
        let (each, all) = (plan["seconds_per_case"].as_f64().unwrap(), plan["seconds"].as_f64().unwrap());
        assert!(each > 0.0 && (all / (each * f64::from(cases) / 2.0) - 1.0).abs() < 1e-9);
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}
