//! Depth law, interface friction and campaign statistics on made data.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

mod common;

use common::Random;
use soilctl_process::{
    CampaignStroke, DepthPoint, ProcessError, SweepStroke, campaign_statistics, depth_law,
    interface_friction, meant_angles_deg, rubbing_peak,
};

#[test]
fn angles_that_were_meant_to_be_the_same_are() {
    let meant = meant_angles_deg(&[80.0, 69.98, 90.3, 70.02, 70.0, 89.9]);
    assert_eq!(meant, [80.0, 70.0, 90.3, 70.0, 70.0, 90.3]);
    assert_eq!(meant_angles_deg(&[70.0, 70.4, 70.8]), [70.4, 70.4, 70.8]);
    assert!(meant_angles_deg(&[]).is_empty() && meant_angles_deg(&[f64::NAN])[0].is_nan());
}

#[test]
fn an_exact_power_is_recovered() {
    for power in [1.0, 2.0, 2.7] {
        let points: Vec<DepthPoint> = (5..=10)
            .map(|k| f64::from(k) * 2.54e-3)
            .map(|h| DepthPoint { depth_m: h, force_n: 4e3 * h.powf(power) })
            .collect();
        let law = depth_law(&points, 0.0).unwrap();
        assert!((law.exponent - power).abs() < 1e-9 && (law.coefficient_n / 4e3 - 1.0).abs() < 1e-8);
        assert_eq!(law.agrees_with_square, power == 2.0);
    }
}

#[test]
fn the_interval_of_the_power_holds_the_truth_as_often_as_it_says() {
    let mut random = Random(5);
    for depth_sd_m in [0.0, 0.5e-3] {
        let mut held = 0;
        for _ in 0..400 {
            let points: Vec<DepthPoint> = (0..18)
                .map(|k| {
                    let h = f64::from(5 + k % 6) * 2.54e-3;
                    let true_h = h + depth_sd_m * random.normal();
                    DepthPoint { depth_m: h, force_n: 9e3 * true_h.powi(2) * (0.04 * random.normal()).exp() }
                })
                .collect();
            let [low, high] = depth_law(&points, depth_sd_m).unwrap().exponent_95;
            held += i32::from(low <= 2.0 && 2.0 <= high);
        }
        // 95 % of 400, four standard errors (17) either way.
        assert!((363..=397).contains(&held), "{held}");
    }
}

#[test]
fn one_depth_is_not_enough() {
    let points = [DepthPoint { depth_m: 0.02, force_n: 3.0 }; 5];
    assert!(matches!(depth_law(&points, 0.0), Err(ProcessError::TooFew { .. })));
}

#[test]
fn lift_tells_the_interface_friction() {
    let mut random = Random(11);
    let (mut within, mut far) = (0, 0);
    for _ in 0..200 {
        let delta = 20.0 + 6.0 * random.uniform();
        let rate = 0.7 + 0.3 * random.uniform();
        // What all strokes share: the sensor does not lie quite as it should.
        let common_deg = 0.3 * random.normal();
        let strokes: Vec<SweepStroke> = (0..12)
            .map(|k| {
                let set_deg = 18.0 + f64::from(k / 2) * 2.0;
                let lift_deg = (rate * (delta - set_deg)).max(0.0) + common_deg + 0.25 * random.normal();
                SweepStroke {
                    alpha_deg: if k % 2 == 0 { 80.0 } else { 90.0 },
                    set_deg,
                    lift_deg,
                    lift_sd_deg: 0.25,
                }
            })
            .collect();
        let found = interface_friction(&strokes).unwrap();
        let error = (found.delta_deg - delta).abs();
        far += i32::from(error > 1.5);
        within += i32::from(error < found.sd_deg);
        assert!(found.above_deg.is_none_or(|above| above < delta + 1.0));
    }
    assert!(far <= 10 && (110..=165).contains(&within), "{far} {within}");
}

#[test]
fn other_tool_angles_are_left_out_of_the_sweep() {
    let stroke =
        |alpha_deg: f64, set_deg: f64| SweepStroke { alpha_deg, set_deg, lift_deg: 0.0, lift_sd_deg: 0.1 };
    let strokes =
        [stroke(70.0, 20.0), stroke(80.0, 20.0), stroke(90.0, 22.0), stroke(100.0, 24.0), stroke(85.0, 24.0)];
    assert_eq!(interface_friction(&strokes).unwrap().left_out, [0, 3]);
}

#[test]
fn peaks_of_rubbing_are_counted_while_it_presses() {
    let t: Vec<f64> = (0..5000).map(|i| f64::from(i) / 500.0).collect();
    let angle: Vec<f64> = t.iter().map(|t| 24.0 * (t * std::f64::consts::TAU).sin()).collect();
    let normal: Vec<f64> = t.iter().map(|t| if *t < 8.0 { 3.0 } else { 0.1 }).collect();
    let found = rubbing_peak(&t, &angle, &normal, 1.0).unwrap();
    assert!((found.peak_deg - 24.0).abs() < 0.01 && found.peaks == 16);
}

fn strokes(radius_effect: f64, seed: u64) -> Vec<CampaignStroke> {
    let mut random = Random(seed);
    (0..48)
        .map(|k| {
            let alpha_deg = 70.0 + 10.0 * f64::from(k % 4);
            let far = (k / 4) % 2 == 0;
            let depth_m = 0.0254 * alpha_deg.to_radians().sin() * (1.0 + 0.02 * random.normal());
            let force_n = 12_000.0
                * depth_m.powi(2)
                * (1.0 + if far { radius_effect } else { 0.0 })
                * (0.05 * random.normal()).exp();
            CampaignStroke {
                alpha_deg,
                depth_m,
                force_n,
                radius_m: Some(if far { 0.4318 } else { 0.3048 }),
                base_deg: Some(f64::from(k % 3) * 25.0 - 25.0),
            }
        })
        .collect()
}

#[test]
fn scaling_undoes_a_wrong_depth() {
    let found = campaign_statistics(&strokes(0.0, 2), 0.0254).unwrap();
    assert_eq!(found.groups.len(), 4);
    for group in &found.groups {
        let nominal = 12_000.0 * (0.0254 * group.alpha_deg.to_radians().sin()).powi(2);
        assert!((group.mean_n / nominal - 1.0).abs() < 0.06, "{group:?}");
        assert!((0.02..0.09).contains(&group.coefficient_of_variation().unwrap()));
    }
}

#[test]
fn a_wild_stroke_is_named_and_a_quiet_campaign_has_few() {
    let mut wild = strokes(0.0, 3);
    wild[17].force_n *= 1.6;
    let found = campaign_statistics(&wild, 0.0254).unwrap();
    assert!(found.groups.iter().any(|group| group.outliers.contains(&17)));
    // 5 % a group: of 400 groups about 20.
    let false_ones: usize = (0..100)
        .map(|seed| {
            campaign_statistics(&strokes(0.0, 100 + seed), 0.0254)
                .unwrap()
                .groups
                .iter()
                .filter(|g| !g.outliers.is_empty())
                .count()
        })
        .sum();
    assert!((5..=40).contains(&false_ones), "{false_ones}");
}

#[test]
fn an_effect_of_the_radius_is_significant_and_chance_is_not() {
    let found = campaign_statistics(&strokes(0.15, 4), 0.0254).unwrap().radius.unwrap();
    assert!(found.is_significant() && (found.effect_rel - 0.15).abs() < 3.0 * found.effect_se);
    let significant = (0..200)
        .filter(|seed| {
            campaign_statistics(&strokes(0.0, 500 + seed), 0.0254).unwrap().radius.unwrap().is_significant()
        })
        .count();
    assert!((1..=22).contains(&significant), "{significant}");
}
