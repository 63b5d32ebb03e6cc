//! Whole strokes in simulated sand.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod rig;

use rig::{Trace, spec, stroke, stroke_on};
use soilctl_controller::{EventKind, StrokeLaw};
use soilctl_plant::PlantParams;
use soilctl_plant::config::{LossLaw, MobilisationLaw, TangentLaw};

/// The first tick at which the soil fails, in a stroke.
fn failure(trace: &Trace) -> rig::Row {
    *trace.rows.iter().find(|row| row.stroking && row.soil.failing).unwrap()
}

/// The sensor reads the force of the model when the soil fails, for a point model and for a bracket.
#[test]
fn the_soil_fails_at_the_force_of_the_model() {
    fails_at_the_limit("ticino_rained", "table", 80.0);
    fails_at_the_limit("ticino_loose", "chen", 90.0);
    fails_at_the_limit("glass_beads", "coulomb", 100.0);
}

fn fails_at_the_limit(soil: &str, model: &str, alpha: f64) {
    let radius = 0.4318;
    let delta = if soil == "glass_beads" { 19.0 } else { 23.0 };
    let (done, trace) = stroke(soil, model, spec(radius, alpha, 0.0254, delta), StrokeLaw::Force);
    assert!(done);
    let row = failure(&trace);
    let error = row.force_n - row.soil.limit_force_now_n;
    println!(
        "{soil} {model} {alpha} deg: sensor {:.2} N, model {:.2} N ({:.2} at full friction), depth {:.2} mm, heap {:.2} mm",
        row.force_n,
        row.soil.limit_force_now_n,
        row.soil.limit_force_n,
        1e3 * row.soil.depth_m,
        1e3 * row.soil.heap_m
    );
    // Noise of two channels after the low-pass, and 2 % for what has not quite failed.
    assert!(error.abs() < 0.1 + 0.02 * row.soil.limit_force_now_n, "{error} N");
    let depth = trace.find(EventKind::Inserted).unwrap();
    println!("  inserted {:.2} of {:.2} mm", 1e3 * depth.value, 1e3 * depth.limit);
}

/// By whatever laws strength is mobilised and lost, drives rub and heaps lie, the soil fails at the force of the model; but the ways there differ.
#[test]
fn other_laws_fail_at_the_same_force() {
    let mut config = PlantParams::thesis().config().clone();
    let ground = &mut config.ground;
    (ground.mobilisation_law, ground.loss_law) = (MobilisationLaw::Hyperbola, LossLaw::Linear);
    (ground.tangent_law, ground.heap_past) = (TangentLaw::Hyperbola, 0.3);
    config.drives.breakaway = 1.3;
    let text = toml::to_string(&config).unwrap();
    let plant = PlantParams::from_toml(PlantParams::thesis().arm().clone(), &text, "other laws").unwrap();
    let wanted = spec(0.4318, 80.0, 0.0254, 23.0);
    let (done, other) = stroke_on(plant, "ticino_rained", "table", wanted, StrokeLaw::Force);
    let (_, plain) = stroke("ticino_rained", "table", wanted, StrokeLaw::Force);
    assert!(done);
    let row = failure(&other);
    let error = row.force_n - row.soil.limit_force_now_n;
    assert!(error.abs() < 0.1 + 0.02 * row.soil.limit_force_now_n, "{error} N");
    let least = |trace: &Trace| {
        let after = trace.rows.iter().filter(|row| row.stroking).skip_while(|row| !row.soil.failing);
        after.map(|row| row.soil.limit_force_now_n).fold(f64::INFINITY, f64::min)
    };
    let way = |trace: &Trace| {
        let begin = trace.rows.iter().find(|row| row.stroking).unwrap();
        begin.radius_m - failure(trace).radius_m
    };
    println!(
        "way to failure {:.2} and {:.2} mm, least force after it {:.2} and {:.2} N",
        1e3 * way(&plain),
        1e3 * way(&other),
        least(&plain),
        least(&other)
    );
    assert!((way(&plain) - way(&other)).abs() > 1e-5);
}

/// Errors of the force's inclination in degrees from 0.6 of the failure force until the soil fails.
fn tracking(radius_m: f64, alpha_deg: f64, law: StrokeLaw) -> Vec<f64> {
    let delta = 23.0_f64;
    let (_, trace) = stroke("ticino_loose", "table", spec(radius_m, alpha_deg, 0.0254, delta), law);
    let before =
        trace.rows.iter().filter(|row| row.stroking).map(|row| row.soil).take_while(|soil| !soil.failing);
    // Across the plate, since along it there is first what the insertion has left.
    before
        .filter(|soil| soil.normal_n > 0.6 * soil.limit_force_n * libm::cos(delta.to_radians()))
        .map(|soil| (soil.tangent_n.atan2(soil.normal_n).to_degrees() - delta).abs())
        .collect()
}

/// Mean, and the share above 3 deg.
fn summed_up(errors: &[f64]) -> (f64, f64) {
    let count = errors.len().max(1) as f64;
    let above = errors.iter().filter(|error| **error > 3.0).count() as f64;
    (errors.iter().sum::<f64>() / count, above / count)
}

/// In the thesis force feedback tracks "within 1 to 3 degrees for most of the duration of the stroke" (figure 5-11), while the
/// angle under position feedback varies widely (figure 5-8). The places differ by about an external encoder's count.
///
/// Loose sand at 70 and 80 deg is the worst case: 3 and 5 N, against motors that stick with as much.
#[test]
fn force_feedback_tracks_the_angle_at_all_tool_angles() {
    let (mut force, mut position) = (0.0, 0.0);
    for (radius, alpha) in [(0.3048, 70.0), (0.4318, 80.0), (0.4318, 90.0), (0.4318, 100.0)] {
        for place in [0.0, 0.0021] {
            let errors = tracking(radius + place, alpha, StrokeLaw::Force);
            let (mean, above) = summed_up(&errors);
            let worst = errors.iter().copied().fold(0.0, f64::max);
            println!("{alpha} deg: mean {mean:.2}, worst {worst:.2} deg, {:.1} % above 3 deg", 100.0 * above);
            assert!(errors.len() > 100 && mean < 1.5 && above < 0.05, "{mean} deg, {above} at {alpha} deg");
            force += mean;
        }
        let (mean, above) = summed_up(&tracking(radius, alpha, StrokeLaw::Position));
        println!("{alpha} deg, position feedback: mean {mean:.2} deg, {:.1} % above 3 deg", 100.0 * above);
        position += 2.0 * mean;
    }
    assert!(position > 3.0 * force, "{position} against {force} deg in the sum of the means");
}

/// The slope of log force over log depth, both as true; 2 in sand without cohesion.
#[test]
fn force_goes_with_the_square_of_depth() {
    let points: Vec<(f64, f64)> = [0.5, 0.6, 0.7, 0.8, 0.9, 1.0]
        .into_iter()
        .map(|inches| {
            let wanted = spec(0.4318, 80.0, inches * 0.0254, 23.0);
            let (_, trace) = stroke("ticino_rained", "table", wanted, StrokeLaw::Force);
            let row = failure(&trace);
            println!(
                "{inches} in: {:.2} N at {:.2} mm, wanted {:.2} mm",
                row.force_n,
                1e3 * row.soil.depth_m,
                1e3 * wanted.depth_m
            );
            (row.soil.depth_m.ln(), row.force_n.ln())
        })
        .collect();
    let count = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), point| (x + point.0 / count, y + point.1 / count));
    let above: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    let below: f64 = points.iter().map(|point| (point.0 - x) * (point.0 - x)).sum();
    println!("exponent {:.3}", above / below);
    // Sensor noise of 0.1 N on 3 N is 3 % at the least depth.
    assert!((above / below - 2.0).abs() < 0.1, "{}", above / below);
}
