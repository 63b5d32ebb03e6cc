//! Estimates of plates with ends, of which strokes in one soil share the end factor.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_earth_pressure::{Case, ForceModel, InPlaneStrain, model};
use soilctl_estimator::{
    Estimate, Observation, Setup, StrokeMenu, best_fit, estimate, next_strokes, projections, section,
};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2};
use soilctl_tests::{Random, shown};

/// By how much the end factors of a campaign may differ here.
const TOLERANCE: f64 = 0.1;

#[derive(Clone, Copy)]
struct Truth {
    phi: f64,
    delta: f64,
    density: f64,
}

fn plate(alpha: f64, depth: f64, width: f64) -> Plate {
    Plate::new(Angle::from_degrees(alpha), Angle::ZERO, depth, width).unwrap()
}

fn table() -> Box<dyn ForceModel> {
    model("table").unwrap()
}

/// The plate with its ends, and the same in plane strain.
fn cases(truth: Truth, plate: &Plate) -> [Case; 2] {
    let plane = Case::level_deg(plate.tool_angle().degrees(), truth.phi, truth.delta);
    [plane.with_width_ratio(plate.width_ratio()), plane]
}

fn force_n(truth: Truth, plate: &Plate, k: f64) -> f64 {
    let (l, w) = (plate.slant_length_m(), plate.width_m());
    0.5 * truth.density * STANDARD_GRAVITY_M_S2 * l * l * w * k
}

/// A true coefficient: anywhere in the bracket of plane strain, and a part of what ends add at most.
fn coefficient(model: &dyn ForceModel, truth: Truth, plate: &Plate, inside: f64, factor: f64) -> f64 {
    let [ended, plane] = cases(truth, plate).map(|case| model.predict(&case).unwrap());
    let at_most = (ended.net_upper.0 - plane.net_upper.0).max(0.0);
    ended.net_lower.0 + inside * (plane.net_upper.0 - ended.net_lower.0) + factor * at_most
}

/// Measured with an error within bounds that are stated.
fn measured(random: &mut Random, label: usize, plate: Plate, force_n: f64, half_width: f64) -> Observation {
    let error = if random.unit() < 0.1 { 1.0 } else { random.between(-1.0, 1.0) };
    let read = force_n / (1.0 + error * half_width);
    Observation::new(format!("{label}"), plate, read, half_width * read).unwrap()
}

fn within(found: &Estimate, truth: Truth) -> bool {
    found.region.contains([truth.phi, truth.density])
}

/// Random soils with end factors anywhere in the proven bracket, which strokes share within the tolerance, and forces within
/// their errors: the truth is in the region each time. The rows say how often it is not if ends are forgotten.
#[test]
fn the_truth_is_inside_wherever_ends_put_it() {
    let (ended, plane) = (table(), InPlaneStrain::of(table()));
    let mut random = Random(20_261_126);
    let mut rows = Vec::new();
    for (name, ratios) in
        [("w/H 0.5 to 2", [0.5, 2.0]), ("w/H 2 to 5", [2.0, 5.0]), ("w/H 5 to 20", [5.0, 20.0])]
    {
        const SOILS: usize = 334;
        let (mut missed_without, mut refuted_without) = (0, 0);
        for _ in 0..SOILS {
            let phi = random.between(27.0, 47.0);
            let delta = random.between(1.0, 28.0_f64.min(phi - 1.0));
            let truth = Truth { phi, delta, density: random.between(1200.0, 1900.0) };
            let half_width = random.between(0.01, 0.08);
            let shared = random.unit();
            let strokes = 2 + (random.unit() * 4.0) as usize;
            let observations: Vec<_> = (0..strokes)
                .map(|label| {
                    let depth = random.between(0.012, 0.05);
                    let width = depth * random.between(ratios[0], ratios[1]);
                    let plate = plate(random.between(70.0, 100.0), depth, width);
                    let factor = (shared + TOLERANCE * random.between(-1.0, 1.0)).clamp(0.0, 1.0);
                    let k = coefficient(&*ended, truth, &plate, random.unit(), factor);
                    measured(&mut random, label, plate, force_n(truth, &plate, k), half_width)
                })
                .collect();
            let interval = ((delta - 1.0).max(0.0), delta + 1.0);
            let with_density = |model| {
                let setup = Setup::new(model, observations.clone(), interval);
                setup.with_density(0.96 * truth.density, 1.04 * truth.density)
            };
            let setup = Setup { end_tolerance: TOLERANCE, ..with_density(&*ended) };
            let found = estimate(&setup).unwrap();
            assert!(within(&found, truth), "phi {phi}, delta {delta}, factor {shared}, {strokes} strokes");
            let [low, high] = found.end_factor.unwrap();
            assert!(low - TOLERANCE <= shared && shared <= high + TOLERANCE, "{low} to {high}: {shared}");
            let without = estimate(&with_density(&*plane)).unwrap();
            missed_without += usize::from(!within(&without, truth));
            refuted_without += usize::from(!without.is_consistent());
        }
        let percent = |count: usize| 100.0 * count as f64 / SOILS as f64;
        rows.push((name.to_owned(), vec![100.0, 100.0 - percent(missed_without), percent(refuted_without)]));
    }
    let header =
        "plates,truth inside with ends (%),truth inside by plane strain (%),no soil by plane strain (%)";
    shown("end_factor.csv", header, &rows);
}

/// What ends add by another author's formula, on the plane strain of a third: the side forces of Perumpral, Grisso & Desai (1983)
/// grow otherwise with angle, width and friction than our blocks do.
#[test]
fn ends_of_another_authors_formula_share_one_factor_well_enough() {
    let (ended, wedge, spiral) = (table(), model("perumpral").unwrap(), model("log-spiral").unwrap());
    for (phi, delta) in [(30.0, 15.0), (35.0, 20.0), (40.0, 25.0), (44.0, 18.0)] {
        let truth = Truth { phi, delta, density: 1550.0 };
        let plates = [(70.0, 0.02), (80.0, 0.03), (90.0, 0.025), (100.0, 0.04), (75.0, 0.05)];
        let observations: Vec<_> = plates
            .into_iter()
            .enumerate()
            .map(|(label, (alpha, depth))| {
                let plate = plate(alpha, depth, 0.127);
                let [case, plane] = cases(truth, &plate);
                let net = |model: &dyn ForceModel, case| model.predict(&case).unwrap().net.weight;
                let ends = net(&*wedge, case) - net(&*wedge, plane);
                let force = force_n(truth, &plate, net(&*spiral, plane) + ends);
                Observation::new(format!("{label}"), plate, force, 0.01 * force).unwrap()
            })
            .collect();
        let setup =
            Setup::new(&*ended, observations, (delta - 1.0, delta + 1.0)).with_density(1500.0, 1600.0);
        let found = estimate(&Setup { end_tolerance: TOLERANCE, ..setup.clone() }).unwrap();
        assert!(within(&found, truth), "phi {phi}: {:?}", found.phi_deg);
        let apart = estimate(&setup).unwrap();
        assert!(found.region.area() < apart.region.area() && apart.end_factor.is_none());
        let plane = InPlaneStrain::of(table());
        let without = estimate(&Setup { model: &*plane, ..setup }).unwrap();
        assert!(!within(&without, truth), "phi {phi}: ends would not matter");
    }
}

const TRUTH: Truth = Truth { phi: 36.0, delta: 20.0, density: 1500.0 };

/// Strokes of plates of these widths, at an end factor of 0.5.
fn strokes(model: &dyn ForceModel, widths: &[f64], relative: f64) -> Vec<Observation> {
    let mut observations = Vec::new();
    for alpha in [70.0, 85.0, 100.0] {
        for &width in widths {
            let plate = plate(alpha, 0.025, width);
            let force = force_n(TRUTH, &plate, coefficient(model, TRUTH, &plate, 0.5, 0.5));
            let label = format!("{alpha} deg, {width} m");
            observations.push(Observation::new(label, plate, force, relative * force).unwrap());
        }
    }
    observations
}

fn shared<'m>(model: &'m dyn ForceModel, observations: Vec<Observation>, end_tolerance: f64) -> Setup<'m> {
    let setup = Setup::new(model, observations, (19.0, 21.0)).with_density(1440.0, 1560.0);
    Setup { end_tolerance, ..setup }
}

/// The less strokes share, the larger the region; a second width narrows both end factor and friction angle.
#[test]
fn sharing_and_a_second_width_narrow_what_is_left() {
    let model = table();
    let of = |widths: &[f64], tolerance| {
        estimate(&shared(&*model, strokes(&*model, widths, 0.02), tolerance)).unwrap()
    };
    let areas = [0.0, 0.05, 0.2, 1.0].map(|tolerance| of(&[0.127], tolerance).region.area());
    assert!(areas.windows(2).all(|w| w[0] <= w[1] * (1.0 + 1e-6)), "{areas:?}");
    let span = |range: Option<[f64; 2]>| range.map(|[low, high]| high - low).unwrap();
    let (one, two) = (of(&[0.127], 0.05), of(&[0.127, 0.025], 0.05));
    assert!(span(two.end_factor) < 0.6 * span(one.end_factor), "{:?} {:?}", one.end_factor, two.end_factor);
    assert!(span(two.phi_deg) < 0.8 * span(one.phi_deg), "{:?} {:?}", one.phi_deg, two.phi_deg);
    assert!(within(&two, TRUTH));
}

/// A stroke of another width is worth more than one of the same, and the search finds that.
#[test]
fn the_next_stroke_has_another_width() {
    let model = table();
    let setup = shared(&*model, strokes(&*model, &[0.127], 0.02), 0.05);
    let now = estimate(&setup).unwrap();
    let menu = StrokeMenu {
        tool_angles_deg: vec![90.0],
        depths_m: vec![0.025],
        widths_m: vec![0.127, 0.025],
        force_scatter: 0.02,
        depth_error_m: 0.0,
        force_limit_n: None,
    };
    let ranked = next_strokes(&setup, &now, &menu, &*model).unwrap();
    let areas: Vec<_> = ranked.iter().map(|c| (c.width_m, c.area_left)).collect();
    assert!(ranked[0].width_m == 0.025 && areas[0].1 < 0.9 * areas[1].1, "{areas:?}");
}

/// Shadows, volume and sections belong to one body, also where several pieces stand over a triangle: the volume is that of the
/// sections' areas along delta.
#[test]
fn the_volume_is_that_of_its_sections() {
    let model = table();
    let setup = shared(&*model, strokes(&*model, &[0.127, 0.05], 0.03), TOLERANCE);
    let volume = projections(&setup).unwrap().volume.unwrap();
    let steps = 8;
    let area = |i: usize| section(&setup, 19.0 + 2.0 * i as f64 / steps as f64).unwrap().area();
    let simpson: f64 = (0..=steps)
        .map(|i| area(i) * if i == 0 || i == steps { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 })
        .sum();
    let sections = simpson * 2.0 / steps as f64 / 3.0;
    assert!((volume / sections - 1.0).abs() < 0.01, "{volume} {sections}");
    let fit = best_fit(&setup, &estimate(&setup).unwrap()).unwrap().unwrap();
    assert!(estimate(&setup).unwrap().region.contains([fit.phi_deg, fit.density_kg_m3]));
    assert!(fit.misfit < 1e-4, "{fit:?}");
}
