//! Load cases, partial factors and sweeps: what becomes of the values of a file.

use std::f64::consts::PI;

use soilctl_limit_analysis::describe::{Case, Profile};
use soilctl_limit_analysis::{Description, DescriptionError, Options, bound};

/// A strip of 2 m on soil, with all that a factor can act on.
const STRIP: &str = r#"
title = "strip"
surcharge_kpa = 10
default_boundary = "free"
objective = { kind = "load" }

[[soil]]
name = "sand"
phi_deg = 30
cohesion_kpa = 5
unit_weight_kn_m3 = 20

[[soil]]
name = "soft clay 1.2"
phi_deg = 0
cohesion_kpa = 28
unit_weight_kn_m3 = 16

[[region]]
soil = "sand"
polygon = [[-8, 0], [8, 0], [8, -1], [-8, -1]]

[[region]]
soil = "soft clay 1.2"
polygon = [[-8, -1], [8, -1], [8, -6], [-8, -6]]

[[boundary]]
kind = "fixed"
sides = ["left", "right", "bottom"]

[[boundary]]
name = "wall"
kind = "load"
line = [[-1, 0], [1, 0]]
pressure_kpa = 100
live = true

[water]
table = [[0, -2]]
"#;

fn cases(more: &str) -> Result<Vec<Case>, DescriptionError> {
    Description::from_toml(&format!("{STRIP}\n{more}")).unwrap().cases()
}

fn message(more: &str) -> String {
    cases(more).unwrap_err().to_string()
}

fn tan(deg: impl Into<Option<f64>>) -> f64 {
    deg.into().unwrap().to_radians().tan()
}

#[test]
fn a_file_without_cases_has_none() {
    assert!(cases("").unwrap().is_empty());
}

#[test]
fn each_factor_acts_on_what_it_is_for() {
    let all = cases(
        r#"
        [[case]]
        name = "all"
        factors = { friction = 1.25, cohesion = 1.6, undrained = 1.4, weight = 1.1, water = 1.2, resistance = 1.4 }
        "#,
    )
    .unwrap();
    let [case] = &all[..] else { panic!("{all:?}") };
    let [sand, clay] = &case.description.soils[..] else { panic!() };
    assert!((tan(sand.phi_deg) - tan(30.0) / 1.25).abs() < 1e-15);
    assert_eq!((sand.cohesion_kpa, clay.cohesion_kpa, clay.phi_deg), (5.0 / 1.6, 28.0 / 1.4, Some(0.0)));
    assert_eq!((sand.unit_weight_kn_m3, clay.unit_weight_kn_m3), (20.0 * 1.1, 16.0 * 1.1));
    assert_eq!(case.description.water.as_ref().unwrap().unit_weight_kn_m3, 9.81 * 1.2);
    assert_eq!(case.resistance, 1.4);
    assert_eq!(case.description.title.as_deref(), Some("strip, all"));
    assert!(case.description.cases.is_empty() && case.values.is_empty());
}

/// The recommended values of EN 1997-1:2004, Annex A, as handbooks print them.
#[test]
fn design_approaches_have_the_recommended_factors() {
    let approach = |name: &str, more: &str| {
        let text = STRIP
            .replace("live = true", "live = true\naction = \"variable\"")
            .replace("surcharge_kpa = 10", "surcharge_kpa = 10\nsurcharge_action = \"permanent\"");
        let text = format!("{text}\n[[case]]\nname = \"x\"\napproach = \"{name}\"\n{more}");
        Description::from_toml(&text).unwrap().cases().unwrap().remove(0).description
    };
    let acts = |d: &Description| {
        let Some(Profile::Uniform(load)) = d.boundaries[1].pressure_kpa else { panic!() };
        let near = |x: f64| (x * 1e6).round() / 1e6;
        let soil = &d.soils;
        [
            d.surcharge_kpa / 10.0,
            load / 100.0,
            soil[0].unit_weight_kn_m3 / 20.0,
            tan(30.0) / tan(soil[0].phi_deg),
            28.0 / soil[1].cohesion_kpa,
        ]
        .map(near)
    };
    let harms = "soil_weight = \"unfavourable\"";
    assert_eq!(acts(&approach("da1-1", harms)), [1.35, 1.5, 1.35, 1.0, 1.0]);
    assert_eq!(acts(&approach("da1-1", "soil_weight = \"favourable\"")), [1.35, 1.5, 1.0, 1.0, 1.0]);
    assert_eq!(acts(&approach("da1-2", "")), [1.0, 1.3, 1.0, 1.25, 1.4]);
    let da2 = "soil_weight = \"unfavourable\"\nfactors = { resistance = 1.4 }";
    assert_eq!(acts(&approach("da2", da2)), [1.35, 1.5, 1.35, 1.0, 1.0]);
    assert_eq!(acts(&approach("da3", "")), [1.35, 1.5, 1.0, 1.25, 1.4]);
    assert_eq!(acts(&approach("da3-slope", "")), [1.0, 1.3, 1.0, 1.25, 1.4]);
}

#[test]
fn what_a_factor_would_have_to_guess_is_asked_for() {
    let case = |more: &str| message(&format!("[[case]]\nname = \"x\"\n{more}"));
    assert!(case("approach = \"da1-1\"").contains("soil_weight"));
    assert!(case("approach = \"da2\"\nsoil_weight = \"favourable\"").contains("bearing 1.4"));
    let load = case("approach = \"da1-2\"");
    assert!(load.contains("boundary 2 (\"wall\")") && load.contains("action"), "{load}");
    let low = case("factors = { friction = 0 }");
    assert!(low.contains("factors.friction is 0") && low.contains("0.01 to 100"), "{low}");
}

#[test]
fn sweeps_are_combined_with_cases_and_with_each_other() {
    let all = cases(
        r#"
        [[case]]
        name = "dry"
        [[case]]
        name = "flood"
        set = { "water.rise_m" = 1.5, "seismic.kh" = 0.1 }
        [[sweep]]
        parameter = "soil.soft clay 1.2.cohesion_kpa"
        from = 20
        to = 30
        count = 3
        [[sweep]]
        parameter = "boundary.wall.pressure_kpa"
        values = [80, 120]
        "#,
    )
    .unwrap();
    assert_eq!(all.len(), 12);
    let last = &all[11];
    assert_eq!(last.name, "flood, soil.soft clay 1.2.cohesion_kpa = 30, boundary.wall.pressure_kpa = 120");
    assert_eq!(last.values["soil.soft clay 1.2.cohesion_kpa"], 30.0);
    assert_eq!(last.description.soils[1].cohesion_kpa, 30.0);
    assert_eq!(last.description.boundaries[1].pressure_kpa, Some(Profile::Uniform(120.0)));
    assert_eq!(last.description.water.as_ref().unwrap().levels(), [[0.0, -0.5]]);
    assert_eq!(last.description.seismic.unwrap().kh, 0.1);
    assert_eq!(all[6].values["soil.soft clay 1.2.cohesion_kpa"], 20.0);
    assert!(all[0].description.seismic.is_none());
}

#[test]
fn parameters_that_there_are_none_of_are_refused_with_what_there_is() {
    let sweep = |parameter: &str| message(&format!("[[sweep]]\nparameter = \"{parameter}\"\nvalues = [1]"));
    assert!(sweep("soil.gravel.phi_deg").contains("\"sand\""));
    assert!(sweep("soil.sand.phi").contains("unknown field `phi`"));
    assert!(sweep("soil.sand.name").contains("does not fit"));
    assert!(sweep("soil").contains("no parameter"));
    assert!(sweep("plate.x.delta_deg").contains("no parameter"));
    assert!(message("[[sweep]]\nparameter = \"surcharge_kpa\"").contains("either values"));
    let many = "[[sweep]]\nparameter = \"surcharge_kpa\"\nfrom = 0\nto = 1\ncount = 1001";
    assert!(matches!(cases(many), Err(DescriptionError::TooMuch { count: 1001, .. })));
    let twice = "[[case]]\nname = \"a\"\n[[case]]\nname = \"a\"";
    assert!(message(twice).contains("same name"));
}

/// A strip on weightless clay bears `(2 + pi) c_u`; the partial factors of combination 2 leave `(2 + pi) c_u / 1.4`, and what it
/// may carry is that over 1.3.
#[test]
fn a_strip_on_clay_bears_what_the_formula_says_after_its_factors() {
    let text = r#"
        default_boundary = "free"
        objective = { kind = "load" }
        soil = [{ name = "clay", phi_deg = 0, cohesion_kpa = 70, unit_weight_kn_m3 = 0 }]
        region = [{ soil = "clay", polygon = [[-5, 0], [5, 0], [5, -4], [-5, -4]] }]
        boundary = [
            { kind = "fixed", sides = ["left", "right", "bottom"] },
            { kind = "load", line = [[-1, 0], [1, 0]], pressure_kpa = 100, live = true, action = "variable" },
        ]
        case = [{ name = "DA1-2", approach = "da1-2" }]
    "#;
    let case = Description::from_toml(text).unwrap().cases().unwrap().remove(0);
    let described = case.description.described().unwrap();
    let options = Options { max_gap: 0.02, ..Options::default() };
    let bounds = bound(&described.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    let exact = (2.0 + PI) * (70.0 / 1.4) / (1.3 * 100.0);
    assert!(bounds.lower.value <= exact && exact <= bounds.upper.value);
    assert!(bounds.gap() < 0.05);
}
