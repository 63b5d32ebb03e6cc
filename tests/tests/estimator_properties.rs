//! What the estimator promises: the truth is inside, areas are right, verdicts name what conflicts.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_earth_pressure::table::{PredictionTable, TableModel};
use soilctl_earth_pressure::{Case, ChenLiu, ForceModel, MODEL_IDS, model};
use soilctl_estimator::{
    Observation, Optimiser, Setup, StrokeMenu, agreement_factor, best_fit, conflict, estimate,
    exact_estimate, local_minima, next_strokes, projections, section, spread_starts,
};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2, WidthRatio};
use soilctl_tests::Random;

#[derive(Clone, Copy)]
struct Truth {
    phi: f64,
    delta: f64,
    density: f64,
}

fn plate(alpha: f64, depth: f64) -> Plate {
    Plate::new(Angle::from_degrees(alpha), Angle::ZERO, depth, 0.127).unwrap()
}

/// True force, with the plate's ends where the model knows them; for a bracket at the given fraction of its logarithmic width.
fn force(model: &dyn ForceModel, truth: Truth, plate: &Plate, fraction: f64) -> Option<f64> {
    let mut case = Case::level_deg(plate.tool_angle().degrees(), truth.phi, truth.delta);
    if model.has_ends() {
        case = case.with_width_ratio(plate.width_ratio());
    }
    let p = model.predict(&case).ok()?;
    let k = p.net_lower.0.powf(1.0 - fraction) * p.net_upper.0.powf(fraction);
    let (l, w) = (plate.slant_length_m(), plate.width_m());
    Some(0.5 * truth.density * STANDARD_GRAVITY_M_S2 * l * l * w * k)
}

/// 1,000 soils and stroke sets, errors inside their stated bounds (a tenth of them exactly on the bound): the truth
/// is in the region every time, whatever the model, and for the bracket wherever in it the true force lies.
#[test]
fn the_truth_is_inside_every_time() {
    let mut random = Random(20_011_107);
    let covers =
        |m: &dyn ForceModel| m.valid_range().alpha_deg.0 <= 70.0 && m.valid_range().alpha_deg.1 >= 100.0;
    let models: Vec<_> =
        MODEL_IDS.iter().map(|id| model(id).unwrap()).filter(|m| !m.is_slow() && covers(&**m)).collect();
    let quick = ["coulomb", "caquot", "thesis-ub", "thesis-lb", "table"].map(|id| model(id).unwrap());
    let mut done = 0;
    while done < 1000 {
        // The models that search for every force are dear; they get a share, the others the rest.
        let model =
            if done % 5 == 0 { &*models[done / 5 % models.len()] } else { &*quick[done % quick.len()] };
        let phi = random.between(26.0, 49.0);
        let delta = random.between(0.0, 29.0_f64.min(phi));
        let truth = Truth { phi, delta, density: random.between(1100.0, 2100.0) };
        let half_width = random.between(0.002, 0.15);
        let count = 1 + (random.unit() * 5.0) as usize;
        let observations: Option<Vec<Observation>> = (0..count)
            .map(|i| {
                let plate = plate(random.between(70.0, 100.0), random.between(0.012, 0.05));
                let force = force(model, truth, &plate, random.unit())?;
                let error = if random.unit() < 0.1 { 1.0 } else { random.between(-1.0, 1.0) };
                let measured = force / (1.0 + error * half_width);
                Some(Observation::new(format!("{i}"), plate, measured, half_width * measured).unwrap())
            })
            .collect();
        let Some(observations) = observations else { continue };
        let tolerance = random.between(0.0, 2.0);
        let known = (delta + tolerance * random.between(-1.0, 1.0)).clamp(0.0, 29.0);
        let interval = ((known - tolerance).max(0.0), (known + tolerance).min(30.0));
        let setup = Setup::new(model, observations, interval);
        let found = estimate(&setup).unwrap();
        assert!(
            found.region.contains([truth.phi, truth.density]),
            "{}: phi {phi}, delta {delta}, density {} not in the region of {setup_delta:?}",
            model.id(),
            truth.density,
            setup_delta = setup.delta_deg
        );
        done += 1;
    }
}

fn four_strokes(model: &dyn ForceModel, truth: Truth, relative: f64) -> Vec<Observation> {
    [70.0, 80.0, 90.0, 100.0]
        .into_iter()
        .map(|alpha| {
            let plate = plate(alpha, 0.0254 * alpha.to_radians().sin());
            let force = force(model, truth, &plate, 0.5).unwrap();
            Observation::new(format!("{alpha} deg"), plate, force, relative * force).unwrap()
        })
        .collect()
}

const TRUTH: Truth = Truth { phi: 38.0, delta: 23.0, density: 1500.0 };

/// Area of the union over delta against counting a fine grid by definition: a (phi, density) is consistent if
/// some delta makes every predicted force lie in its interval. Forces are monotone in delta, so for each point and
/// measurement the admissible deltas are an interval, found by bisection: nothing of the estimator is reused.
#[test]
fn area_against_dense_sampling() {
    for (id, relative, interval) in [("thesis-ub", 0.08, (22.0, 24.0)), ("coulomb", 0.03, (22.0, 24.0))] {
        let model = model(id).unwrap();
        let setup = Setup::new(&*model, four_strokes(&*model, TRUTH, relative), interval);
        let region = estimate(&setup).unwrap().region;
        let ([p0, p1], _) = region.bounds().unwrap();
        let slices: Vec<_> = setup
            .observations
            .iter()
            .map(|o| model.at(o.plate().tool_angle(), Angle::ZERO, WidthRatio::PLANE_STRAIN).unwrap())
            .collect();
        let (columns, steps) = (700, 160);
        let mut area = 0.0;
        for i in 0..columns {
            let phi = p0 + (p1 - p0) * (f64::from(i) + 0.5) / f64::from(columns);
            // Densities consistent at each delta of a fine ladder; between rungs bounds move linearly.
            let rung = |j: i32| {
                let delta = interval.0 + (interval.1 - interval.0) * f64::from(j) / f64::from(steps);
                let mut range = (0.0_f64, f64::INFINITY);
                for (o, slice) in setup.observations.iter().zip(&slices) {
                    let k = slice.net(phi, delta).unwrap().weight_upper;
                    let scale = 0.5 * STANDARD_GRAVITY_M_S2 * o.plate().slant_length_m().powi(2) * 0.127 * k;
                    range = (range.0.max(o.low_n() / scale), range.1.min(o.high_n() / scale));
                }
                range
            };
            let rungs: Vec<_> = (0..=steps).map(rung).collect();
            // Union over the ladder; neighbours overlap where both are not empty. Where consistency begins or ends
            // between two rungs, the end is where the bounds meet.
            let mut inside: Vec<_> = rungs.iter().copied().filter(|r| r.0 <= r.1).collect();
            for w in rungs.windows(2) {
                let (a, b) = (w[0].1 - w[0].0, w[1].1 - w[1].0);
                if (a < 0.0) != (b < 0.0) {
                    let meet = w[0].0 + a / (a - b) * (w[1].0 - w[0].0);
                    inside.push((meet, meet));
                }
            }
            let low = inside.iter().map(|r| r.0).fold(f64::INFINITY, f64::min);
            let high = inside.iter().map(|r| r.1).fold(f64::NEG_INFINITY, f64::max);
            if low < high {
                area += (high - low) * (p1 - p0) / f64::from(columns);
            }
        }
        let error = (region.area() / area - 1.0).abs();
        assert!(error < 0.002, "{id}: {} against {area}, {error}", region.area());
    }
}

/// Projections, volume and sections belong to the same body.
#[test]
fn projections_and_volume_agree() {
    let model = model("thesis-ub").unwrap();
    let setup = Setup::new(&*model, four_strokes(&*model, TRUTH, 0.08), (22.0, 24.0));
    let found = estimate(&setup).unwrap();
    let (phi, density) = found.region.bounds().unwrap();
    let other = projections(&setup).unwrap();
    let (phi_again, delta) = other.phi_delta.bounds().unwrap();
    let (delta_again, density_again) = other.delta_density.bounds().unwrap();
    for (a, b) in [(phi, phi_again), (delta, delta_again), (delta, [22.0, 24.0])] {
        assert!((a[0] - b[0]).abs() < 1e-4 && (a[1] - b[1]).abs() < 1e-4, "{a:?} {b:?}");
    }
    assert!((density[0] - density_again[0]).abs() < 0.01 && (density[1] - density_again[1]).abs() < 0.01);
    // Simpson over sections.
    let area = |d: f64| section(&setup, d).unwrap().area();
    let volume = (area(22.0) + 4.0 * area(22.5) + 2.0 * area(23.0) + 4.0 * area(23.5) + area(24.0)) / 6.0;
    let told = other.volume.unwrap();
    assert!((told / volume - 1.0).abs() < 0.005, "{told} {volume}");
}

#[test]
fn the_measurement_that_breaks_consistency_is_named() {
    let model = model("thesis-ub").unwrap();
    let mut observations = four_strokes(&*model, TRUTH, 0.03);
    let spoilt = &observations[2];
    observations[2] =
        Observation::new("90 deg", *spoilt.plate(), 1.4 * spoilt.force_n(), 0.04 * spoilt.force_n()).unwrap();
    let setup = Setup::new(&*model, observations, (22.0, 24.0)).with_density(1440.0, 1560.0);
    assert!(!estimate(&setup).unwrap().is_consistent());
    let found = conflict(&setup).unwrap();
    assert_eq!(found.culprits, [2]);
    assert!(found.pairs.iter().all(|&(a, b)| a == 2 || b == 2) && !found.pairs.is_empty());
    let factor = agreement_factor(&setup).unwrap().unwrap();
    let scaled = |f: f64| {
        let mut s = setup.clone();
        s.observations = s.observations.iter().map(|o| o.scaled(f)).collect();
        estimate(&s).unwrap().is_consistent()
    };
    assert!(factor > 1.0 && scaled(1.02 * factor) && !scaled(0.97 * factor), "{factor}");
}

#[test]
fn exact_data_give_the_soil_back() {
    let model = model("chen").unwrap();
    let setup = Setup::new(&*model, four_strokes(&*model, TRUTH, 0.0), (18.0, 28.0));
    let found = exact_estimate(&setup).unwrap().unwrap();
    let centre = found.ellipse.unwrap().centre;
    assert_eq!(found.intersections.len(), 6);
    assert!((found.delta_deg - 23.0).abs() < 0.1, "{}", found.delta_deg);
    assert!((centre[0] - 38.0).abs() < 0.1 && (centre[1] - 1500.0).abs() < 10.0, "{centre:?}");
}

#[test]
fn the_best_fit_is_inside_and_no_worse_than_the_truth() {
    let model = model("thesis-ub").unwrap();
    let setup = Setup::new(&*model, four_strokes(&*model, TRUTH, 0.05), (22.0, 24.0));
    let found = estimate(&setup).unwrap();
    let fit = best_fit(&setup, &found).unwrap().unwrap();
    assert!(found.region.contains([fit.phi_deg, fit.density_kg_m3]));
    assert!(fit.misfit < 1e-6, "{}", fit.misfit);
}

/// Section 7.4: with delta free and a few per cent of noise, local optimisers end in different soils.
#[test]
fn plain_optimisation_has_several_answers() {
    let model = model("thesis-ub").unwrap();
    let mut observations = four_strokes(&*model, TRUTH, 0.05);
    for (o, noise) in observations.iter_mut().zip([1.04, 0.97, 0.96, 1.03]) {
        *o = Observation::new(o.label().to_owned(), *o.plate(), noise * o.force_n(), 0.05 * o.force_n())
            .unwrap();
    }
    let setup = Setup::new(&*model, observations, (10.0, 30.0));
    for optimiser in [Optimiser::DownhillSimplex, Optimiser::LevenbergMarquardt] {
        let ends: Vec<_> =
            local_minima(&setup, optimiser, &spread_starts(&setup)).unwrap().iter().map(|m| m.end).collect();
        assert_eq!(ends.len(), 27);
        let spread = |f: &dyn Fn(&soilctl_estimator::Fit) -> f64| {
            let good: Vec<f64> = ends.iter().filter(|e| e.misfit < 0.02).map(f).collect();
            good.iter().copied().fold(f64::MIN, f64::max) - good.iter().copied().fold(f64::MAX, f64::min)
        };
        assert!(spread(&|e| e.phi_deg) > 1.0 && spread(&|e| e.density_kg_m3) > 100.0);
    }
}

/// The thesis found by hand that a stroke at 40 deg pins the density.
#[test]
fn the_next_stroke_is_a_flat_one() {
    let model = model("chen").unwrap();
    let setup = Setup::new(&*model, four_strokes(&*model, TRUTH, 0.06), (22.0, 24.0));
    let now = estimate(&setup).unwrap();
    let menu = StrokeMenu {
        tool_angles_deg: vec![40.0, 55.0, 70.0, 85.0, 100.0],
        depths_m: vec![0.02],
        widths_m: vec![0.127],
        force_scatter: 0.06,
        depth_error_m: 0.0005,
        force_limit_n: None,
    };
    let ranked = next_strokes(&setup, &now, &menu, &ChenLiu).unwrap();
    assert_eq!(ranked[0].alpha_deg, 40.0);
    assert!(ranked.iter().all(|c| c.area_left <= 1.0 + 1e-3));
    assert!(ranked[0].density_width_kg_m3 < 0.8 * ranked.last().unwrap().density_width_kg_m3);
    let limited =
        next_strokes(&setup, &now, &StrokeMenu { force_limit_n: Some(2.0), ..menu }, &ChenLiu).unwrap();
    assert!(limited.iter().all(|c| c.force_n <= 2.0));
}

/// Same input, same bits.
#[test]
fn estimates_are_deterministic() {
    let model = model("thesis-ub").unwrap();
    let setup = Setup::new(&*model, four_strokes(&*model, TRUTH, 0.05), (22.0, 24.0));
    let runs: Vec<_> = (0..3).map(|_| format!("{:?}", estimate(&setup).unwrap())).collect();
    assert!(runs.windows(2).all(|w| w[0] == w[1]));
}

#[test]
fn nonsense_is_refused() {
    let model = model("thesis-ub").unwrap();
    let good = four_strokes(&*model, TRUTH, 0.05);
    assert!(estimate(&Setup::new(&*model, vec![], (22.0, 24.0))).is_err());
    for interval in [(24.0, 22.0), (-1.0, 3.0), (28.0, 31.0), (f64::NAN, 3.0)] {
        assert!(estimate(&Setup::new(&*model, good.clone(), interval)).is_err(), "{interval:?}");
    }
    assert!(
        estimate(&Setup::new(&*model, good.clone(), (22., 24.)).with_density(1600.0, f64::INFINITY)).is_err()
    );
    let steep = Observation::new("110 deg", plate(110.0, 0.02), 5.0, 0.5).unwrap();
    let error = estimate(&Setup::new(&*model, vec![steep], (22., 24.))).unwrap_err().to_string();
    assert!(error.contains("110 deg") && error.contains("70 to 100"), "{error}");
    assert!(Observation::new("x", plate(90.0, 0.02), -1.0, 0.1).is_err());
    assert!(Observation::new("x", plate(90.0, 0.02), 1.0, f64::NAN).is_err());
}

/// A table whose range does not fall on the estimator's lattice, and a soil at its very edge, as rough as can be.
#[test]
fn nothing_is_lost_at_the_edge_of_a_table() {
    let axes = [vec![70.0, 85.0, 100.0], vec![30.3, 35.1, 40.7], vec![0.0, 10.03, 20.0, 30.299]];
    let table = PredictionTable::fill(&ChenLiu, axes).unwrap();
    let model = TableModel::new("odd", "a table off the lattice", table);
    for (phi, delta) in [(30.3, 30.299), (30.3001, 30.299), (40.7, 30.2989), (40.6999, 3.0), (30.3, 0.0)] {
        let truth = Truth { phi, delta, density: 1500.0 };
        for interval in [(delta, delta), ((delta - 0.5_f64).max(0.0), delta)] {
            let setup = Setup::new(&model, four_strokes(&model, truth, 0.02), interval);
            let region = estimate(&setup).unwrap().region;
            // The point itself lies on the rim; a hair inside must be in.
            let inwards = if phi > 35.0 { phi - 1e-4 } else { phi + 1e-4 };
            assert!(
                region.contains([inwards, 1500.0]),
                "phi {phi}, delta {interval:?}: {:?}",
                region.bounds()
            );
        }
    }
}
