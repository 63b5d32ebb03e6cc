//! Model files: what is written reads back, what is wrong is refused, what is taken out is gone.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use soilctl_effects::{
    Covariate, EffectEntry, EffectId, EmpiricalTerm, FILE_SCHEMA, Loaded, ModelFile, ParameterValue,
    Reference, SoilEntry,
};
use soilctl_strokes::StrokeRow;

fn value(value: f64, unit: &str) -> ParameterValue {
    ParameterValue { value, sd: 0.1, unit: unit.into() }
}

fn file() -> ModelFile {
    let rows =
        [StrokeRow { alpha_deg: 80.0, depth_m: 0.02, width_m: 0.127, force_n: 5.0, ..StrokeRow::default() }];
    ModelFile {
        schema: FILE_SCHEMA.into(),
        model: "chen".into(),
        status: "named".into(),
        soil: SoilEntry {
            phi_deg: value(38.0, "deg"),
            delta_deg: value(23.0, "deg"),
            delta_offset_deg: value(0.5, "deg"),
            density_kg_m3: value(1500.0, "kg/m3"),
            gravity_m_s2: 9.806_65,
        },
        effects: vec![EffectEntry {
            id: EffectId::DepthOffset,
            parameters: BTreeMap::from([("offset_m".into(), value(0.002, "m"))]),
            shape: 0.0,
            log_bayes_factor: 9.0,
        }],
        empirical: Vec::new(),
        equivalence_set: vec!["depth_offset".into()],
        reference: Reference::of(&rows).unwrap(),
        data_hash: String::new(),
        held_out: None,
    }
}

#[test]
fn what_is_written_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("patch.json");
    file().write(&path).unwrap();
    assert_eq!(ModelFile::read(&path).unwrap(), file());
}

/// A term changes the force of a stroke by its factor and nothing else, and none leaves every bit as it is.
#[test]
fn an_empirical_term_is_a_factor_and_its_file_reads_back() {
    let row =
        StrokeRow { alpha_deg: 80.0, depth_m: 0.02, width_m: 0.127, force_n: 5.0, ..StrokeRow::default() };
    let term = |ln_force: [f64; 2]| EmpiricalTerm {
        over: vec![Covariate::ToolAngle],
        at: vec![vec![70.0, 90.0]],
        ln_force: ln_force.to_vec(),
        sd: vec![0.01; 2],
        log_bayes_factor: 7.0,
    };
    let with = ModelFile { empirical: vec![term([0.1, 0.3])], ..file() };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("patch.json");
    with.write(&path).unwrap();
    assert_eq!(ModelFile::read(&path).unwrap(), with);
    assert!(!serde_json::to_string(&file()).unwrap().contains("empirical"));
    let force = |file: ModelFile| Loaded::new(file, "patch").unwrap().force_n(&row).unwrap();
    assert!((force(with.clone()) / force(file()) - 0.2_f64.exp()).abs() < 1e-12);
    let plain = Loaded::new(with, "patch").unwrap().plain_force_n(&row).unwrap();
    assert_eq!(plain.to_bits(), Loaded::new(file(), "patch").unwrap().plain_force_n(&row).unwrap().to_bits());
    ModelFile { empirical: vec![term([0.0, 9.0])], ..file() }.write(&path).unwrap();
    assert!(ModelFile::read(&path).unwrap_err().to_string().contains("from -3 to 3"));
}

#[test]
fn taking_the_effect_out_restores_the_plain_model() {
    let row =
        StrokeRow { alpha_deg: 80.0, depth_m: 0.02, width_m: 0.127, force_n: 5.0, ..StrokeRow::default() };
    let with = Loaded::new(file(), "patch").unwrap();
    let without = Loaded::new(ModelFile { effects: Vec::new(), ..file() }, "patch").unwrap();
    let ratio = with.force_n(&row).unwrap() / without.force_n(&row).unwrap();
    assert!((ratio - 1.1_f64.powi(2)).abs() < 1e-12);
    assert_eq!(with.plain_force_n(&row).unwrap().to_bits(), without.force_n(&row).unwrap().to_bits());
    assert_eq!(with.delta_deg(&StrokeRow { delta_set_deg: Some(20.0), ..row.clone() }), 20.5);
    assert_eq!(with.delta_deg(&row), 23.0);
}

#[test]
fn what_is_wrong_is_refused_by_name() {
    let text = |change: &dyn Fn(&mut ModelFile)| {
        let mut file = file();
        change(&mut file);
        serde_json::to_string(&file).unwrap()
    };
    let cases: [(String, &str); 6] = [
        (text(&|f| f.schema = "soilctl.model-file/9".into()), "soilctl.model-file/1"),
        (text(&|f| f.soil.phi_deg.value = 95.0), "soil.phi_deg is 95"),
        (
            text(&|_| ()).replace("\"id\":\"depth_offset\"", "\"id\":\"gremlins\""),
            "no effect called \"gremlins\"",
        ),
        (text(&|f| f.effects[0].parameters.clear()), "offset_m"),
        (
            text(&|f| {
                let parameters = BTreeMap::from([("deficit".into(), value(0.1, "1"))]);
                f.effects[0] = EffectEntry {
                    id: EffectId::ProgressiveFailure,
                    parameters,
                    shape: 0.5,
                    ..f.effects[0].clone()
                };
            }),
            "the shape of effect progressive_failure is 0.5; it must be from 85 to 95",
        ),
        ("{}".into(), "missing field"),
    ];
    for (text, expected) in cases {
        let message = ModelFile::parse(&text, "patch.json").unwrap_err().to_string();
        assert!(message.starts_with("patch.json: ") && message.contains(expected), "{message}");
    }
}
