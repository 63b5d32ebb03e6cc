//! What settling must keep, and the shapes it must make.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

use proptest::prelude::*;
use soilctl_terrain::{HeightField, Repose, Sweep, TerrainError};

fn repose(degrees: f64) -> Repose {
    Repose::from_radians(degrees.to_radians()).unwrap()
}

fn slope(degrees: f64) -> f64 {
    degrees.to_radians().tan()
}

/// Rough ground from a linear congruence.
fn rough(n: usize, amplitude_m: f64) -> HeightField {
    let mut state = 12_345_u64;
    let heights = (0..n * n)
        .map(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            amplitude_m * (state >> 11) as f64 / (1_u64 << 53) as f64
        })
        .collect();
    HeightField::from_heights(n, 0.005, heights).unwrap()
}

/// Cell (i, j) of the turned box is cell (j, n - 1 - i) of the other.
fn quarter_turn(field: &HeightField) -> HeightField {
    let n = field.columns();
    let heights = (0..n * n).map(|k| field.heights_m()[(n - 1 - k % n) * n + k / n]).collect();
    HeightField::from_heights(n, field.cell_m(), heights).unwrap()
}

#[test]
fn volume_stays_over_many_steps() {
    let mut field = rough(24, 0.1);
    let before = field.volume_m3();
    let mut moving = 0;
    for step in 0..100_000_u32 {
        // Never at rest for long: a plate goes through it again.
        if step % 100 == 0 {
            field.lift();
            let y = 0.005 * f64::from(4 + step / 100 % 16);
            let (from_m, to_m) = if step % 200 == 0 { ([0.1, y], [0.02, y]) } else { ([0.02, y], [0.1, y]) };
            field.push(&Sweep { from_m, to_m, width_m: 0.02, bottom_m: 0.02, ahead_m: 0.015 }).unwrap();
        }
        moving += u32::from(field.settle_step(&repose(5.0)).moved_m3 > 0.0);
    }
    assert!(moving > 90_000, "{moving}");
    assert!((field.volume_m3() / before - 1.0).abs() < 1e-12);
}

/// Of the plane through four neighbours, by least squares.
fn gradient_size(field: &HeightField, i: usize, j: usize) -> f64 {
    let (n, h) = (field.columns(), field.heights_m());
    let [a, b, c, d] = [j * n + i, j * n + i + 1, (j + 1) * n + i, (j + 1) * n + i + 1].map(|k| h[k]);
    f64::hypot(0.5 * (b - a + d - c), 0.5 * (c - a + d - b)) / field.cell_m()
}

#[test]
fn no_slope_is_left_above_repose_diagonals_included() {
    for degrees in [20.0, 33.0, 45.0] {
        let mut field = rough(48, 0.15);
        let settled = field.settle(&repose(degrees), 100_000, 1e-5);
        assert!(settled.steps < 100_000, "{settled:?}");
        let steepest = field.steepest_slope().atan().to_degrees();
        assert!(steepest < degrees + 0.1, "{steepest} after {} steps", settled.steps);
        // Between the eight directions the gradient could be steeper than any of them.
        let places = (0..47 * 47).map(|k| gradient_size(&field, k % 47, k / 47));
        let gradient = places.fold(0.0_f64, f64::max).atan().to_degrees();
        assert!(gradient < degrees + 0.1, "{gradient}");
    }
}

#[test]
fn a_poured_heap_is_a_round_cone() {
    let (n, degrees) = (121, 32.0);
    let mut field = HeightField::level(n, n, 0.004, 0.0).unwrap();
    let middle = 0.5 * n as f64 * 0.004;
    for _ in 0..60 {
        field.pour([middle, middle], 0.012, 4e-5).unwrap();
        field.settle(&repose(degrees), 400, 1e-4);
    }
    field.settle(&repose(degrees), 60_000, 1e-5);
    let volume = field.volume_m3();
    // A cone of that volume: V = pi r^3 tan(repose) / 3.
    let radius = (3.0 * volume / (std::f64::consts::PI * slope(degrees))).cbrt();
    // The foot along eight directions and four between, by the height that the cone has at nine tenths of its radius.
    let level = 0.1 * radius * slope(degrees);
    let radii: Vec<f64> = (0..24)
        .map(|k| {
            let angle = f64::from(k) * std::f64::consts::TAU / 24.0;
            let at = |r: f64| bilinear(&field, middle + r * angle.cos(), middle + r * angle.sin());
            let (mut low, mut high) = (0.0, 0.9 * middle);
            for _ in 0..50 {
                let mid = 0.5 * (low + high);
                if at(mid) > level { low = mid } else { high = mid }
            }
            low
        })
        .collect();
    let (least, most) = radii.iter().fold((f64::MAX, 0.0_f64), |(l, m), r| (l.min(*r), m.max(*r)));
    assert!(most / least < 1.03);
    assert!((0.5 * (least + most) / (0.9 * radius) - 1.0).abs() < 0.02);
}

fn bilinear(field: &HeightField, x: f64, y: f64) -> f64 {
    let cell = field.cell_m();
    let (u, v) = (x / cell - 0.5, y / cell - 0.5);
    let (i, j) = (u.floor(), v.floor());
    let at = |i: f64, j: f64| field.height_at_m([(i + 0.5) * cell, (j + 0.5) * cell]).unwrap_or(0.0);
    let (a, b) = (u - i, v - j);
    (1.0 - a) * (1.0 - b) * at(i, j)
        + a * (1.0 - b) * at(i + 1.0, j)
        + (1.0 - a) * b * at(i, j + 1.0)
        + a * b * at(i + 1.0, j + 1.0)
}

#[test]
fn a_quarter_turn_turns_the_result() {
    let (mut one, mut other) = (rough(40, 0.12), quarter_turn(&rough(40, 0.12)));
    for _ in 0..500 {
        one.settle_step(&repose(30.0));
        other.settle_step(&repose(30.0));
    }
    for (a, b) in quarter_turn(&one).heights_m().iter().zip(other.heights_m()) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

/// One row: a wall of soil falls to a slope of repose whose area is known.
#[test]
fn a_profile_falls_to_its_slope_of_repose() {
    let (n, cell, degrees) = (400, 0.0025, 30.0);
    let heights = (0..n).map(|i| if i < 150 { 0.2 } else { 0.0 }).collect();
    let mut field = HeightField::from_heights(n, cell, heights).unwrap();
    field.settle(&repose(degrees), 200_000, 1e-6);
    // The cliff at x = 0.375 becomes a slope of 0.2 m that is halved by it: from the middle 0.1/tan(30) either way.
    let run = 0.1 / slope(degrees);
    for (i, found) in field.heights_m().iter().enumerate() {
        let x = (i as f64 + 0.5) * cell - 0.375;
        let expected = (0.1 - x * slope(degrees)).clamp(0.0, 0.2);
        // A cell's height at the bends, one at the foot and one at the top.
        assert!((found - expected).abs() < 1.5 * cell * slope(degrees), "{x}: {found} {expected} ({run})");
    }
}

#[test]
fn a_gentle_surface_does_not_move() {
    let heights: Vec<f64> = (0..900).map(|k| 0.001 * (k % 30) as f64 + 0.0005 * (k / 30) as f64).collect();
    let mut field = HeightField::from_heights(30, 0.005, heights.clone()).unwrap();
    let settled = field.settle(&repose(25.0), 100, 0.0);
    assert_eq!((settled.steps, settled.moved_m3, settled.excess_slope), (1, 0.0, 0.0));
    assert_eq!(field.heights_m(), heights);
}

#[test]
fn a_plate_leaves_a_furrow_and_a_heap() {
    let mut field = HeightField::level(120, 100, 0.005, 0.12).unwrap();
    let before = field.volume_m3();
    let mut moved = 0.0;
    for k in 0..50 {
        let x = 0.2 + 0.001 * f64::from(k);
        let sweep = Sweep {
            from_m: [x, 0.25],
            to_m: [x + 0.001, 0.25],
            width_m: 0.127,
            bottom_m: 0.095,
            ahead_m: 0.02,
        };
        moved += field.push(&sweep).unwrap();
        field.settle(&repose(35.0), 4, 0.0);
    }
    // 50 mm of way, 127 mm wide, 25 mm deep, and what lay ahead or slid back and was taken again: soil is left up to 20 mm ahead,
    // so that no grain is moved more often than 50/20 times and once more.
    let cut = 0.05 * 0.127 * 0.025;
    assert!(moved > cut && moved < 3.5 * cut, "{moved} {cut}");
    assert!((field.volume_m3() / before - 1.0).abs() < 1e-13);
    let lowest = field.heights_m().iter().copied().fold(f64::MAX, f64::min);
    assert!(lowest < 0.117, "{lowest}");
    let ahead = field.mean_height_m([0.25, 0.25], [1.0, 0.0], 0.02, 0.1).unwrap();
    assert!(ahead > 0.125, "{ahead}");
}

/// One sweep at any angle takes the prism that the plate goes through, whatever the cells.
fn prism(angle: f64, way: f64, width: f64, depth: f64) -> (f64, f64) {
    let mut field = HeightField::level(100, 100, 0.005, 0.12).unwrap();
    let to_m = [0.25 + way * angle.cos(), 0.25 + way * angle.sin()];
    let sweep = Sweep { from_m: [0.25, 0.25], to_m, width_m: width, bottom_m: 0.12 - depth, ahead_m: 0.05 };
    (field.push(&sweep).unwrap(), way * width * depth)
}

/// A furrow along the cells, made in sweeps shorter than a cell: its bottom is level and it lacks the volume of the plate's way,
/// all of which lies ahead.
#[test]
fn many_short_sweeps_leave_the_furrow_of_one_long_one() {
    for count in [10, 15, 60, 85] {
        let mut field = HeightField::level(120, 100, 0.005, 0.12).unwrap();
        let step = 0.06 / f64::from(count);
        for k in 0..count {
            let x = 0.2 + step * f64::from(k);
            let (from_m, to_m) = ([x, 0.25], [x + step, 0.25]);
            field.push(&Sweep { from_m, to_m, width_m: 0.12, bottom_m: 0.095, ahead_m: 0.03 }).unwrap();
        }
        let inside = |k: usize| (40..52).contains(&(k % 120)) && (38..62).contains(&(k / 120));
        let heights = || field.heights_m().iter().copied().enumerate();
        for (k, height) in heights() {
            assert!(if inside(k) { (height - 0.095).abs() < 1e-12 } else { height >= 0.12 }, "{k} {height}");
        }
        let ahead: f64 = heights().filter(|(k, _)| !inside(*k)).map(|(_, height)| height - 0.12).sum();
        assert!((ahead * 25e-6 - 0.06 * 0.12 * 0.025).abs() < 1e-12, "{ahead}");
    }
}

/// After the plate was lifted, ground that has run back into the furrow is taken in full.
#[test]
fn a_new_stroke_takes_what_lies_there() {
    let mut field = HeightField::level(40, 40, 0.005, 0.1).unwrap();
    let sweep =
        Sweep { from_m: [0.05, 0.1], to_m: [0.0525, 0.1], width_m: 0.05, bottom_m: 0.08, ahead_m: 0.02 };
    let first = field.push(&sweep).unwrap();
    field.lift();
    let second = field.push(&sweep).unwrap();
    // Half of each cell went, and came to lie over 20 mm, an eighth of it in the other half; half of what is there goes now.
    assert!((second / first - 0.5 * (1.0 + 0.125)).abs() < 1e-12, "{first} {second}");
}

proptest! {
    #[test]
    fn a_sweep_takes_its_prism(
        angle in 0.0..6.3_f64, way in 0.0001..0.1_f64, width in 0.001..0.15_f64, depth in 0.001..0.1_f64,
    ) {
        let (taken, volume) = prism(angle, way, width, depth);
        prop_assert!((taken / volume - 1.0).abs() < 1e-9, "{taken} {volume}");
    }

    #[test]
    fn pushing_keeps_the_volume(
        x in -0.1..0.4_f64, y in -0.1..0.4_f64, way in 0.0..0.1_f64, angle in 0.0..6.3_f64, width in 0.001..0.3_f64, bottom in -0.2..0.1_f64,
    ) {
        let mut field = rough(60, 0.05);
        let before = field.volume_m3();
        let to_m = [x + way * angle.cos(), y + way * angle.sin()];
        field.push(&Sweep { from_m: [x, y], to_m, width_m: width, bottom_m: bottom, ahead_m: 0.02 }).unwrap();
        prop_assert!((field.volume_m3() / before - 1.0).abs() < 1e-12);
    }

    #[test]
    fn any_numbers_are_answered(
        columns in 0..5000_usize, rows in 0..5000_usize, cell in any::<f64>(), height in any::<f64>(), angle in any::<f64>(),
    ) {
        let small = columns.saturating_mul(rows) < 10_000;
        if small && let Ok(mut field) = HeightField::level(columns, rows, cell, height) {
            if let Ok(repose) = Repose::from_radians(angle) {
                field.settle(&repose, 3, 0.0);
            }
            let _ = field.pour([height, cell], angle, cell);
            let _ = field.push(&Sweep { from_m: [cell, height], to_m: [angle, cell], width_m: height, bottom_m: angle, ahead_m: cell });
            prop_assert!(field.heights_m().iter().all(|h| h.is_finite()));
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    assert!(matches!(HeightField::level(0, 5, 0.1, 0.0), Err(TerrainError::Cells { .. })));
    assert!(matches!(HeightField::level(usize::MAX, 5, 0.1, 0.0), Err(TerrainError::Cells { .. })));
    assert!(matches!(HeightField::from_heights(3, 0.1, vec![0.0; 8]), Err(TerrainError::Heights { .. })));
    assert!(matches!(HeightField::level(2, 2, f64::NAN, 0.0), Err(TerrainError::OutOfRange { .. })));
    let mut field = HeightField::level(4, 4, 0.1, 0.0).unwrap();
    assert!(matches!(field.pour([9.0, 9.0], 0.1, 1.0), Err(TerrainError::Outside { .. })));
}

/// What runs past a plate lies beside it, as much as was said, and not a grain is lost; where a wall is close, it stays ahead.
#[test]
fn windrows() {
    for (y, shares) in [(0.25, [0.2, 0.2]), (0.06, [0.0, 0.2])] {
        let mut field = HeightField::level(100, 100, 0.005, 0.1).unwrap();
        let before = field.volume_m3();
        let sweep = Sweep { from_m: [0.3, y], to_m: [0.25, y], width_m: 0.12, bottom_m: 0.08, ahead_m: 0.06 };
        let moved = field.push_past(&sweep, 0.4).unwrap();
        assert!((moved - 0.05 * 0.12 * 0.02).abs() < 1e-12 && (field.volume_m3() - before).abs() < 1e-12);
        for (side, share) in [-1.0, 1.0].into_iter().zip(shares) {
            let middle = y + side * 0.075;
            let rise = field.mean_height_m([0.25, middle], [-1.0, 0.0], 0.03, 0.03).map_or(0.0, |z| z - 0.1);
            assert!((rise * 0.03 * 0.03 - share * moved).abs() < 1e-12, "{side}: {rise}");
        }
    }
    let mut field = HeightField::level(100, 100, 0.005, 0.1).unwrap();
    let sweep = Sweep { from_m: [0.3, 0.2], to_m: [0.25, 0.2], width_m: 0.12, bottom_m: 0.08, ahead_m: 0.06 };
    assert!(field.push_past(&sweep, 1.1).is_err() && field.push_past(&sweep, f64::NAN).is_err());
}
