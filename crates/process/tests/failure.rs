//! Failure forces of strokes whose limit force is known.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

mod common;

use common::{DEPTH_M, LIMIT_N, Random, heaped, laws, stroke};
use soilctl_process::{
    Channels, FailureSettings, ForceNoise, Indiscernible, Kind, Method, Outcome, Trace, failure_force,
};

fn settings() -> FailureSettings {
    FailureSettings::for_depth(DEPTH_M).unwrap()
}

#[test]
fn gradual_failures_are_found_where_two_lines_are_biased() {
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    for (name, law) in laws() {
        for (growth, lambda) in [(0.0, 0.02), (0.0, 0.05), (0.4, 0.02), (0.4, 0.05)] {
            let mobilised = |u: f64| law(u / (lambda * DEPTH_M));
            let heap = heaped(mobilised);
            let force = |u: f64| LIMIT_N * (mobilised(u) + growth * heap(u) / DEPTH_M);
            let found = failure_force(&stroke(force, 0.020, 8.0, 0.05, 7), &settings());
            let Outcome::Found(point) = found.outcome else {
                panic!("{name}, growth {growth}, length {lambda}: {:?}", found.outcome)
            };
            let error = point.force_n / LIMIT_N - 1.0;
            let lines = found.two_lines.unwrap().force_n / LIMIT_N - 1.0;
            assert_eq!(point.method, Method::Saturation);
            assert!(
                (error * LIMIT_N).abs() < 3.0 * point.sd_n,
                "{name}, growth {growth}, length {lambda}: {error}"
            );
            ours.push(error.abs());
            theirs.push(lines.abs());
        }
    }
    ours.sort_by(f64::total_cmp);
    theirs.sort_by(f64::total_cmp);
    let at = |values: &[f64], share: f64| values[(share * (values.len() - 1) as f64) as usize];
    println!(
        "median {} 90 % {} worst {}; two lines {} {} {}",
        at(&ours, 0.5),
        at(&ours, 0.9),
        at(&ours, 1.0),
        at(&theirs, 0.5),
        at(&theirs, 0.9),
        at(&theirs, 1.0)
    );
    // A limit force that grows and one that is slow to be mobilised look alike; the worst cases are those.
    assert!(at(&ours, 0.5) < 0.03 && at(&ours, 0.9) < 0.08);
    assert!(at(&ours, 0.9) < 0.7 * at(&theirs, 0.9) && at(&ours, 1.0) < 0.6 * at(&theirs, 1.0));
}

#[test]
fn a_peak_is_a_drastic_failure_at_its_height() {
    for rest in [0.5, 0.7, 0.85] {
        for noise in [0.0, 0.02, 0.1] {
            let force = |u: f64| {
                let x = u / (0.04 * DEPTH_M);
                if x < 1.0 {
                    LIMIT_N * (2.0 * x - x * x)
                } else {
                    LIMIT_N * (rest + (1.0 - rest) * (-(x - 1.0) * 1.5).exp())
                }
            };
            let found = failure_force(&stroke(force, 0.016, 6.0, noise, 3), &settings());
            let Outcome::Found(point) = found.outcome else { panic!("{:?}", found.outcome) };
            assert_eq!(point.method.kind(), Kind::Drastic);
            assert!((point.force_n / LIMIT_N - 1.0).abs() < 0.02);
        }
    }
}

/// Before the plate pushes, an insertion's load fades and the arm goes through its free play.
#[test]
fn what_comes_before_the_push_is_no_part_of_the_curve() {
    let pushed = stroke(|u| LIMIT_N * (u / (0.1 * DEPTH_M)).tanh(), 0.02, 8.0, 0.02, 5);
    let (mut t, mut u, mut f) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..2000 {
        let share = f64::from(k) / 2000.0;
        t.push(f64::from(k) / 500.0);
        u.push(0.8 * DEPTH_M * share);
        f.push(0.3 * LIMIT_N * (-12.0 * share).exp() + 0.02 * f64::from(k % 3 - 1));
    }
    t.extend(pushed.t_s().iter().map(|time| time + 4.0));
    u.extend(pushed.displacement_m().iter().map(|way| way + 0.8 * DEPTH_M));
    f.extend(pushed.force_n());
    let found = failure_force(&Trace::new(t, u, f, Channels::default()).unwrap(), &settings());
    let Outcome::Found(point) = found.outcome else { panic!("{:?}", found.outcome) };
    assert!((point.force_n / LIMIT_N - 1.0).abs() < 0.03, "{}", point.force_n);
    assert!(point.displacement_m < 0.4 * DEPTH_M, "{}", point.displacement_m);
}

/// Soil that was let go follows another curve until the plate is where it was: that is no part of the loading.
#[test]
fn a_plate_that_is_let_go_and_pushed_again_has_the_same_failure_force() {
    let pushed = stroke(|u| LIMIT_N * (u / (0.05 * DEPTH_M)).tanh(), 0.016, 8.0, 0.05, 9);
    let (let_go_m, half) = (0.06 * DEPTH_M, pushed.t_s().len() / 2);
    let (mut t, mut u, mut f) = (Vec::new(), Vec::new(), Vec::new());
    let samples = pushed.t_s().iter().zip(pushed.displacement_m()).zip(pushed.force_n());
    for (k, ((time, way), force)) in samples.enumerate() {
        t.push(time + if k < half { 0.0 } else { 2.0 });
        u.push(*way);
        f.push(*force);
        if k + 1 == half {
            for step in 0..1000 {
                // There and back in two seconds; the force goes down by two fifths and comes back.
                let back = 1.0 - (f64::from(step) / 500.0 - 1.0).abs();
                t.push(time + f64::from(step + 1) / 500.0);
                u.push(way - let_go_m * back);
                f.push(force * (1.0 - 0.4 * back) + 0.05 * f64::from(step % 3 - 1));
            }
        }
    }
    let force = |trace: &Trace| match failure_force(trace, &settings()).outcome {
        Outcome::Found(point) => point.force_n,
        other => panic!("{other:?}"),
    };
    let (plain, again) = (force(&pushed), force(&Trace::new(t, u, f, Channels::default()).unwrap()));
    assert!((again / plain - 1.0).abs() < 0.02, "{plain} and {again}");
}

#[test]
fn a_straight_line_has_no_break() {
    let found = failure_force(&stroke(|u| 2000.0 * u, 0.01, 6.0, 0.02, 3), &settings());
    assert!(matches!(
        found.outcome,
        Outcome::Indiscernible(Indiscernible::NoBreak { .. } | Indiscernible::Incomplete { .. })
    ));
}

/// A straight rise to the limit in 5 s, and a fall by two fifths in the next 2 s, the plate moving on at a share of its speed.
fn rise_and_fall(speed_after: f64) -> Trace {
    let mut random = Random(11);
    let (mut t, mut u, mut f) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..3500 {
        let time = f64::from(k) / 500.0;
        let (before, after) = (time.min(5.0), (time - 5.0).max(0.0));
        t.push(time);
        u.push(0.02 * (before + speed_after * after) / 5.0);
        f.push(LIMIT_N * (before / 5.0) * (0.6 + 0.4 * (-after / 0.4).exp()) + 0.02 * random.normal());
    }
    Trace::new(t, u, f, Channels::default()).unwrap()
}

#[test]
fn a_force_that_falls_while_the_plate_rests_is_no_failure() {
    let at_rest = failure_force(&rise_and_fall(0.0), &settings());
    assert!(matches!(at_rest.outcome, Outcome::Indiscernible(_)), "{:?}", at_rest.outcome);
    let Outcome::Found(point) = failure_force(&rise_and_fall(1.0), &settings()).outcome else {
        panic!("it fails while it moves")
    };
    assert_eq!(point.method, Method::Drop);
    assert!((point.force_n / LIMIT_N - 1.0).abs() < 0.02);
}

/// At 50 samples a second and a tenth of the force as noise no single sample tells a fall by two fifths.
#[test]
fn a_fall_that_noise_hides_in_single_samples_is_found() {
    let noise_n = 0.1 * LIMIT_N;
    let noise = Some(ForceNoise { sd_n: noise_n, interval_s: 0.02, corner_hz: None });
    let mut misses = Vec::new();
    for seed in 0..20 {
        let mut random = Random(seed);
        let t: Vec<f64> = (0..400).map(|k| f64::from(k) * 0.02).collect();
        let u: Vec<f64> = t.iter().map(|t| 0.005 * t).collect();
        let force = |t: f64| LIMIT_N * if t < 4.0 { (t / 4.0).powf(0.6) } else { 0.6 };
        let f = t.iter().map(|t| force(*t) + noise_n * random.normal()).collect();
        let trace = Trace::new(t, u, f, Channels::default()).unwrap();
        // How uncertain it is, is another question.
        let settings = FailureSettings { noise, most_sd_rel: 1.0, ..settings() };
        let outcome = failure_force(&trace, &settings).outcome;
        let Outcome::Found(point) = outcome else { panic!("seed {seed}: {outcome:?}") };
        assert_eq!(point.method, Method::Drop, "seed {seed}");
        misses.push((point.force_n - LIMIT_N).abs() / noise_n);
    }
    misses.sort_by(f64::total_cmp);
    // Twice the noise of a sample, but for one in twenty.
    assert!(misses[10] < 1.0 && misses[18] < 2.0, "{misses:?}");
}

/// The formula for the mean of noise behind a filter against the sum of its covariances.
#[test]
fn slow_noise_averages_out_less() {
    let white = ForceNoise { sd_n: 2.0, interval_s: 0.001, corner_hz: None };
    assert!((white.of_mean(0.1) - 0.2).abs() < 1e-12);
    assert_eq!(white.of_mean(0.0), 2.0);
    for corner_hz in [2.0, 20.0] {
        let slow = ForceNoise { corner_hz: Some(corner_hz), ..white };
        let samples = 100;
        let share = (-std::f64::consts::TAU * corner_hz * white.interval_s).exp();
        let pairs = (0..samples).flat_map(|i: i32| (0..samples).map(move |j| share.powi((i - j).abs())));
        let expected = 2.0 * (pairs.sum::<f64>()).sqrt() / f64::from(samples);
        assert!((slow.of_mean(0.1) / expected - 1.0).abs() < 0.02, "{} {expected}", slow.of_mean(0.1));
    }
}
