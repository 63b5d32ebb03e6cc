use std::path::{Path, PathBuf};

use soilctl_limit_analysis::describe::{Aim, Side};
use soilctl_limit_analysis::{Description, DescriptionError};

use crate::common::refusals;

fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/problems");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path()).collect();
    files.sort();
    files
}

#[test]
fn examples_are_problems_that_the_checker_takes() {
    assert!(examples().len() >= 7);
    for file in examples() {
        let description = Description::read(&file).unwrap();
        let described = description.described().unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        let refusals = refusals(&described.statement);
        assert!(refusals.is_empty(), "{}: {refusals:?}", file.display());
    }
}

#[test]
fn toml_and_json_say_the_same() {
    for file in examples() {
        let description = Description::read(&file).unwrap();
        let toml = description.to_toml().unwrap();
        assert_eq!(Description::from_toml(&toml).unwrap(), description);
        let json = serde_json::to_string(&description).unwrap();
        assert_eq!(Description::from_json(&json).unwrap(), description);
    }
}

#[test]
fn the_shortest_file_is_short() {
    let text = r#"
        default_boundary = "free"
        objective = { kind = "unit-weight" }
        soil = [{ name = "clay", phi_deg = 0, cohesion_kpa = 20, unit_weight_kn_m3 = 18 }]
        region = [{ soil = "clay", polygon = [[0, 0], [4, 0], [4, 3], [0, 3]] }]
        boundary = [{ kind = "fixed", sides = ["bottom"] }, { kind = "smooth", sides = ["right"] }]
    "#;
    let description = Description::from_toml(text).unwrap();
    assert_eq!(description.objective, Aim::UnitWeight {});
    assert_eq!(description.boundaries[1].sides, [Side::Right]);
    let described = description.described().unwrap();
    assert!(refusals(&described.statement).is_empty());
}

#[test]
fn mistakes_are_named_with_line_and_key() {
    for (text, words) in [
        ("objective = { kind = \"weight\" }", "unknown variant `weight`"),
        ("objective = { kind = \"load\" }\nsoils = []", "unknown field `soils`"),
        ("objective = { kind = \"load\" }\n[[soil]]\nname = \"a\"\nphi = 3", "unknown field `phi`"),
        ("objective = { kind = \"load\" }\n[[soil]]\nphi_deg = \"thirty\"", "line 3"),
        ("objective = { kind = \"load\", name = \"x\" }", "unknown field `name`"),
        ("schema = \"soilctl.problem/9\"\nobjective = { kind = \"load\" }", "soilctl.problem/1"),
        ("", "missing field `objective`"),
    ] {
        let error = Description::from_toml(text).unwrap_err();
        assert!(matches!(error, DescriptionError::Format { .. }));
        assert!(error.to_string().contains(words), "{text}: {error}");
    }
}

#[test]
fn files_that_are_none_are_refused() {
    assert!(matches!(Description::read(Path::new("a.txt")), Err(DescriptionError::Ending { .. })));
    assert!(matches!(Description::read(Path::new("no-such.toml")), Err(DescriptionError::File { .. })));
    let endless = Path::new("/dev/zero.toml");
    assert!(matches!(Description::read(endless), Err(DescriptionError::File { .. })));
}
