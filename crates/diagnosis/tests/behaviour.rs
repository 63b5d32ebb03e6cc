//! What the diagnosis says of campaigns whose effect is known, and of tables that lack things.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;

use soilctl_diagnosis::self_test::{Case, Cause, Design, HiddenCampaign, Kind, Outside, SelfTest};
use soilctl_diagnosis::{
    Data, Dependence, Diagnosis, Explanation, Readings, Status, Surface, Testable, diagnose, fitted,
    log_evidence,
};
use soilctl_earth_pressure::model;
use soilctl_effects::{Channel, Covariate, EffectId, Loaded};
use soilctl_strokes::StrokeRow;

const SEED: u64 = 31;

fn campaign(effects: &[EffectId], number: u64, design: Design) -> HiddenCampaign {
    let test = SelfTest::new("chen", SEED).unwrap();
    let case =
        Case { kind: Kind::Single, number, causes: effects.iter().map(|id| (*id).into()).collect(), design };
    test.campaign(&case).unwrap().unwrap()
}

fn diagnosed(hidden: &HiddenCampaign, rows: Vec<StrokeRow>) -> Diagnosis {
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    diagnose(&Data::new("test", rows, hidden.campaign.clone()).unwrap(), &surface).unwrap()
}

#[test]
fn a_strong_effect_is_named_and_closes_the_gap() {
    let hidden = campaign(&[EffectId::ForceBias], 3, Design::default());
    let found = diagnosed(&hidden, hidden.rows.clone());
    assert_eq!(found.status, Status::Named);
    assert_eq!(found.effects[0].id, EffectId::ForceBias);
    let truth = hidden.hidden[0].size;
    assert!((found.effects[0].amplitude - truth).abs() < 4.0 * found.effects[0].amplitude_sd);
    let gap = &found.comparison.gap;
    assert!(gap.after < gap.before && gap.delta_elpd.unwrap() > 4.0);
    assert_eq!(found.equivalence_set[0], Explanation::Effect(EffectId::ForceBias));
}

/// What a simulated arm decided is said, whatever the strokes alone would say: its set with the sizes that strokes tell, firmly or beside what is as
/// likely; or nothing.
#[test]
fn what_was_decided_is_said() {
    let hidden = campaign(&[EffectId::ForceBias], 3, Design::default());
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let decided = |best: &[EffectId], as_likely: &[EffectId]| {
        let mut data = Data::new("test", hidden.rows.clone(), hidden.campaign.clone()).unwrap();
        data.decide(best, as_likely);
        let found = diagnose(&data, &surface).unwrap();
        let ids: Vec<EffectId> = found.effects.iter().map(|found| found.id).collect();
        (found.status, ids, found.equivalence_set)
    };
    let names = |ids: &[EffectId]| ids.iter().map(|id| Explanation::Effect(*id)).collect::<Vec<_>>();
    let (bias, scale) = (EffectId::ForceBias, EffectId::ForceScale);
    assert_eq!(decided(&[bias], &[]), (Status::Named, vec![bias], names(&[bias])));
    assert_eq!(decided(&[bias], &[scale]), (Status::Ambiguous, vec![bias], names(&[bias, scale])));
    assert_eq!(decided(&[], &[]).0, Status::Unknown);
}

/// A size that is held is said as it is, and the soil makes up for it: of a bias that is larger than strokes ask for, the sand has to be weaker.
#[test]
fn the_soil_is_told_beside_a_size_that_is_held() {
    let hidden = campaign(&[EffectId::ForceBias], 3, Design::default());
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let told = diagnosed(&hidden, hidden.rows.clone());
    let (size, sd) = (told.effects[0].amplitude, 0.123);
    let held = |amplitude: f64| {
        let mut data = Data::new("test", hidden.rows.clone(), hidden.campaign.clone()).unwrap();
        data.hold(EffectId::ForceBias, amplitude, sd);
        assert_eq!(diagnose(&data, &surface).unwrap().effects[0].amplitude, size);
        data.decide(&[EffectId::ForceBias], &[]);
        data.hold(EffectId::ForceBias, amplitude, sd);
        let found = diagnose(&data, &surface).unwrap();
        assert_eq!((found.effects[0].amplitude, found.effects[0].amplitude_sd), (amplitude, sd));
        // Without weighing it is the same size, in a soil that leaves room for errors of the force model.
        let soil = found.model_file(&data, "chen", &[], String::new()).soil.phi_deg;
        let alone = fitted(&data, &surface, &[]).unwrap();
        assert!((alone.effects[0].amplitude / amplitude - 1.0).abs() < 1e-4);
        // Whatever is held, what is said of the effect is the same.
        assert_eq!(
            (found.status, found.effects[0].log_bayes_factor),
            (told.status, told.effects[0].log_bayes_factor)
        );
        let by_all = alone.model_file(&data, "chen", &[]).soil.phi_deg;
        assert!(
            by_all.sd > soil.sd && (by_all.value - soil.value).abs() < 2.0 * by_all.sd,
            "{by_all:?} {soil:?}"
        );
        soil.value
    };
    let phi_deg = [0.7, 1.0, 1.3].map(|part| held(part * size));
    let weaker = size.signum();
    assert!(phi_deg.windows(2).all(|pair| weaker * (pair[0] - pair[1]) > 0.05), "{size} {phi_deg:?}");
}

/// Readings are likelier beside what is expected of them with the effect that is there than without it.
#[test]
fn the_truth_has_more_evidence_than_nothing() {
    let hidden = campaign(&[EffectId::ForceDrift], 3, Design::default());
    let found = diagnosed(&hidden, hidden.rows.clone());
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let plain = Data::new("test", hidden.rows.clone(), hidden.campaign.clone()).unwrap();
    let mut known = plain.clone();
    let file = found.model_file(&plain, "chen", &[], String::new());
    known.know(&Loaded::new(file, "what was found").unwrap());
    let columns = BTreeSet::from([Channel::TareBefore, Channel::TareAfter]);
    let readings = Readings { columns, strokes: vec![true; plain.len()] };
    let of = |data: &Data| log_evidence(data, &surface, &readings).unwrap();
    let gain = of(&known) - of(&plain);
    assert!(gain > 5.0, "{gain}");
    // The last half of the strokes has most of the drift.
    let strokes = (0..plain.len()).map(|i| i < plain.len() / 2).collect();
    let early = Readings { strokes, ..readings.clone() };
    let of = |data: &Data| log_evidence(data, &surface, &early).unwrap();
    assert!(of(&known) - of(&plain) < 0.5 * gain);
}

/// A drift of the sensor is read in free air, too; what it does not change stays as it was.
#[test]
fn the_gap_shrinks_where_the_effect_is_seen_and_nowhere_else() {
    let hidden = campaign(&[EffectId::ForceDrift], 3, Design::default());
    let found = diagnosed(&hidden, hidden.rows.clone());
    assert_eq!((found.status, found.effects[0].id), (Status::Named, EffectId::ForceDrift));
    let parts = &found.comparison.parts;
    let whole = |channel: &str| parts.iter().find(|p| p.channel == channel && p.covariate.is_none()).unwrap();
    for channel in ["force_n", "tare_before_n", "tare_after_n"] {
        let part = whole(channel);
        assert!(part.before > 1.2 * part.after && part.delta_elpd > 2.0 * part.delta_elpd_se, "{part:?}");
    }
    let other = whole("heap_height_m");
    assert_eq!((other.before, other.delta_elpd), (other.after, 0.0));
    for part in parts.iter().filter(|part| part.covariate.is_none()) {
        assert!((0.6..1.5).contains(&part.after), "{part:?}");
        // Strokes of the parts along a condition are those of the whole, and so is their chi-square.
        let levels =
            parts.iter().filter(|p| p.channel == part.channel && p.covariate == Some(Covariate::Depth));
        let sum: f64 = levels.clone().map(|p| p.readings as f64 * p.after * p.after).sum();
        assert!((sum / (part.readings as f64 * part.after * part.after) - 1.0).abs() < 1e-12);
        assert_eq!(levels.map(|p| p.readings).sum::<usize>(), part.readings);
    }
}

/// Free play between motors and joints moves no force, so no fit of forces has it. Its column has a baseline that takes a part of it.
#[test]
fn the_gap_of_a_column_shrinks_by_an_effect_that_forces_do_not_show() {
    let hidden = campaign(&[EffectId::Backlash], 11, Design::default());
    let found = diagnosed(&hidden, hidden.rows.clone());
    assert_eq!((found.status, found.effects[0].id), (Status::Named, EffectId::Backlash));
    let parts = found.comparison.parts;
    let whole = |channel: &str| parts.iter().find(|p| p.channel == channel && p.covariate.is_none()).unwrap();
    let (gap, forces) = (whole("motor_ext_gap_m"), whole("force_n"));
    assert!(gap.before > gap.after && gap.delta_elpd > gap.delta_elpd_se, "{gap:?}");
    assert_eq!((forces.before, forces.delta_elpd), (forces.after, 0.0));
}

#[test]
fn the_same_campaign_gives_the_same_bits() {
    let hidden = campaign(&[EffectId::RateEffect], 5, Design { strokes: 24, ..Design::default() });
    let (a, b) = (diagnosed(&hidden, hidden.rows.clone()), diagnosed(&hidden, hidden.rows.clone()));
    assert_eq!(format!("{a:?}"), format!("{b:?}"));
}

#[test]
fn one_depth_cannot_show_what_depends_on_depth() {
    let design = Design { depths_m: vec![0.02], speeds_mps: vec![0.01], strokes: 24, ..Design::default() };
    let hidden = campaign(&[], 7, design);
    let found = diagnosed(&hidden, hidden.rows.clone());
    for id in [EffectId::RateEffect, EffectId::DensityGradient] {
        let expected = found.expected.iter().find(|of| of.id == id).unwrap();
        assert_eq!(expected.testable, Testable::NotVaried, "{id}");
    }
    let absorbed = found.expected.iter().find(|of| of.id == EffectId::ForceScale).unwrap();
    assert!(absorbed.lambda_largest < 30.0);
    assert_ne!(found.status, Status::Named);
}

/// Cohesion and heaped soil load a plate alike; only a ruler tells them apart.
#[test]
fn a_follow_up_asks_for_the_reading_that_settles_it() {
    let design = Design { widths_m: vec![0.127], speeds_mps: vec![0.01], traces: false, ..Design::default() };
    let hidden = campaign(&[EffectId::Cohesion], 15, design);
    let first = diagnosed(&hidden, hidden.rows.clone());
    assert_eq!(first.status, Status::Ambiguous);
    assert_eq!(first.equivalence_set, [EffectId::Cohesion, EffectId::SurchargeHeap].map(Explanation::Effect));
    let next = first.next.unwrap();
    assert_eq!(next.readings, [Channel::HeapHeight]);
    assert!(next.text.contains("heap_height_m") && next.power > 0.9, "{} {}", next.power, next.text);
    let rows = hidden.followed_by(&next.rows, 1).unwrap().unwrap();
    assert!(rows[..48].iter().all(|row| row.heap_height_m.is_none()));
    let settled = diagnosed(&hidden, rows);
    assert_eq!(settled.status, Status::Named, "{:?} {:?}", settled.equivalence_set, settled.alone);
    assert_eq!(settled.equivalence_set, [Explanation::Effect(EffectId::Cohesion)]);
}

#[test]
fn tables_with_little_in_them_are_answered_all_the_same() {
    let hidden = campaign(&[EffectId::Cohesion], 9, Design { traces: false, ..Design::default() });
    let bare = |row: &StrokeRow| StrokeRow {
        alpha_deg: row.alpha_deg,
        depth_m: row.depth_m,
        width_m: row.width_m,
        force_n: row.force_n,
        ..StrokeRow::default()
    };
    let found = diagnosed(&hidden, hidden.rows.iter().map(bare).collect());
    assert!(found.comparison.gap.heldout_after.is_none());
    assert!(
        found
            .expected
            .iter()
            .any(|of| of.id == EffectId::WallProximity && of.testable == Testable::NotVaried)
    );

    let summary: Vec<StrokeRow> = hidden
        .rows
        .iter()
        .take(4)
        .map(|row| StrokeRow { force_sd_n: Some(0.06 * row.force_n), ..bare(row) })
        .collect();
    assert_eq!(diagnosed(&hidden, summary).status, Status::NotTestable);
    let one = diagnosed(&hidden, vec![bare(&hidden.rows[0])]);
    assert!(one.effects.is_empty() && one.comparison.gap.before.is_finite());
}

#[test]
fn holes_and_clipped_columns_do_not_stop_it() {
    let hidden = campaign(&[EffectId::Backlash], 11, Design::default());
    let mut rows = hidden.rows.clone();
    for (i, row) in rows.iter_mut().enumerate() {
        if i % 3 == 0 {
            row.motor_ext_gap_m = None;
            row.wall_m = None;
        }
        // A channel that is stuck at its stop has no scatter at all.
        row.cmd_minus_force_n = Some(0.0);
        row.z_drift_m = row.z_drift_m.map(|z| z.min(0.0));
    }
    let found = diagnosed(&hidden, rows);
    assert_eq!(found.effects[0].id, EffectId::Backlash);
}

/// Instruments with few digits write the same thing again and again; at one depth a constant reading has two explanations.
#[test]
fn columns_that_never_change_are_no_obstacle() {
    let design = Design { depths_m: vec![0.02], ..Design::default() };
    let hidden = campaign(&[], 13, design);
    let still = |row: &StrokeRow| StrokeRow {
        displacement_at_failure_m: Some(0.01),
        post_slope_norm: Some(-0.3),
        residual_ratio: Some(0.8),
        heap_height_m: Some(0.0),
        tare_before_n: Some(0.0),
        tare_after_n: Some(0.0),
        ..row.clone()
    };
    let found = diagnosed(&hidden, hidden.rows.iter().map(still).collect());
    assert!(found.effects.is_empty(), "{:?}", found.effects);
    assert!(found.comparison.gap.before.is_finite());
}

#[test]
fn forces_alone_without_an_effect_ask_for_what_forces_can_show() {
    let test = SelfTest::new("chen", SEED).unwrap();
    let case = Case {
        kind: Kind::Null,
        number: 17,
        causes: Vec::new(),
        design: Design { traces: false, ..Design::default() },
    };
    let hidden = test.campaign(&case).unwrap().unwrap();
    let mut rows = hidden.rows.clone();
    let found = diagnosed(&hidden, rows.clone());
    assert_eq!(found.status, Status::None);
    let next = found.next.unwrap();
    let of = next.text.split("would show ").nth(1).unwrap().split(',').next().unwrap();
    assert!(of.parse::<EffectId>().unwrap().effect().acts_on_force() && next.power >= 0.2, "{}", next.text);
    // Made and appended, it is not mixed up with the follow-up after it.
    rows.extend(next.rows.iter().map(|row| StrokeRow { force_n: hidden.rows[0].force_n, ..row.clone() }));
    let names =
        |rows: &[StrokeRow]| -> BTreeSet<_> { rows.iter().filter_map(|row| row.batch.clone()).collect() };
    if let Some(after) = diagnosed(&hidden, rows.clone()).next {
        assert!(names(&after.rows).is_disjoint(&names(&rows)));
    }
}

/// What an unknown shape does to the forces is in the model file: it predicts them as they were fitted, and beside it the shape is not found again.
fn a_term_takes_its_place(hidden: &HiddenCampaign, found: &Diagnosis, over: Dependence) {
    let [term] = found.terms.as_slice() else { panic!("{:?}", found.terms) };
    assert_eq!(term.over, std::iter::once(over.on).chain(over.times).collect::<Vec<_>>());
    let plain = Data::new("test", hidden.rows.clone(), hidden.campaign.clone()).unwrap();
    let file = Loaded::new(found.model_file(&plain, "chen", &[], String::new()), "patch").unwrap();
    for (row, ln_force) in hidden.rows.iter().zip(&found.comparison.after) {
        let ratio = file.force_n(row).unwrap().ln() - ln_force;
        assert!(ratio.abs() < 5e-3 && file.terms_tell(row), "{over}: {ratio}");
    }
    let gap = &found.comparison.gap;
    assert!(gap.after < 0.9 * gap.before, "{over}: {gap:?}");
    let mut known = plain.clone();
    known.know(&file);
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let again = diagnose(&known, &surface).unwrap();
    assert!(again.comparison.gap.before < 0.9 * gap.before, "{over}: {:?}", again.comparison.gap);
    assert!(
        !again.equivalence_set.contains(&Explanation::Unknown(over)),
        "{over}: {:?}",
        again.equivalence_set
    );
    let carried = again.model_file(&known, "chen", &[], String::new());
    assert_eq!(carried.empirical[0], *term);
    assert!(again.comparison.without_effects(&carried, [0, 1]).empirical.len() == 1);
}

#[test]
fn what_is_outside_the_catalogue_is_unknown_and_followed_along_its_covariate() {
    let test = SelfTest::new("chen", SEED).unwrap();
    let mut unknown = 0;
    let hidden = &Outside::ALL[1..];
    for (number, outside) in hidden.iter().enumerate() {
        let (number, causes) = (number as u64, vec![Cause::Outside(*outside)]);
        let case = Case { kind: Kind::Outside, number, causes, design: Design::default() };
        let hidden = test.campaign(&case).unwrap().unwrap();
        let found = diagnosed(&hidden, hidden.rows.clone());
        assert_ne!(found.status, Status::Named, "{:?}", found.effects);
        if found.status == Status::Unknown {
            unknown += 1;
            let Explanation::Unknown(over) = found.equivalence_set[0] else { panic!("{:?}", found.effects) };
            let next = found.next.as_ref().unwrap();
            assert!(next.text.contains(&over.to_string()) && next.power > 0.2, "{}", next.text);
            a_term_takes_its_place(&hidden, &found, over);
        }
    }
    assert!(unknown >= 3, "{unknown}");
}

/// A sensor that was knocked between two strokes reads otherwise from then on: that is no steady drift of the preparations. And what the
/// first strokes of each preparation bear more is not what earlier strokes nearby have done.
#[test]
fn steps_and_first_strokes_are_no_steady_effects() {
    let test = SelfTest::new("chen", SEED).unwrap();
    for number in 0..6 {
        let case = Case { kind: Kind::Null, number, causes: Vec::new(), design: Design::default() };
        let hidden = test.campaign(&case).unwrap().unwrap();
        let mut knocked = hidden.rows.clone();
        let from = 15 + 3 * number as usize;
        knocked[from..].iter_mut().for_each(|row| row.force_n *= 1.25);
        let mut fresh = hidden.rows.clone();
        for row in &mut fresh {
            row.force_n *= if row.order.is_some_and(|order| order <= 2) { 1.25 } else { 1.0 };
        }
        for (what, rows) in [("knocked", knocked), ("fresh", fresh)] {
            let found = diagnosed(&hidden, rows);
            assert_ne!(found.status, Status::Named, "{what} {number}: {:?}", found.effects);
        }
    }
}

/// Denser soil below and end effects both raise the force over depth squared, and only a second width tells which it is.
#[test]
fn one_width_does_not_tell_a_density_gradient_from_end_effects() {
    for (id, number) in [(EffectId::DensityGradient, 3), (EffectId::SideEffects3d, 4)] {
        let one_width = Design { widths_m: vec![0.127], ..Design::default() };
        let hidden = campaign(&[id], number, one_width);
        let found = diagnosed(&hidden, hidden.rows.clone());
        assert_eq!(found.status, Status::Ambiguous, "{id}: {:?} {:?}", found.effects, found.alone);
        for twin in [EffectId::DensityGradient, EffectId::SideEffects3d].map(Explanation::Effect) {
            assert!(found.equivalence_set.contains(&twin), "{:?}", found.equivalence_set);
        }
        let next = found.next.unwrap();
        assert!(next.text.contains("narrower plate") && next.power > 0.8, "{}: {}", next.text, next.power);
        let two_widths = campaign(&[id], number, Design::default());
        let found = diagnosed(&two_widths, two_widths.rows.clone());
        assert_eq!((found.status, found.effects[0].id), (Status::Named, id));
    }
}
