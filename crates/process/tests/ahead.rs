//! Whether a force rises beyond what the soil explains: how often it alarms by chance, what it measures, and which blocks go with it.
#![allow(clippy::unwrap_used, clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "tests")]

use std::sync::atomic::{AtomicUsize, Ordering};

use soilctl_process::ProcessError;
use soilctl_process::ahead::{Course, CourseSample, Expected, Ratio, Ratios, Test, region};

/// Each stroke in a preparation of its own.
fn prepared(course: Option<Course>) -> Course {
    static PREPARATIONS: AtomicUsize = AtomicUsize::new(0);
    course.unwrap().in_preparation(PREPARATIONS.fetch_add(1, Ordering::Relaxed))
}

/// A stroke whose force over the way in depths is `force(x)`, failing at 0.2 depths.
fn course(depth_m: f64, force: impl Fn(f64) -> f64) -> Course {
    let samples = (0..4000).map(|i| {
        let x = f64::from(i) / 2000.0;
        CourseSample { t_s: f64::from(i) * 0.002, way_m: x * depth_m, force_n: force(x), depth_m }
    });
    prepared(Course::from_samples(90.0, depth_m, Some(0.2 * depth_m), samples))
}

/// Uniform from 0 to 1, by a linear congruence (Numerical Recipes).
fn draws(seed: u32) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    }
}

fn normal(draw: &mut impl FnMut() -> f64) -> f64 {
    (0..12).map(|_| draw()).sum::<f64>() - 6.0
}

const TEST: Test = Test { false_alarms: 0.02, left_out: 0.05 };

/// A random course: level, slope and a random walk scatter, so that neighbouring looks hang together.
fn random(draw: &mut impl FnMut() -> f64) -> Course {
    let (level, slope) = (0.05 * normal(draw), 0.03 * normal(draw));
    let mut walk = 0.0;
    let steps: Vec<f64> = (0..21)
        .map(|_| {
            walk += 0.01 * normal(draw);
            walk
        })
        .collect();
    let depth_m = 0.03 * (1.0 + 0.1 * draw());
    course(depth_m, move |x| {
        let step = steps[(10.0 * x) as usize];
        1e4 * depth_m * depth_m * (level + (0.4 + slope) * x + step).exp()
    })
}

/// Over many campaigns of eight and of twenty references, no more alarms than asked for.
#[test]
fn false_alarms_are_as_stated() {
    let mut draw = draws(7);
    for references in [8, 20] {
        let (mut alarms, tries) = (0, 400);
        for _ in 0..tries {
            let known: Vec<Course> = (0..references).map(|_| random(&mut draw)).collect();
            let expected = Expected::of(&known.iter().collect::<Vec<_>>()).unwrap();
            let judged = match expected.judge(&random(&mut draw), &TEST) {
                Ok(judged) => judged,
                // As rare as a false alarm at one look.
                Err(ProcessError::Unlike { .. }) => continue,
                Err(other) => panic!("{other}"),
            };
            assert_eq!((judged.references, judged.planned), (references, 16));
            alarms += usize::from(judged.alarm.is_some());
        }
        // 2 % of 400 are 8; 18 and more come in fewer than 2 of 1000 such tests.
        assert!(alarms < 18, "{alarms} of {tries}");
    }
}

#[test]
fn a_rise_is_found_and_measured_at_any_depth() {
    let mut draw = draws(11);
    let known: Vec<Course> = (0..12).map(|_| random(&mut draw)).collect();
    let expected = Expected::of(&known.iter().collect::<Vec<_>>()).unwrap();
    let rise = |depth_m: f64, by: f64| {
        course(depth_m, move |x| 1e4 * depth_m * depth_m * (0.4 * x).exp() * (1.0 + by * (x - 1.0).max(0.0)))
    };
    for depth_m in [0.028, 0.034] {
        let judged = expected.judge(&rise(depth_m, 1.5), &TEST).unwrap();
        let alarm = judged.alarm.unwrap();
        assert!(!alarm.from_the_beginning);
        let look = judged.looks[alarm.look];
        assert!(look.way_m > depth_m && look.way_m < 1.45 * depth_m, "{look:?}");
        // In the middle of the cell, within the scatter of twelve.
        let true_ratio = 1.0 + 1.5 * (look.way_m / depth_m - 0.05 - 1.0);
        assert!((look.ratio / true_ratio).ln().abs() < look.factor.ln(), "{look:?} {true_ratio}");
        assert!(expected.judge(&rise(depth_m, 0.0), &TEST).unwrap().alarm.is_none());
    }
    // Twice the force from the beginning on.
    let twice = course(0.03, |x| 2e4 * 0.0009 * (0.4 * x).exp());
    assert!(expected.judge(&twice, &TEST).unwrap().alarm.unwrap().from_the_beginning);
}

#[test]
fn too_little_is_refused() {
    let mut draw = draws(3);
    let known: Vec<Course> = (0..3).map(|_| random(&mut draw)).collect();
    let few = Expected::of(&known.iter().collect::<Vec<_>>()).unwrap_err();
    assert!(few.to_string().contains("at least 4"), "{few}");
    assert!(Expected::of(&[]).is_err());
    let known: Vec<Course> = (0..5).map(|_| random(&mut draw)).collect();
    let expected = Expected::of(&known.iter().collect::<Vec<_>>()).unwrap();
    let wrong = Test { false_alarms: 0.7, ..TEST };
    assert!(expected.judge(&known[0], &wrong).is_err());
}

const DEPTH_M: f64 = 0.03;

fn shallow(scale: f64, ratio: impl Fn(f64) -> f64) -> Course {
    let samples = (0..6000).map(|i| {
        let x = f64::from(i) / 2000.0;
        let force_n = scale * 10.0 * (0.3 * x).exp() * ratio(x);
        CourseSample { t_s: f64::from(i) * 0.002, way_m: x * DEPTH_M, force_n, depth_m: DEPTH_M }
    });
    prepared(Course::from_samples(90.0, DEPTH_M, Some(0.2 * DEPTH_M), samples))
}

/// Forces that go through the middle of the bounds as a block comes nearer: wherever it is when it is found, the region holds it, and gets
/// smaller the longer one goes on.
#[test]
fn it_holds_the_block_and_narrows() {
    let ratios = Ratios::shipped();
    let phi = ratios.phi_deg()[0];
    let scales = [0.98, 1.01, 0.99, 1.02, 1.0, 1.015];
    let known: Vec<Course> =
        scales.iter().map(|scale| shallow(*scale, |x| 1.0 + 0.5 * (scale - 1.0) * x)).collect();
    let expected = Expected::of(&known.iter().collect::<Vec<_>>()).unwrap();
    for (start, top) in [(2.6, 0.3), (2.2, 0.1)] {
        let ratio = |x: f64| {
            let [low, high] = ratios.between(&[phi], [(start - x).max(0.0); 2], [top; 2]);
            if high.is_finite() { (low * high).sqrt() } else { 1.5 * low }
        };
        let judged = expected.judge(&shallow(1.0, ratio), &TEST).unwrap();
        let found = judged.alarm.unwrap().look;
        let mut widths = Vec::new();
        for up_to in found..judged.looks.len() {
            let look = judged.looks[up_to];
            let region = region(&judged, up_to, &ratios, [phi, phi]).unwrap();
            let ahead_m = start * DEPTH_M - look.way_m;
            if ahead_m <= 0.0 {
                break;
            }
            let holds = |range: [f64; 2], value: f64| range[0] <= value && value <= range[1];
            assert!(
                region
                    .places
                    .iter()
                    .any(|p| holds(p.ahead_m, ahead_m) && holds(p.top_m, top * DEPTH_M + 1e-9)),
                "{ahead_m} {look:?} {region:?}"
            );
            widths.push(region.places.len());
        }
        assert!(widths.last() <= widths.first(), "{widths:?}");
    }
}

/// A force that is four times as much at once, as no block that comes nearer by and by makes it far away, leaves only near places; one that falls leaves none near.
#[test]
fn what_no_block_does() {
    let ratios = Ratios::shipped();
    let known: Vec<Course> = [0.99, 1.01, 1.0, 1.005, 0.995].map(|scale| shallow(scale, |_| 1.0)).to_vec();
    let expected = Expected::of(&known.iter().collect::<Vec<_>>()).unwrap();
    let judged = expected.judge(&shallow(1.0, |x| if x < 1.5 { 1.0 } else { 4.0 }), &TEST).unwrap();
    let near = region(&judged, judged.alarm.unwrap().look, &ratios, ratios.phi_deg()).unwrap();
    assert!(near.ahead_m().is_none_or(|ends| ends[1] < 2.0 * DEPTH_M), "{near:?}");
    let falling = expected.judge(&shallow(1.0, |x| (-0.1 * x).exp()), &TEST).unwrap();
    let none = region(&falling, falling.looks.len() - 1, &ratios, ratios.phi_deg()).unwrap();
    assert!(none.ahead_m().is_none_or(|ends| ends[0] > 0.5 * DEPTH_M), "{none:?}");
    assert!(region(&falling, 99, &ratios, ratios.phi_deg()).is_err());
}

/// The shipped table keeps the order that nested blocks demand: no lower bound lies above the upper bound of a block that holds it.
#[test]
fn the_table_is_read_and_in_order() {
    let table = Ratios::shipped();
    for a in table.ratios() {
        assert!(a.lower >= 1.0 && a.lower <= a.upper, "{a:?}");
        for b in table.ratios() {
            let holds =
                a.phi_deg == b.phi_deg && a.ahead_depths <= b.ahead_depths && a.top_depths <= b.top_depths;
            assert!(!holds || b.lower <= a.upper, "{a:?} {b:?}");
        }
        let [low, high] = table.between(&[a.phi_deg], [a.ahead_depths; 2], [a.top_depths; 2]);
        assert!(low >= a.lower && high <= a.upper && low <= high, "{a:?} {low} {high}");
    }
    let [least, most] = table.phi_deg();
    assert_eq!(table.friction_angles_deg([least, most]).unwrap().last(), Some(&most));
    assert!(table.friction_angles_deg([least - 1.0, most]).is_err());
}

#[test]
fn nothing_is_said_between_places_that_bounds_do_not_prove() {
    let table = Ratios::new(
        [
            (30.0, 1.0, 1.5, 2.0),
            (30.0, 2.0, 1.1, 1.2),
            (40.0, 1.0, 1.8, f64::INFINITY),
            (40.0, 2.0, 1.0, 1.4),
        ]
        .map(|(phi_deg, ahead_depths, lower, upper)| Ratio {
            phi_deg,
            ahead_depths,
            top_depths: 0.3,
            lower,
            upper,
        })
        .to_vec(),
    )
    .unwrap();
    assert_eq!(table.between(&[30.0], [1.0, 2.0], [0.3, 0.3]), [1.1, 2.0]);
    assert_eq!(table.between(&[30.0, 40.0], [1.0, 1.0], [0.3, 0.3]), [1.5, f64::INFINITY]);
    assert_eq!(table.between(&[30.0], [0.2, 0.9], [0.1, 0.2]), [1.5, f64::INFINITY]);
    assert_eq!(table.between(&[30.0], [3.0, 4.0], [0.5, 0.6]), [1.0, 1.2]);
    assert_eq!(table.between(&[30.0], [0.1, 0.2], [1.0, 1.1]), [1.0, 1.0]);
    assert_eq!(table.friction_angles_deg([32.0, 33.0]).unwrap(), [30.0, 40.0]);
    assert_eq!(table.friction_angles_deg([40.0, 40.0]).unwrap(), [40.0]);
    assert!(Ratios::new(Vec::new()).is_none());
}

/// Four strokes in each of three preparations, whose densities differ: a stroke of another preparation is held against three of them, not twelve.
#[test]
fn preparations_are_what_levels_scatter_by() {
    let stroke = |preparation: usize, level: f64, slope: f64| {
        let of = course(0.03, move |x| 9.0 * (level + (0.4 + slope) * x).exp());
        of.in_preparation(preparation)
    };
    let known: Vec<Course> = [-0.02, 0.0, 0.02]
        .into_iter()
        .enumerate()
        .flat_map(|(place, level)| {
            [-0.01, -0.005, 0.005, 0.01].map(move |slope| stroke(place, level + 0.1 * slope, slope))
        })
        .collect();
    let of = |known: &[Course]| Expected::of(&known.iter().collect::<Vec<_>>()).unwrap();
    let other = stroke(9, 0.1, 0.0);
    let judged = of(&known).judge(&other, &TEST).unwrap();
    assert!(judged.alarm.is_none(), "{:?}", judged.looks);
    // Were they twelve preparations it would be odd, and as much less is odd too.
    let apart: Vec<Course> =
        known.iter().cloned().enumerate().map(|(place, of)| of.in_preparation(place)).collect();
    assert!(of(&apart).judge(&other, &TEST).unwrap().alarm.unwrap().from_the_beginning);
    let less = of(&apart).judge(&stroke(9, -0.1, 0.0), &TEST).unwrap_err();
    assert!(matches!(less, ProcessError::Unlike { .. }), "{less}");
}
