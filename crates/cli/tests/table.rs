//! `soilctl table` from outside.

mod common;

use common::{json, refused, soilctl};

#[test]
fn built_in_tables_are_shown() {
    let (code, answer) = json(&["table", "show", "appendix-c-num-lb"]);
    assert_eq!((code, &answer["schema"], &answer["action"]), (0, &"soilctl.table/1".into(), &"show".into()));
    assert_eq!((&answer["table"]["filled"], &answer["table"]["interpolated"]), (&287.into(), &42.into()));
    assert_eq!(answer["cells"].as_array().unwrap().len(), 287);
    let text = String::from_utf8(soilctl(&["table", "show", "appendix-c-chen"]).stdout).unwrap();
    // Alpha 80, phi 40, delta 25 of the printed table.
    assert!(text.contains("alpha 80 deg") && text.contains("8.055"), "{text}");
    for name in ["coulomb", "log-spiral", "caquot", "num-ub"] {
        assert_eq!(soilctl(&["table", "show", &format!("appendix-c-{name}")]).status.code(), Some(0));
    }
}

#[test]
fn a_table_is_built_checked_and_used_as_a_model() {
    let dir = tempfile::tempdir().unwrap();
    for ending in ["csv", "parquet"] {
        let file = dir.path().join(format!("t.{ending}"));
        let file = file.to_str().unwrap();
        let grid = ["--alpha", "70:80:5", "--phi", "30:40:5", "--delta", "0:35:5"];
        let (code, built) =
            json(&[&["table", "build", "--model", "chen", "--out", file], &grid[..]].concat());
        // 3 tool angles, and 7, 8 and 8 nodes with delta up to phi.
        assert_eq!((code, &built["table"]["filled"]), (0, &69.into()));
        let (code, checked) = json(&["table", "check", file]);
        assert_eq!((code, &checked["consistent"]), (0, &true.into()));
        assert_eq!(checked["empty_nodes"].as_array().unwrap().len(), 0);
        let case = ["predict", "--alpha", "75", "--phi", "35", "--delta", "10"];
        let (_, direct) = json(&case);
        let (_, by_table) = json(&[&case[..], &["--model-table", file]].concat());
        let (a, b) = (direct["k_net"].as_f64().unwrap(), by_table["k_net"].as_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-12);
        assert_eq!(by_table["model"], "table-file");
    }
}

#[test]
fn a_table_that_does_not_grow_is_a_negative_answer() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("t.csv");
    let file = path.to_str().unwrap();
    let grid = ["--alpha", "70:80:5", "--phi", "30:40:5", "--delta", "0:10:5"];
    json(&[&["table", "build", "--model", "chen", "--out", file], &grid[..]].concat());
    let text = std::fs::read_to_string(&path).unwrap();
    let row = text.lines().find(|line| line.starts_with("75.0,35.0,5.0,")).unwrap();
    std::fs::write(&path, text.replace(row, "75.0,35.0,5.0,0.5,solved")).unwrap();
    let (code, answer) = json(&["table", "check", file]);
    assert_eq!((code, &answer["consistent"]), (1, &false.into()));
    let along: Vec<_> = answer["violations"].as_array().unwrap().iter().map(|v| v["along"].clone()).collect();
    assert_eq!(along, ["alpha", "phi", "delta"].map(serde_json::Value::from));
    let words = soilctl(&["table", "check", file]);
    assert_eq!(words.status.code(), Some(1));
    assert!(String::from_utf8(words.stdout).unwrap().contains("does not grow: 3"));

    let sidecar = path.with_extension("csv.json");
    let other = std::fs::read_to_string(&sidecar).unwrap().replace("table-file/1", "table-file/9");
    std::fs::write(&sidecar, other).unwrap();
    assert!(refused(&["table", "check", file]).contains("table-file/9"));
    std::fs::remove_file(&sidecar).unwrap();
    assert!(refused(&["table", "check", file]).contains("t.csv.json"));
}

#[test]
fn wrong_usage_is_refused() {
    assert!(refused(&["table", "show", "nothing"]).contains("appendix-c-chen"));
    assert!(refused(&["table", "build", "--out", "t.txt"]).contains(".csv or .parquet"));
    assert!(refused(&["table", "build", "--out", "t.csv", "--phi", "50:25:5"]).contains("FROM:TO:STEP"));
    let large = ["--alpha", "20:140:0.1", "--phi", "1:60:0.1", "--delta", "0:60:0.1"];
    assert!(
        refused(&[&["table", "build", "--out", "t.csv"], &large[..]].concat()).contains("at most 2000000")
    );
    let outside = refused(&["table", "build", "--model", "caquot", "--out", "t.csv", "--alpha", "20:40:5"]);
    assert!(outside.contains("no node of the table could be filled: model caquot covers alpha"), "{outside}");
}
