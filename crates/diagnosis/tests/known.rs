//! Campaigns against a model file: what it says is held, and what it does not say is found.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use soilctl_diagnosis::self_test::{Case, Design, HiddenCampaign, Kind, SelfTest};
use soilctl_diagnosis::{Data, Diagnosis, Status, Surface, diagnose};
use soilctl_earth_pressure::model;
use soilctl_effects::{
    EffectEntry, EffectId, FILE_SCHEMA, Loaded, ModelFile, ParameterValue, Reference, SoilEntry,
};
use soilctl_strokes::StrokeRow;

fn campaign(effects: &[EffectId], number: u64) -> HiddenCampaign {
    let test = SelfTest::new("chen", 31).unwrap();
    let causes = effects.iter().map(|id| (*id).into()).collect();
    let case = Case { kind: Kind::Single, number, causes, design: Design::default() };
    test.campaign(&case).unwrap().unwrap()
}

/// A model file with effects by id and amplitude.
fn file(effects: &[(EffectId, f64)], reference: &Reference) -> Loaded {
    let value = |value: f64, unit: &str| ParameterValue { value, sd: 0.0, unit: unit.into() };
    let entry = |&(id, amplitude): &(EffectId, f64)| {
        let main = id.effect().parameter;
        EffectEntry {
            id,
            parameters: BTreeMap::from([(main.name.to_owned(), value(amplitude, main.unit))]),
            shape: 0.0,
            log_bayes_factor: 0.0,
        }
    };
    let soil = SoilEntry {
        phi_deg: value(38.0, "deg"),
        delta_deg: value(22.0, "deg"),
        delta_offset_deg: value(0.0, "deg"),
        density_kg_m3: value(1500.0, "kg/m3"),
        gravity_m_s2: 9.80665,
    };
    let file = ModelFile {
        schema: FILE_SCHEMA.into(),
        model: "chen".into(),
        status: "hand".into(),
        soil,
        effects: effects.iter().map(entry).collect(),
        empirical: Vec::new(),
        equivalence_set: Vec::new(),
        reference: reference.clone(),
        data_hash: String::new(),
        held_out: None,
    };
    Loaded::new(file, "test").unwrap()
}

fn diagnosed(hidden: &HiddenCampaign, rows: &[StrokeRow], known: Option<&Loaded>) -> Diagnosis {
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let mut data = Data::new("test", rows.to_vec(), hidden.campaign.clone()).unwrap();
    if let Some(known) = known {
        data.know(known);
    }
    diagnose(&data, &surface).unwrap()
}

#[test]
fn what_was_found_is_not_missing_any_more() {
    for id in
        [EffectId::ForceDrift, EffectId::InterfaceFrictionOffset, EffectId::RateEffect, EffectId::Backlash]
    {
        let hidden = campaign(&[id], 3);
        let first = diagnosed(&hidden, &hidden.rows, None);
        assert_eq!((first.status, first.effects[0].id), (Status::Named, id));
        let known = file(&[(id, first.effects[0].amplitude)], &Reference::of(&hidden.rows).unwrap());
        let second = diagnosed(&hidden, &hidden.rows, Some(&known));
        assert_eq!(second.status, Status::None, "{id}: {:?}", second.effects);
        assert!(
            second.expected.len() == EffectId::ALL.len() - 1 && second.expected.iter().all(|of| of.id != id)
        );
        // With it, before is what after was.
        for (a, b) in first.comparison.after.iter().zip(&second.comparison.before) {
            assert!((a - b).abs() < 1e-6, "{id}: {a} {b}");
        }
        assert_eq!(second.comparison.before, second.comparison.after);
    }
}

#[test]
fn a_second_effect_is_named_beside_the_known_one() {
    for (first, second) in [
        (EffectId::ForceDrift, EffectId::RateEffect),
        (EffectId::InterfaceFrictionOffset, EffectId::DensityGradient),
        (EffectId::RateEffect, EffectId::RadiusDependence),
        (EffectId::RadiusDependence, EffectId::ForceDrift),
    ] {
        let hidden = campaign(&[first, second], 40);
        let known = file(&[(first, hidden.hidden[0].size)], &Reference::of(&hidden.rows).unwrap());
        let found = diagnosed(&hidden, &hidden.rows, Some(&known));
        assert_eq!(found.status, Status::Named);
        let [only] = &found.effects[..] else { panic!("{:?}", found.effects) };
        assert_eq!(only.id, second);
        assert!((only.amplitude - hidden.hidden[1].size).abs() < 3.0 * only.amplitude_sd, "{only:?}");
    }
}

/// An offset of the interface friction with a weak gradient looks like cross-talk of the sensor, until the offset is known.
#[test]
fn what_is_known_is_not_mistaken_for_something_else() {
    let hidden = campaign(&[EffectId::InterfaceFrictionOffset, EffectId::DensityGradient], 43);
    let alone = diagnosed(&hidden, &hidden.rows, None);
    assert_eq!((alone.status, alone.effects[0].id), (Status::Named, EffectId::FtCrosstalk));
    let known = file(
        &[(EffectId::InterfaceFrictionOffset, hidden.hidden[0].size)],
        &Reference::of(&hidden.rows).unwrap(),
    );
    let found = diagnosed(&hidden, &hidden.rows, Some(&known));
    assert_eq!(found.status, Status::None, "{:?}", found.effects);
}

/// A gradient is relative to the mean depth of the campaign that it was found in, also where another one is diagnosed.
#[test]
fn parameters_refer_to_the_campaign_of_the_file() {
    let hidden = campaign(&[EffectId::DensityGradient], 6);
    let reference = Reference::of(&hidden.rows).unwrap();
    let known = file(&[(EffectId::DensityGradient, 15.0)], &reference);
    let deep: Vec<StrokeRow> =
        hidden.rows.iter().filter(|row| row.depth_m > reference.depth_m).cloned().collect();
    let found = diagnosed(&hidden, &deep, Some(&known));
    let soil = found.comparison.soil_before;
    let mut same = known.file().clone();
    same.soil.phi_deg.value = soil.phi_deg;
    same.soil.delta_offset_deg.value = soil.delta_offset_deg;
    same.soil.density_kg_m3.value = soil.density_kg_m3;
    let same = Loaded::new(same, "test").unwrap();
    for (row, ln) in deep.iter().zip(&found.comparison.before) {
        assert!((same.force_n(row).unwrap().ln() - ln).abs() < 5e-3);
        // Which the plain force is not.
        assert!((same.plain_force_n(row).unwrap().ln() - ln).abs() > 0.03);
    }
}

#[test]
fn a_file_without_effects_is_the_plain_model() {
    let hidden = campaign(&[EffectId::ForceBias], 3);
    let known = file(&[], &Reference::of(&hidden.rows[..5]).unwrap());
    let with = diagnosed(&hidden, &hidden.rows, Some(&known));
    assert_eq!(format!("{with:?}"), format!("{:?}", diagnosed(&hidden, &hidden.rows, None)));
}
