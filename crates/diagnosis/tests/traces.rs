//! Effects that only traces show, in traces that are drawn here by formulas of their own.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;

use soilctl_diagnosis::self_test::{Case, Design, HiddenCampaign, Kind, SelfTest};
use soilctl_diagnosis::{
    Data, Diagnosis, Explanation, Phase, Status, Surface, courses, diagnose, typical_course,
};
use soilctl_earth_pressure::model;
use soilctl_effects::EffectId;
use soilctl_strokes::{StrokeRow, TraceSample, TraceTable};

/// What is wrong with the arm or the soil of drawn traces.
#[derive(Clone, Copy, Default)]
struct Hidden {
    /// Stretch that all encoders miss, m/N.
    beyond_m_per_n: f64,
    /// Stretch between the motors' and the external encoders, m/N.
    between_m_per_n: f64,
    play_m: f64,
    step_m: f64,
    /// Rise of the force angle after failure, deg.
    lift_deg: f64,
}

/// Numbers from -1 to 1 that look random.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A plate that rests for a second, is pulled until the soil fails and half its depth on. The force rises like a
/// hyperbola and stays.
fn trace(row: &StrokeRow, stiffness_n_per_m: f64, hidden: &Hidden, chance: &mut Chance) -> Vec<TraceSample> {
    let failure_m = row.depth_m * 0.18 * (1.0 + 0.15 * chance.next());
    let speed_mps = failure_m / 3.0;
    (0..800)
        .map(|i| {
            let t_s = 0.02 * f64::from(i);
            let u = speed_mps * (t_s - 1.0).max(0.0);
            let s = u / failure_m;
            let share = if s < 1.0 { 1.6 * s / (0.6 + s) } else { 1.0 - 0.05 * (s - 1.0) };
            let force_n = (row.force_n * share * (1.0 + 0.01 * chance.next())).max(0.0);
            let tip = u + hidden.beyond_m_per_n * force_n;
            let x_ext_m =
                if hidden.step_m > 0.0 { (tip / hidden.step_m).floor() * hidden.step_m } else { tip };
            let taken_up = hidden.play_m * (force_n / 0.5).min(1.0);
            let stretch = force_n / stiffness_n_per_m + hidden.between_m_per_n * force_n;
            TraceSample {
                t_s,
                x_ext_m,
                x_mtr_m: Some(tip + stretch + taken_up + 5e-5 * chance.next()),
                force_n,
                friction_angle_deg: Some(
                    row.delta_set_deg.unwrap_or(20.0)
                        + chance.next()
                        + if s > 1.0 { hidden.lift_deg } else { 0.0 },
                ),
                z_m: Some(-row.depth_m + 2e-4 * chance.next()),
            }
        })
        .collect()
}

fn campaign() -> HiddenCampaign {
    let test = SelfTest::new("chen", 77).unwrap();
    let design = Design { strokes: 24, traces: false, ..Design::default() };
    test.campaign(&Case { kind: Kind::Null, number: 1, causes: Vec::new(), design }).unwrap().unwrap()
}

fn traces(campaign: &HiddenCampaign, hidden: &Hidden, seed: u64) -> TraceTable {
    let mut chance = Chance(seed);
    let stiffness = 1.15 * campaign.campaign.instrument.joint_stiffness_n_per_m;
    let of = |row: &StrokeRow| (row.stroke_id.clone().unwrap(), trace(row, stiffness, hidden, &mut chance));
    TraceTable::new(campaign.rows.iter().map(of).collect::<BTreeMap<_, _>>())
}

fn data(campaign: &HiddenCampaign, hidden: &Hidden) -> Data {
    drawn(campaign, hidden, 9)
}

fn drawn(campaign: &HiddenCampaign, hidden: &Hidden, seed: u64) -> Data {
    let mut data = Data::new("drawn", campaign.rows.clone(), campaign.campaign.clone()).unwrap();
    assert_eq!(data.add_traces(&traces(campaign, hidden, seed), &[]), campaign.rows.len());
    data
}

fn diagnosed(data: &Data) -> Diagnosis {
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    diagnose(data, &surface).unwrap()
}

#[test]
fn columns_are_those_that_the_trace_was_drawn_with() {
    let campaign = campaign();
    let hidden = Hidden { play_m: 8e-4, step_m: 1e-3, ..Hidden::default() };
    let data = data(&campaign, &hidden);
    let stiffness = 1.15 * campaign.campaign.instrument.joint_stiffness_n_per_m;
    for (row, before) in data.rows.iter().zip(&campaign.rows) {
        assert!(before.motor_ext_gap_m.is_none());
        // Stretch at a little less than the failure force; an encoder in steps of 1 mm may be one behind.
        let gap = row.motor_ext_gap_m.unwrap() - 8e-4 - row.force_n / stiffness;
        assert!((-3e-4..=1.1e-3).contains(&gap), "{gap}");
        assert!((row.x_step_m.unwrap() - 1e-3).abs() < 1e-6, "{:?}", row.x_step_m);
        assert!((row.friction_angle_deg.unwrap() - row.delta_set_deg.unwrap()).abs() < 0.8);
        assert!(row.z_drift_m.unwrap().abs() < 4e-4);
        let way = row.displacement_at_failure_m.unwrap() / row.depth_m;
        assert!((0.06..0.25).contains(&way), "{way}");
    }
    let smooth = self::data(&campaign, &Hidden::default());
    for row in &smooth.rows {
        assert_eq!(row.x_step_m, None);
        // A twentieth of the force on each way to failure: 0.05 / 0.18 H.
        assert!((row.post_slope_norm.unwrap() + 0.28).abs() < 0.1, "{:?}", row.post_slope_norm);
        assert!((row.residual_ratio.unwrap() - 0.86).abs() < 0.05);
    }
}

#[test]
fn arm_effects_are_named_from_traces_alone() {
    let campaign = campaign();
    for (hidden, id, size) in [
        (Hidden { play_m: 8e-4, ..Hidden::default() }, EffectId::Backlash, 8e-4),
        (Hidden { step_m: 1.5e-3, ..Hidden::default() }, EffectId::EncoderQuantisation, 1.5e-3),
        (Hidden { between_m_per_n: 4e-4, ..Hidden::default() }, EffectId::CableFlex, 4e-4),
        (Hidden { beyond_m_per_n: 5e-4, ..Hidden::default() }, EffectId::CableFlex, 5e-4),
    ] {
        let found = diagnosed(&data(&campaign, &hidden));
        let ids: Vec<EffectId> = found.effects.iter().map(|effect| effect.id).collect();
        assert!(ids.contains(&id), "{id}: {:?} {ids:?}", found.status);
        let effect = found.effects.iter().find(|effect| effect.id == id).unwrap();
        assert!((effect.amplitude / size - 1.0).abs() < 0.35, "{id}: {}", effect.amplitude);
    }
}

#[test]
fn traces_without_an_effect_are_not_firmly_named() {
    let found = diagnosed(&data(&campaign(), &Hidden::default()));
    assert_ne!(found.status, Status::Named, "{:?}", found.effects);
}

#[test]
fn what_differs_from_a_simulated_arm_is_located_by_phase() {
    let campaign = campaign();
    let mut lifted = data(&campaign, &Hidden { lift_deg: 4.0, ..Hidden::default() });
    lifted.expect(&drawn(&campaign, &Hidden::default(), 10), false, 0.0);
    let found = diagnosed(&lifted);
    let of = |channel: &str, phase: Option<Phase>| {
        let mut places =
            found.located.iter().filter(|place| place.phase == phase && place.covariate == "all");
        places.find(|place| place.channel == channel).map(|place| place.p_adjusted)
    };
    assert!(of("slip_angle_deg", None).is_some_and(|p| p < 1e-6), "{:?}", found.located);
    assert_eq!(of("friction_angle_deg", Some(Phase::Loading)), None);
    // What turns the force only once the soil slips.
    let set = &found.equivalence_set;
    assert!(
        set.contains(&Explanation::Effect(EffectId::InterfaceFrictionOffset)),
        "{:?} {set:?}",
        found.status
    );
}

#[test]
fn courses_reach_failure_at_one() {
    let campaign = campaign();
    let found = courses(&campaign.rows, &traces(&campaign, &Hidden::default(), 9), &[]);
    let course = found[0].as_ref().unwrap();
    let at_failure = course.points.iter().find(|p| p.0 >= 1.0).unwrap();
    assert!((at_failure.1 - 1.0).abs() < 0.05);
    let typical = typical_course(&campaign.rows, &found, 0).unwrap();
    assert!((typical.way_m / campaign.rows[0].depth_m - 0.17).abs() < 0.03);
    // Strokes that the table does not know, and traces that do not reach the force.
    let mut rows = campaign.rows[..2].to_vec();
    rows[0].stroke_id = Some("other".into());
    rows[1].force_n *= 3.0;
    assert!(courses(&rows, &traces(&campaign, &Hidden::default(), 9), &[]).iter().all(Option::is_none));
}
