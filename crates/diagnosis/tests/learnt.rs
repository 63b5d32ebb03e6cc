//! Effects that a simulated arm shows in signals which no formula of the catalogue has: here an arm that takes free-air readings off its
//! forces, so that what is wrong with its zero is in these readings and in no force.

#![allow(clippy::unwrap_used)]

use soilctl_diagnosis::self_test::{Case, Design, HiddenCampaign, Kind, SelfTest};
use soilctl_diagnosis::{Data, Diagnosis, FoundEffect, Learnt, Shown, Status, Surface, diagnose, fitted};
use soilctl_earth_pressure::model;
use soilctl_effects::EffectId;
use soilctl_strokes::StrokeRow;

/// Scatter of a free-air reading in N: a mean over half a second.
const AIR_SD_N: f64 = 0.01;

/// Numbers from -1 to 1 that look random.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

fn campaign(number: u64) -> HiddenCampaign {
    let test = SelfTest::new("chen", 77).unwrap();
    let design = Design { strokes: 24, traces: false, ..Design::default() };
    test.campaign(&Case { kind: Kind::Null, number, causes: Vec::new(), design }).unwrap().unwrap()
}

/// The campaign as an arm reads it whose zero is off, at the beginning and as it is at the end; the tool's weight goes with its angle.
fn read(campaign: &HiddenCampaign, bias_n: f64, drift_n: f64, seed: u64) -> Data {
    let mut chance = Chance(seed);
    let last = campaign.rows.len() as f64 - 1.0;
    let row = |(i, row): (usize, &StrokeRow)| {
        let weight = 0.6 * row.alpha_deg.to_radians().sin();
        let off = bias_n + drift_n * i as f64 / last;
        StrokeRow {
            air_across_n: Some(1.1 + weight + off + AIR_SD_N * 1.7 * chance.next()),
            time_s: Some(100.0 * i as f64),
            ..row.clone()
        }
    };
    let rows = campaign.rows.iter().enumerate().map(row).collect();
    let mut data = Data::new("read", rows, campaign.campaign.clone()).unwrap();
    data.tare_taken_off();
    data
}

/// Single strokes of the simulated arm, one of each tool angle.
fn single(campaign: &HiddenCampaign, bias_n: f64) -> Data {
    let mut data = read(campaign, bias_n, 0.0, 5);
    data.compare_everything();
    data
}

fn diagnosed(campaign: &HiddenCampaign, bias_n: f64, drift_n: f64) -> Diagnosis {
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let mut data = read(campaign, bias_n, drift_n, 1);
    data.expect(&read(campaign, 0.0, 0.0, 2), false, 0.0);
    let plain = single(campaign, 0.0);
    let with: Vec<(f64, Data)> = [0.2, 0.5, -0.2, -0.5]
        .into_iter()
        .map(|amplitude| (amplitude, single(campaign, amplitude)))
        .collect();
    let shown: Vec<Shown<'_>> =
        with.iter().map(|(amplitude, with)| Shown { amplitude: *amplitude, with }).collect();
    for id in [EffectId::ForceBias, EffectId::ForceDrift] {
        let learnt = Learnt::new(id.effect(), &data, &plain, &shown);
        data.learn(id, learnt);
    }
    diagnose(&data, &surface).unwrap()
}

#[test]
fn a_zero_that_is_off_is_named_by_free_air_and_by_no_force() {
    for (bias_n, drift_n, id) in [(-0.3, 0.0, EffectId::ForceBias), (0.0, 0.5, EffectId::ForceDrift)] {
        let found = diagnosed(&campaign(1), bias_n, drift_n);
        assert_eq!(found.status, Status::Named, "{id}: {:?}", found.equivalence_set);
        assert_eq!((found.effects.len(), found.effects[0].id), (1, id));
        let truth = bias_n + drift_n;
        assert!((found.effects[0].amplitude / truth - 1.0).abs() < 0.15, "{:?}", found.effects[0]);
        // No force has it, and none is predicted to.
        let gap = &found.comparison.gap;
        assert!((gap.after / gap.before - 1.0).abs() < 1e-3, "{gap:?}");
    }
}

#[test]
fn an_arm_that_reads_what_is_expected_has_no_effect() {
    for number in 1..3 {
        let found = diagnosed(&campaign(number), 0.0, 0.0);
        assert_eq!(found.status, Status::None, "{number}: {:?}", found.equivalence_set);
    }
}

/// Of an arm whose hose pulls, across the plate and along it. How much it pulls nobody measured.
fn pulled(campaign: &HiddenCampaign, bias_n: f64, pull: f64, seed: u64) -> Data {
    let mut chance = Chance(seed);
    let rows = read(campaign, bias_n + 0.25 * pull, 0.0, seed).rows.into_iter();
    let rows = rows
        .map(|row| StrokeRow { air_along_n: Some(0.3 - 0.4 * pull + AIR_SD_N * 1.7 * chance.next()), ..row });
    let mut data = Data::new("pulled", rows.collect(), campaign.campaign.clone()).unwrap();
    data.tare_taken_off();
    data
}

/// A hose that pulls more than in the simulated arm, and a zero that is off, read the same across the plate; with what the
/// hose does along it they are told apart.
#[test]
fn what_the_twin_may_be_off_by_is_shared_by_all_columns() {
    let campaign = campaign(1);
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let single = |bias_n: f64, pull: f64| {
        let mut data = pulled(&campaign, bias_n, pull, 5);
        data.compare_everything();
        data
    };
    let plain = single(0.0, 0.0);
    let (weak, strong) = (single(0.25, 0.0), single(-0.25, 0.0));
    let biased = [Shown { amplitude: 0.25, with: &weak }, Shown { amplitude: -0.25, with: &strong }];
    let (up, down) = (single(0.0, 1.0), single(0.0, -1.0));
    let said = |bias_n: f64, pull: f64, doubted: bool| {
        let mut data = pulled(&campaign, bias_n, pull, 1);
        data.expect(&pulled(&campaign, 0.0, 0.0, 2), false, 0.0);
        let id = EffectId::ForceBias;
        data.learn(id, Learnt::new(id.effect(), &data, &plain, &biased));
        if doubted {
            data.doubt(Learnt::of_setting(&data, &plain, &up, &down));
        }
        let found = diagnose(&data, &surface).unwrap();
        (found.status, found.effects.first().map(|effect| (effect.id, effect.amplitude)))
    };
    assert_eq!(said(0.0, 0.8, false).0, Status::Named, "without doubt the hose is a bias");
    assert_eq!(said(0.0, 0.8, true), (Status::None, None));
    let (status, first) = said(0.25, 0.0, true);
    let (id, amplitude) = first.unwrap();
    assert_eq!((status, id), (Status::Named, EffectId::ForceBias));
    assert!((amplitude / 0.25 - 1.0).abs() < 0.2, "{amplitude}");
}

/// Single strokes that show three quarters of what a bias does: beside an arm without it strokes ask for 4/3 of its size, and beside an arm with that for a quarter of
/// the difference of the other sign. Each arm is nearer by that factor.
#[test]
fn sizes_are_told_beside_an_arm_that_has_them_though_responses_are_wrong() {
    let (campaign, truth_n, id) = (campaign(1), -0.3, EffectId::ForceBias);
    let surface = Surface::new(model("chen").unwrap(), (70.0, 100.0)).unwrap();
    let plain = single(&campaign, 0.0);
    let with = [-0.2, -0.5].map(|amplitude| (amplitude, single(&campaign, 0.75 * amplitude)));
    let shown = [0, 1].map(|i| Shown { amplitude: with[i].0, with: &with[i].1 });
    let beside = |bias_n: Option<f64>| {
        let mut data = read(&campaign, truth_n, 0.0, 1);
        data.expect(&read(&campaign, 0.0, 0.0, 2), false, 0.0);
        data.learn(id, Learnt::new(id.effect(), &data, &plain, &shown));
        data.decide(&[id], &[]);
        if let Some(bias_n) = bias_n {
            let found = fitted(&data, &surface, &[]).unwrap().effects;
            data.expect(&read(&campaign, bias_n, 0.0, 3), false, 0.0);
            assert!(data.count_from(&[FoundEffect { amplitude: bias_n, ..found[0].clone() }]));
        }
        // The first three quarters of the strokes tell it as all of them do.
        let told = [vec![], (0..24).map(|i| i < 18).collect()]
            .map(|strokes| fitted(&data, &surface, &strokes).unwrap().effects[0].amplitude);
        assert!((told[0] / told[1] - 1.0).abs() < 0.05 && told[0] != told[1], "{told:?}");
        told[0]
    };
    let first = beside(None);
    let second = beside(Some(first));
    let third = beside(Some(second));
    for (told, off) in [(first, 1.0 / 3.0), (second, -1.0 / 9.0), (third, 1.0 / 27.0)] {
        assert!((told / truth_n - 1.0 - off).abs() < 0.05, "{told} {off}");
    }
    let mut data = read(&campaign, truth_n, 0.0, 1);
    assert!(!data.count_from(&[]));
}
