//! `soilctl solve` as a user runs it.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn soilctl(args: &[&str]) -> (i32, Value, String) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_soilctl")).args(args).args(["--format", "json"]).output().unwrap();
    let json = serde_json::from_slice(&output.stdout).unwrap_or(Value::Null);
    (output.status.code().unwrap(), json, String::from_utf8(output.stderr).unwrap())
}

fn example(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/problems");
    root.join(name).to_str().unwrap().to_owned()
}

fn write(dir: &Path, name: &str, text: &str) -> PathBuf {
    let path = dir.join(name);
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn a_passive_wall_is_bounded_saved_and_proven_again() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("wall.json");
    let file = file.to_str().unwrap();
    let wall = example("wall_passive.toml");
    let (code, answer, stderr) =
        soilctl(&["solve", &wall, "--max-gap", "0.5", "--max-elements", "1500", "--save", file]);
    assert_eq!(code, 0, "{stderr}");
    assert_eq!(answer["schema"], "soilctl.solve/1");
    assert_eq!(answer["quantity"], "force_kn_per_m");
    assert_eq!(answer["certified"], true);
    assert!(answer["seconds"].as_f64().unwrap() > 0.0);
    let (lower, upper) = (answer["lower"].as_f64().unwrap(), answer["upper"].as_f64().unwrap());
    // A smooth wall would need Rankine's force at least, and one as rough as the soil's friction some 840 kN/m.
    let smooth = 81.0 * 3.690;
    assert!(lower > smooth && lower < upper && upper < 840.0, "{lower} {upper}");
    assert!((answer["gap"].as_f64().unwrap() - 2.0 * (upper - lower) / (upper + lower)).abs() < 1e-12);
    let (code, proof, _) = soilctl(&["certify", file]);
    assert_eq!(code, 0);
    assert_eq!(proof["certified"], true);
    // Three metres times 54 kPa.
    assert!((162.0 * proof["lower"]["proven"].as_f64().unwrap() - lower).abs() < 1e-9);
}

#[test]
fn an_active_wall_is_pushed_by_the_soil() {
    let wall = example("wall_active.toml");
    let (code, answer, _) = soilctl(&["solve", &wall, "--max-gap", "0.1", "--max-elements", "1500"]);
    assert_eq!(code, 0);
    let (lower, upper) = (answer["lower"].as_f64().unwrap(), answer["upper"].as_f64().unwrap());
    assert!(lower < upper && upper < 0.0);
    // Between a third more and less than Coulomb's wedge.
    let (phi, delta) = (35.0_f64.to_radians(), 20.0_f64.to_radians());
    let root = ((phi + delta).sin() * phi.sin() / delta.cos()).sqrt();
    let coulomb = 81.0 * (phi.cos() / (1.0 + root)).powi(2);
    assert!(lower <= -0.9 * coulomb && -1.1 * coulomb <= upper, "{lower} {upper} {coulomb}");
    assert!(answer["gap"].as_f64().unwrap() > 0.0);
}

#[test]
fn a_budget_that_ends_first_is_exit_code_3_with_the_best_bounds() {
    let wall = example("wall_passive.toml");
    let (code, answer, _) = soilctl(&["solve", &wall, "--max-gap", "1e-9", "--max-elements", "1000"]);
    assert_eq!(code, 3);
    assert_eq!(answer["ended"], "elements");
}

#[test]
fn a_check_says_what_the_file_means_without_solving() {
    for file in std::fs::read_dir(example("")).unwrap() {
        let file = file.unwrap().path();
        let (code, answer, stderr) = soilctl(&["solve", file.to_str().unwrap(), "--check"]);
        assert_eq!(code, 0, "{}: {stderr}", file.display());
        assert_eq!(answer["schema"], "soilctl.solve-check/1");
    }
    let (_, answer, _) = soilctl(&["solve", &example("slope.toml"), "--check"]);
    assert_eq!(answer["quantity"], "factor_of_safety");
    let area: f64 =
        answer["regions"].as_array().unwrap().iter().map(|r| r["area_m2"].as_f64().unwrap()).sum();
    assert!((area - (6.0 * 55.0 + 6.0 * 28.0 + 36.0)).abs() < 1e-9);
    let free = &answer["boundaries"][0];
    assert_eq!(free["kind"], "free");
    assert!((free["length_m"].as_f64().unwrap() - (15.0 + 180.0_f64.sqrt() + 28.0)).abs() < 1e-9);
}

#[test]
fn a_check_draws_the_problem_and_refuses_what_needs_a_solution() {
    let dir = tempfile::tempdir().unwrap();
    let (slope, csv) = (example("slope.toml"), dir.path().join("slope.csv"));
    assert_eq!(soilctl(&["solve", &slope, "--check", "--plot", csv.to_str().unwrap()]).0, 0);
    let drawn = std::fs::read_to_string(&csv).unwrap();
    for named in [
        ",\"silt: φ 25°, c 12 kPa, 19 kN/m³\",",
        ",free surface,",
        ",fixed base: no motion,",
        ",smooth side: slides along,",
        ",water table,",
        "-15.0,-6.0",
        "40.0,6.0",
    ] {
        assert!(drawn.contains(named), "{named} is not in {drawn}");
    }
    for option in ["--report", "--vtu", "--mesh", "--figures", "--save"] {
        let (code, _, stderr) = soilctl(&["solve", &slope, "--check", option, "x.svg"]);
        assert!(code == 2 && stderr.contains(option) && stderr.contains("--check"), "{option}: {stderr}");
    }
    let (code, _, stderr) = soilctl(&["solve", &slope, "--check", "--plot", "x.txt"]);
    assert!(code == 2 && stderr.contains(".svg"), "{stderr}");
}

#[test]
fn json_files_say_the_same_as_toml_files() {
    let dir = tempfile::tempdir().unwrap();
    let wall = example("wall_passive.toml");
    let description = soilctl_limit_analysis::Description::read(Path::new(&wall)).unwrap();
    let json = write(dir.path(), "wall.json", &serde_json::to_string(&description).unwrap());
    let (code, answer, _) = soilctl(&["solve", json.to_str().unwrap(), "--check"]);
    assert_eq!(code, 0);
    assert_eq!(answer, soilctl(&["solve", &wall, "--check"]).1);
}

#[test]
fn bad_files_are_refused_in_words() {
    let dir = tempfile::tempdir().unwrap();
    let good = std::fs::read_to_string(example("wall_passive.toml")).unwrap();
    for (name, text, words) in [
        ("a.txt", good.clone(), "must end in .toml or .json"),
        ("a.toml", good.replace("phi_deg = 35", "phi_deg = 95"), "soil 1 (\"sand\"): phi_deg is 95"),
        ("b.toml", good.replace("phi_deg", "phi"), "unknown field `phi`"),
        (
            "c.toml",
            good.replace("delta_deg = 20", "delta_deg = 40"),
            "structure 1 (\"wall\"): delta is 40 deg",
        ),
        (
            "d.toml",
            good.replace("default_boundary", "#"),
            "no boundary condition on the outline from (24, 0) to (0, 0)",
        ),
        (
            "e.toml",
            good.replace("[24, -3], [24, 0]", "[24, 0], [24, -3]"),
            "region 1 (\"backfill\"): it crosses",
        ),
        ("f.toml", good.replace("[24, -3]", "[nan, -3]"), "region 1 (\"backfill\"): x is NaN"),
        ("g.toml", "#".repeat(2 << 20), "more than 1048576 bytes"),
        ("h.json", "{".into(), "h.json"),
    ] {
        let path = write(dir.path(), name, &text);
        let (code, _, stderr) = soilctl(&["solve", path.to_str().unwrap()]);
        assert_eq!(code, 2, "{name}");
        assert!(stderr.contains(words), "{name}: {stderr}");
    }
    let (code, _, stderr) = soilctl(&["solve", "no-such-file.toml"]);
    assert_eq!(code, 2);
    assert!(stderr.contains("no-such-file.toml"), "{stderr}");
}

#[test]
fn the_factor_of_safety_of_a_slope_is_bounded_and_each_side_saved() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("slope.json");
    let args = ["--max-gap", "0.1", "--max-elements", "4000", "--save"];
    let slope = example("slope.toml");
    let (code, answer, stderr) =
        soilctl(&[&["solve", &slope][..], &args, &[file.to_str().unwrap()]].concat());
    assert_eq!(code, 0, "{stderr}");
    assert_eq!(answer["quantity"], "factor_of_safety");
    let [lower, upper] = ["lower", "upper"].map(|side| answer[side].as_f64().unwrap());
    // The least of Bishop's simplified method over all circles: not exact, but near.
    assert!(lower < 1.782 * 1.02 && upper > 1.782 * 0.97, "{lower} {upper}");
    for part in ["lower", "upper"] {
        let saved = dir.path().join(format!("slope.{part}.json"));
        let (code, _, _) = soilctl(&["certify", saved.to_str().unwrap()]);
        assert_eq!(code, 0, "{part}");
    }
}

#[test]
fn examples_are_bounded() {
    for name in ["footing_clay.toml", "footing_sand.toml", "plate_layers.toml"] {
        let (code, answer, stderr) = soilctl(&[&["solve", &example(name)][..], &ROUGHLY].concat());
        assert_eq!(code, 0, "{name}: {stderr}");
        assert_eq!(answer["certified"], true);
        // What the stress field presses with is the bound, where the structure moves across a level or upright face.
        let contacts = answer["results"]["contacts"].as_array().unwrap();
        if name.starts_with("footing") {
            let [normal, lower] =
                [&contacts[0]["normal_force"], &answer["lower"]].map(|x| x.as_f64().unwrap());
            assert!((normal / lower - 1.0).abs() < 1e-7, "{name}: {normal} {lower}");
        }
        // Soil moves on both sides of each of them.
        assert_eq!(answer["results"]["moving_ground"].as_array().unwrap().len(), 2, "{name}");
    }
}

const ROUGHLY: [&str; 4] = ["--max-gap", "0.3", "--max-elements", "4000"];

#[test]
fn a_buried_block_is_bounded() {
    let (code, _, stderr) = soilctl(&[&["solve", &example("anchor.toml")][..], &ROUGHLY].concat());
    assert_eq!(code, 0, "{stderr}");
}

#[test]
fn the_factor_of_safety_of_a_cut_is_bounded_saved_and_shown() {
    let dir = tempfile::tempdir().unwrap();
    let text = r#"
        default_boundary = "fixed"
        objective = { kind = "strength-reduction" }
        soil = [{ name = "clay", phi_deg = 0, cohesion_kpa = 20, unit_weight_kn_m3 = 18 }]
        region = [{ soil = "clay", polygon = [[-9, 3], [-9, -4.5], [6, -4.5], [6, 0], [0, 0], [0, 3]] }]
        boundary = [{ kind = "free", line = [[-9, 3], [0, 3], [0, 0], [6, 0]] }]"#;
    let problem = write(dir.path(), "cut.toml", text);
    let [saved, figure] = ["cut.json", "cut.svg"].map(|n| dir.path().join(n).to_str().unwrap().to_owned());
    let budget = ["--max-gap", "0.12", "--max-elements", "2000"];
    let files = ["--save", &saved, "--plot", &figure, "--plot-kind", "dissipation"];
    let (code, answer, stderr) =
        soilctl(&[&["solve", problem.to_str().unwrap()][..], &budget, &files].concat());
    assert_eq!(code, 0, "{stderr}");
    assert_eq!(answer["quantity"], "factor_of_safety");
    // Martin (2011): the critical height is 3.7764 to 3.7776 times cohesion over unit weight.
    let [lower, upper] = ["lower", "upper"].map(|key| answer[key].as_f64().unwrap());
    assert!(lower <= 3.7776 * 20.0 / 54.0 && 3.7764 * 20.0 / 54.0 <= upper, "{lower} {upper}");
    // What moves is the soil behind the cut, and maybe some before its foot.
    let ground = answer["results"]["moving_ground"].as_array().unwrap();
    let [x, y] = [0, 1].map(|i| ground[0]["from"][i].as_f64().unwrap());
    assert!((y - 3.0).abs() < 1e-9 && (-6.0..-1.0).contains(&x), "{x} {y}");
    assert!(std::fs::read_to_string(figure).unwrap().starts_with("<svg"));
    for part in ["lower", "upper"] {
        let saved = dir.path().join(format!("cut.{part}.json"));
        let (code, _, stderr) = soilctl(&["certify", saved.to_str().unwrap()]);
        assert_eq!(code, 0, "{part}: {stderr}");
    }
}

#[test]
fn a_slope_hardly_steeper_than_its_friction_angle_is_not_taken_for_one_that_cannot_fail() {
    let dir = tempfile::tempdir().unwrap();
    let slope = std::fs::read_to_string(example("slope.toml")).unwrap();
    let path = write(dir.path(), "slope.toml", &slope.replace("strength-reduction", "unit-weight"));
    let (code, answer, stderr) = soilctl(&[&["solve", path.to_str().unwrap()][..], &ROUGHLY].concat());
    assert!(code == 0 || code == 3, "{stderr}");
    assert!(answer["lower"].as_f64().unwrap() > 20.0 && answer["upper"].as_f64().unwrap() < 200.0);
}

/// It slides along itself, at `tan(35 deg)` over 1/2. Beside it a load has nothing that holds its edge, which no field of the checker
/// can say: said at once, not after all the work is spent.
#[test]
fn a_slope_of_bare_sand_has_its_factor_and_bears_no_load_beside() {
    let dir = tempfile::tempdir().unwrap();
    let text = r#"
schema = "soilctl.problem/1"
default_boundary = "free"
objective = { kind = "strength-reduction" }
soil = [{ name = "sand", phi_deg = 35, cohesion_kpa = 0, unit_weight_kn_m3 = 18 }]
region = [{ soil = "sand", polygon = [[-10, -4], [25, -4], [25, 4], [8, 4], [0, 0], [-10, 0]] }]
boundary = [{ kind = "fixed", sides = ["left", "right", "bottom"] }LOAD]
"#;
    let bare = write(dir.path(), "sand.toml", &text.replace("LOAD", ""));
    let (code, answer, stderr) = soilctl(&["solve", bare.to_str().unwrap(), "--max-gap", "0.03"]);
    let [lower, upper] = ["lower", "upper"].map(|side| answer[side].as_f64().unwrap());
    let exact = 2.0 * 35.0_f64.to_radians().tan();
    assert!(code == 0 && lower <= exact && exact <= upper, "{code} {lower} {upper} {exact} {stderr}");
    let load = r#", { kind = "load", line = [[10, 4], [14, 4]], pressure_kpa = 10, live = true }"#;
    let loaded = text.replace("LOAD", load).replace("strength-reduction", "load");
    let loaded = write(dir.path(), "load.toml", &loaded);
    let (code, answer, stderr) = soilctl(&["solve", loaded.to_str().unwrap()]);
    assert_eq!((code, answer), (2, Value::Null), "{stderr}");
    assert!(stderr.contains("not covered") && stderr.contains("a load that begins beside"), "{stderr}");
}

#[test]
fn what_has_no_collapse_load_is_said_in_physical_words() {
    let dir = tempfile::tempdir().unwrap();
    let wall = std::fs::read_to_string(example("wall_passive.toml")).unwrap();
    let cut = r#"
        default_boundary = "free"
        objective = { kind = "structure", name = "footing", direction = [0, -1] }
        soil = [{ name = "sand", phi_deg = 30, unit_weight_kn_m3 = 18, cohesion_kpa = 0.5 }]
        region = [{ soil = "sand", polygon = [[0, 0], [0, -10], [20, -10], [20, 5], [10, 5], [10, 0]] }]
        boundary = [{ kind = "fixed", sides = ["left", "right", "bottom"] }]
        structure = [{ name = "footing", edge = [[4, 0], [6, 0]], delta_deg = 30 }]"#;
    let nothing = wall
        .replace("phi_deg = 35", "phi_deg = 0")
        .replace("unit_weight_kn_m3 = 18", "unit_weight_kn_m3 = 0")
        .replace("delta_deg = 20", "delta_deg = 0");
    for (name, text, words) in [
        // Soil that fixed boundaries hold on all sides.
        ("locked.toml", wall.replace("boundary = \"free\"", "boundary = \"fixed\""), "nothing can move"),
        // A vertical cut, five metres high, that stands for no more than a few decimetres.
        ("cut.toml", cut.to_owned(), "fails under its own weight"),
        ("nothing.toml", nothing, "nothing resists"),
    ] {
        let path = write(dir.path(), name, &text);
        let budget = ["--max-elements", "1000"];
        let (code, answer, stderr) = soilctl(&[&["solve", path.to_str().unwrap()][..], &budget].concat());
        assert_eq!(code, 2, "{name}: {stderr}");
        assert_eq!(answer, Value::Null, "{name}");
        assert!(stderr.contains(words), "{name}: {stderr}");
    }
}

/// A strip on weightless clay bears `(2 + pi) c_u`, so each case has an exact value: with the factors of combination 2
/// `(2 + pi) c_u / 1.4` over 1.3 times the load.
#[test]
fn cases_and_sweeps_are_bounded_each_and_the_least_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let text = r#"
        default_boundary = "free"
        objective = { kind = "load" }
        soil = [{ name = "clay", phi_deg = 0, cohesion_kpa = 50, unit_weight_kn_m3 = 0 }]
        region = [{ soil = "clay", polygon = [[-5, 0], [5, 0], [5, -4], [-5, -4]] }]
        boundary = [
            { kind = "fixed", sides = ["left", "right", "bottom"] },
            { name = "strip", kind = "load", line = [[-1, 0], [1, 0]], pressure_kpa = 100, live = true, action = "variable" },
        ]
        case = [{ name = "plain" }, { name = "DA1-2", approach = "da1-2" }, { name = "halved", factors = { resistance = 2 } }]
        sweep = [{ parameter = "soil.clay.cohesion_kpa", values = [42, 84] }]
    "#;
    let file = write(dir.path(), "strip.toml", text);
    let (file, save) = (file.to_str().unwrap(), dir.path().join("proof.json"));
    let run = |threads: &str| {
        let save = save.to_str().unwrap();
        soilctl(&["solve", file, "--max-gap", "0.1", "--threads", threads, "--save", save])
    };
    let (code, answer, stderr) = run("2");
    assert_eq!(code, 0, "{stderr}");
    let cases = answer["cases"].as_array().unwrap();
    let per_kpa = (2.0 + std::f64::consts::PI) / 100.0;
    let expected = [
        ("plain", 42.0, 1.0),
        ("plain", 84.0, 1.0),
        ("DA1-2", 42.0, 1.4 * 1.3),
        ("DA1-2", 84.0, 1.4 * 1.3),
        ("halved", 42.0, 2.0),
        ("halved", 84.0, 2.0),
    ];
    assert_eq!(cases.len(), expected.len());
    for (case, (name, cohesion, over)) in cases.iter().zip(expected) {
        let exact = per_kpa * cohesion / over;
        assert_eq!(case["name"], format!("{name}, soil.clay.cohesion_kpa = {cohesion}"));
        assert_eq!(case["values"]["soil.clay.cohesion_kpa"], cohesion);
        let [lower, upper] = ["lower", "upper"].map(|side| case[side].as_f64().unwrap());
        assert!(lower <= exact && exact <= upper, "{case} {exact}");
        assert!(case["gap"].as_f64().unwrap() < 0.1 && case["certified"] == true);
        let enough = if lower >= 1.0 {
            Value::from(true)
        } else if upper < 1.0 {
            Value::from(false)
        } else {
            Value::Null
        };
        assert_eq!(case["enough"], enough);
    }
    assert_eq!(answer["governing"], "halved, soil.clay.cohesion_kpa = 42");
    assert_eq!((&answer["lower"], &answer["upper"]), (&cases[4]["lower"], &cases[4]["upper"]));
    // That of combination 2 at 42 kPa: the statement is of 30 kPa under 130.
    let (code, proof, _) = soilctl(&["certify", dir.path().join("proof.3.json").to_str().unwrap()]);
    assert_eq!((code, &proof["certified"]), (0, &Value::from(true)));
    assert!((proof["lower"]["proven"].as_f64().unwrap() - cases[2]["lower"].as_f64().unwrap()).abs() < 1e-12);
    let (_, again, _) = run("1");
    assert_eq!(again["cases"], answer["cases"]);
    let (code, checked, _) = soilctl(&["solve", file, "--check"]);
    assert_eq!((code, checked["cases"].as_array().unwrap().len()), (0, 6));
    assert_eq!(
        checked["cases"][2]["factors"],
        serde_json::json!({"friction": 1.25, "cohesion": 1.25, "undrained": 1.4, "variable": 1.3})
    );
}

#[test]
fn a_case_without_bounds_is_named_and_the_others_are_told() {
    let dir = tempfile::tempdir().unwrap();
    let text = r#"
        default_boundary = "free"
        objective = { kind = "unit-weight" }
        soil = [{ name = "clay", phi_deg = 0, cohesion_kpa = 20, unit_weight_kn_m3 = 18 }]
        region = [{ soil = "clay", polygon = [[0, -3], [9, -3], [9, 0], [5, 0], [3, 2], [0, 2]] }]
        boundary = [{ kind = "fixed", sides = ["left", "right", "bottom"] }]
        case = [{ name = "stands" }, { name = "no strength", set = { "soil.clay.cohesion_kpa" = 0 } }]
    "#;
    let file = write(dir.path(), "slope.toml", text);
    let (code, answer, stderr) = soilctl(&["solve", file.to_str().unwrap(), "--max-gap", "0.2"]);
    assert_eq!(code, 3, "{stderr}");
    assert_eq!((&answer["certified"], &answer["governing"]), (&Value::from(false), &Value::from("stands")));
    assert!(answer["cases"][1]["lower"].is_null() && answer["cases"][1]["problem"].is_string());
    assert!(stderr.contains("no strength"), "{stderr}");
}
