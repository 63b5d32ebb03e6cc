//! `soilctl bound` and `soilctl certify` as a user runs them.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::process::Command;

use serde_json::Value;

fn soilctl(args: &[&str]) -> (i32, Value, String) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_soilctl")).args(args).args(["--format", "json"]).output().unwrap();
    let json = serde_json::from_slice(&output.stdout).unwrap_or(Value::Null);
    (output.status.code().unwrap(), json, String::from_utf8(output.stderr).unwrap())
}

const PLATE: [&str; 9] = ["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-elements", "1500"];

#[test]
fn bounds_are_proven_saved_and_proven_again() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("plate.json");
    let file = file.to_str().unwrap();
    let (code, answer, _) = soilctl(&[&PLATE[..], &["--max-gap", "0.2", "--save", file]].concat());
    assert_eq!(code, 0);
    assert_eq!(answer["schema"], "soilctl.bound/1");
    assert_eq!(answer["certified"], true);
    let (lower, upper) = (answer["lower"].as_f64().unwrap(), answer["upper"].as_f64().unwrap());
    assert!(lower <= 8.0 / 3.0 && 8.0 / 3.0 <= upper, "{lower} {upper}");
    let (code, proof, _) = soilctl(&["certify", file]);
    assert_eq!(code, 0);
    assert_eq!(proof["certified"], true);
    // The plate is at right angles and smooth: K = 2 F.
    assert!((2.0 * proof["lower"]["proven"].as_f64().unwrap() - lower).abs() < 1e-12);

    let mut saved: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
    saved["upper"]["claimed"] = Value::from(1.0);
    // What a file calls itself is not what is proven.
    saved["scale"]["description"] = Value::from("phi 45 deg");
    std::fs::write(file, saved.to_string()).unwrap();
    let (code, proof, _) = soilctl(&["certify", file]);
    assert_eq!(code, 1);
    assert_eq!(proof["upper"]["confirmed"], false);
    assert_eq!(proof["lower"]["confirmed"], true);
    assert_eq!(proof["description"], "phi 45 deg");
    let said: Vec<_> =
        proof["statement"].as_array().unwrap().iter().map(|said| said["says"].as_str().unwrap()).collect();
    assert!(
        said[0].starts_with("number 0, friction 30 deg, cohesion 0, unit weight 1; corners "),
        "{said:?}"
    );
    let all = said.join("\n");
    for words in [
        "plane strain",
        "times its velocity (1, ",
        "face of the structure, friction 0 deg",
        "the soil goes on beyond",
    ] {
        assert!(all.contains(words) && !all.contains("45"), "{words} in {all}");
    }
}

#[test]
fn a_plate_with_a_width_has_ends() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (file, page) = (path("ended.json"), path("ended.html"));
    let rough = ["bound", "--alpha", "90", "--phi", "30", "--delta", "15", "--max-elements", "2500"];
    let asked =
        ["--max-gap", "0.02", "--width-ratio", "5", "--tetrahedra", "0", "--save", &file, "--report", &page];
    let (code, answer, stderr) = soilctl(&[&rough[..], &asked].concat());
    assert_eq!(code, 0, "{stderr}");
    let of = |row: &Value| ["lower", "upper"].map(|key| row[key].as_f64().unwrap());
    let ([lower, upper], plane) = (of(&answer), of(&answer["plane_strain"]));
    // Near the exact 4.3107 of plane strain, and another program's mechanism at this width.
    assert!(lower > 4.25 && lower < 4.3107 && plane[1] > 4.3107 && plane[1] < 4.5, "{lower} {plane:?}");
    assert!(upper <= 5.196 && upper > 5.1, "{upper}");
    assert_eq!((&answer["ends"], &answer["width_ratio"]), (&"finite".into(), &5.0.into()));
    assert_eq!((&answer["lower_proof"], &answer["upper_proof"]), (&"splice".into(), &"mechanism".into()));
    assert_eq!(answer["end"]["why_none"], "none was asked for");
    let rows = answer["over_width"].as_array().unwrap();
    assert!(rows.windows(2).all(|pair| of(&pair[0])[1] >= of(&pair[1])[1]));
    assert_eq!(rows[rows.len() - 1]["width_ratio"], Value::Null);
    assert!(std::fs::read_to_string(&page).unwrap().contains("times as wide as deep"));

    let svg = path("blocks.svg");
    let (code, proof, _) = soilctl(&["certify", &file, "--plot", &svg, "--plot-kind", "blocks"]);
    assert_eq!((code, &proof["certified"]), (0, &true.into()));
    assert!(std::fs::read_to_string(&svg).unwrap().contains("blocks in space"));
    let proven = proof["upper"]["proven"].as_f64().unwrap();
    assert!((2.0 * proven / 105_f64.to_radians().sin() - upper).abs() < 1e-12, "{proven}");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replacen("\"width\":5.0", "\"width\":4.0", 1)).unwrap();
    let (code, proof, _) = soilctl(&["certify", &file]);
    assert_eq!((code, &proof["certified"]), (1, &false.into()));

    // In metres; without ends; and what does not go together.
    let sizes = ["--max-gap", "0.2", "--width", "0.5", "--depth", "0.1", "--tetrahedra", "0"];
    let (_, answer, _) = soilctl(&[&rough[..], &sizes].concat());
    assert_eq!(answer["width_ratio"], 5.0);
    assert!((of(&answer)[1] - upper).abs() < 1e-9);
    let (_, answer, _) = soilctl(&[&rough[..], &sizes, &["--ends", "none"]].concat());
    assert_eq!((&answer["ends"], &answer["upper_proof"]), (&"none".into(), &"plane".into()));
    for (args, words) in [
        (&["--width", "0.5"][..], "depends on its width over its depth"),
        (&["--ends", "finite"], "depends on its width over its depth"),
        (&["--width", "0.5", "--width-ratio", "5"], "leave one out"),
        (&["--width-ratio", "0"], "0"),
    ] {
        let (code, _, stderr) = soilctl(&[&rough[..], args].concat());
        assert!(code == 2 && stderr.contains(words), "{args:?}: {stderr}");
    }
}

/// Plane strain has 4.3107; another program's stress field in space, 4.575, and its mechanism, 5.196.
#[test]
#[cfg_attr(not(target_os = "linux"), ignore = "such fields are made on Linux only, so far")]
fn a_stress_field_in_space_counts_what_ends_add() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (file, vtu, page) = (path("ended.json"), path("ended.vtu"), path("ended.html"));
    let rough = [
        "bound",
        "--alpha",
        "90",
        "--phi",
        "30",
        "--delta",
        "15",
        "--max-elements",
        "1000",
        "--width-ratio",
        "5",
    ];
    let asked =
        ["--max-gap", "0.2", "--tetrahedra", "200", "--save", &file, "--vtu", &vtu, "--report", &page];
    let (code, answer, stderr) = soilctl(&[&rough[..], &asked].concat());
    assert_eq!(code, 0, "{stderr}");
    let of = |row: &Value| ["lower", "upper"].map(|key| row[key].as_f64().unwrap());
    let ([lower, upper], [plane, _]) = (of(&answer), of(&answer["plane_strain"]));
    assert!(lower > 1.02 * plane && lower > 4.35 && upper <= 5.196, "{lower} {upper} {plane}");
    assert_eq!((&answer["lower_proof"], &answer["end"]["lower"]), (&"space".into(), &answer["lower"]));
    // One field for all widths that hold it twice; narrower plates have the plane one.
    for row in answer["over_width"].as_array().unwrap() {
        let [lower, upper] = of(row);
        assert!(lower >= plane - 1e-12 && lower <= upper, "{row}");
        let is_space = row["width_ratio"].as_f64().is_some_and(|ratio| (2.0..=20.0).contains(&ratio));
        assert!(!is_space || row["lower_proof"] == "space", "{row}");
    }
    let files = ["vtu", "blocks.vtu", "end.vtu", "html"].map(|ending| path(&format!("ended.{ending}")));
    assert_eq!(answer["results"]["files"], serde_json::json!(files));
    assert!(std::fs::read_to_string(&page).unwrap().contains("pressure on the plate near its end"));

    let map = path("end.svg");
    let (code, proof, stderr) = soilctl(&["certify", &file, "--plot", &map, "--plot-kind", "end"]);
    assert_eq!((code, &proof["certified"]), (0, &true.into()), "{stderr}");
    assert!(std::fs::read_to_string(&map).unwrap().contains("near its end"));
    let proven = proof["lower"]["proven"].as_f64().unwrap();
    assert!((2.0 * proven / 105_f64.to_radians().sin() - lower).abs() < 1e-12, "{proven}");
    // Less friction on the plate than the field needs; a narrower plate than it is for.
    let text = std::fs::read_to_string(&file).unwrap();
    for (is, becomes) in [("\"delta_deg\":15.0", "\"delta_deg\":14.0"), ("\"width\":5.0", "\"width\":0.5")] {
        std::fs::write(&file, text.replace(is, becomes)).unwrap();
        let (code, proof, _) = soilctl(&["certify", &file]);
        assert_eq!((code, &proof["lower"]["proven"]), (1, &Value::Null), "{becomes}: {proof}");
    }

    let leaning = [
        "bound",
        "--alpha",
        "80",
        "--phi",
        "30",
        "--delta",
        "15",
        "--max-elements",
        "1000",
        "--max-gap",
        "0.2",
    ];
    let (code, answer, _) = soilctl(&[&leaning[..], &["--width-ratio", "5"]].concat());
    assert_eq!((code, &answer["lower_proof"]), (0, &"splice".into()));
    assert!(answer["end"]["why_none"].as_str().unwrap().contains("upright"));
}

#[test]
fn results_are_told_and_shown_in_every_form() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (saved, svg) = (path("plate.json"), path("velocity.svg"));
    let files = ["--max-gap", "0.2", "--save", &saved, "--plot", &svg];
    let (code, answer, stderr) = soilctl(&[&PLATE[..], &files].concat());
    assert_eq!(code, 0, "{stderr}");
    let results = &answer["results"];
    assert_eq!(results["files"], serde_json::json!([svg]));
    assert_eq!(results["length_unit"], "L");
    // Rankine's wedges.
    let root = 3.0_f64.sqrt();
    let [ahead, behind] = ["wedge_ahead", "wedge_behind"].map(|key| answer[key].as_f64().unwrap());
    assert!((ahead / root - 1.0).abs() < 0.1 && (behind * root - 1.0).abs() < 0.2, "{ahead} {behind}");
    let contacts = results["contacts"].as_array().unwrap();
    let force = |face: &str| {
        let contact = contacts.iter().find(|c| c["face"] == face).unwrap();
        contact["normal_force"].as_f64().unwrap()
    };
    // The plate is smooth and upright: K = 2 F.
    let net = 2.0 * (force("front") - force("back"));
    assert!((net - answer["lower"].as_f64().unwrap()).abs() < 1e-9, "{net}");

    let mut sizes = Vec::new();
    for (kind, ending) in [
        ("velocity", "csv"),
        ("dissipation", "svg"),
        ("stress", "svg"),
        ("contact", "png"),
        ("contact", "csv"),
        ("all", "html"),
        ("all", "svg"),
    ] {
        let file = path(&format!("{kind}.{ending}"));
        let (code, proof, stderr) = soilctl(&["certify", &saved, "--plot", &file, "--plot-kind", kind]);
        assert_eq!(code, 0, "{kind}.{ending}: {stderr}");
        assert_eq!(proof["files"], serde_json::json!([file]));
        let bytes = std::fs::read(&file).unwrap();
        let start: &[u8] = match ending {
            "svg" => b"<svg",
            "png" => b"\x89PNG",
            "csv" => b"layer,kind,name",
            _ => b"<!",
        };
        assert!(bytes.starts_with(start), "{kind}.{ending}");
        sizes.push(bytes.len());
    }
    // Edges of more than a thousand triangles in one figure stay small.
    assert!(std::fs::metadata(&svg).unwrap().len() < 500_000);
    assert!(sizes.iter().all(|size| *size < 8_000_000), "{sizes:?}");
}

#[test]
fn linear_programs_give_wider_bounds_that_are_proven_too() {
    let (code, answer, stderr) = soilctl(&[&PLATE[..], &["--max-gap", "0.2", "--segments", "12"]].concat());
    assert_eq!(code, 0, "{stderr}");
    let (lower, upper) = (answer["lower"].as_f64().unwrap(), answer["upper"].as_f64().unwrap());
    assert!(lower <= 8.0 / 3.0 && 8.0 / 3.0 <= upper, "{lower} {upper}");
    // Twelve sides inside of the circle bear a friction of 28.9 deg, whose coefficient is 2.52.
    assert!(answer["gap"].as_f64().unwrap() > 0.02);
}

#[test]
fn a_budget_that_ends_first_is_exit_code_3_with_the_best_bounds() {
    let (code, answer, _) = soilctl(&[&PLATE[..], &["--max-gap", "1e-9"]].concat());
    assert_eq!(code, 3);
    assert_eq!((&answer["ended"], &answer["stopped_by"]), (&"elements".into(), &"work".into()));
    assert_eq!(answer["certified"], true);
    let plate = ["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-gap", "1e-9"];
    let (code, answer, _) = soilctl(&[&plate[..], &["--max-work", "60000"]].concat());
    assert_eq!(code, 3);
    assert_eq!((&answer["ended"], &answer["stopped_by"]), (&"work".into(), &"work".into()));
}

#[test]
fn what_factorised_the_systems_is_in_the_answer_and_in_the_saved_solution() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("plate.json");
    let file = file.to_str().unwrap();
    for (options, name) in [(&[][..], "qdldl"), (&["--factorisation", "faer"][..], "faer")] {
        let (_, answer, stderr) =
            soilctl(&[&PLATE[..], &["--max-gap", "0.2", "--save", file], options].concat());
        assert_eq!(answer["lower_factorisation"], name, "{stderr}");
        assert_eq!(answer["upper_factorisation"], name);
        let mut saved: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
        assert_eq!(saved["upper"]["computed"]["factorisation"], name);
        assert_eq!(soilctl(&["certify", file]).0, 0);
        // Solutions of earlier versions do not have it.
        for side in ["lower", "upper"] {
            saved[side].as_object_mut().unwrap().remove("computed").unwrap();
        }
        std::fs::write(file, saved.to_string()).unwrap();
        assert_eq!(soilctl(&["certify", file]).0, 0);
    }
}

#[test]
fn forces_are_coefficients_in_newtons() {
    let sizes =
        ["--depth", "0.1", "--width", "0.5", "--density", "1600", "--max-gap", "0.2", "--tetrahedra", "0"];
    let (_, answer, _) = soilctl(&[&PLATE[..], &sizes].concat());
    let newtons = 0.5 * 1600.0 * 9.80665 * 0.1 * 0.1 * 0.5;
    let force = answer["force_lower_n"].as_f64().unwrap();
    assert!((force / (newtons * answer["lower"].as_f64().unwrap()) - 1.0).abs() < 1e-12);
}

#[test]
fn bad_input_is_refused_in_words() {
    for (args, words) in [
        (["bound", "--alpha", "90", "--phi", "30", "--delta", "31"].as_slice(), "interface friction"),
        (["bound", "--alpha", "90", "--phi", "0", "--delta", "0"].as_slice(), "friction angle"),
        (["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--cohesion", "5"].as_slice(), "--depth"),
        (["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-gap", "0"].as_slice(), "above 0"),
        (["certify", "no-such-file.json"].as_slice(), "no-such-file.json"),
        ([&PLATE[..], &["--plot", "a.gif"]].concat().as_slice(), ".svg, .png, .html or .csv"),
        ([&PLATE[..], &["--plot", "a.csv", "--plot-kind", "all"]].concat().as_slice(), "one figure"),
        ([&PLATE[..], &["--vtu", "a.txt"]].concat().as_slice(), ".vtu"),
        ([&PLATE[..], &["--mesh", "a"]].concat().as_slice(), ".msh"),
        ([&PLATE[..], &["--dump", "no/such/folder"]].concat().as_slice(), "no/such/folder"),
        ([&PLATE[..], &["--segments", "2"]].concat().as_slice(), "at least 3 and at most 1000"),
    ] {
        let (code, _, stderr) = soilctl(args);
        assert_eq!(code, 2, "{args:?}");
        assert!(stderr.contains(words), "{args:?}: {stderr}");
    }
}
