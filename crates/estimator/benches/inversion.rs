//! The estimate against what one would otherwise do with the same data: least squares from one start or many, and
//! a plain grid search of the same resolution.
//!
//! Data: rained Ticino sand of Hong (2001), chapter 7, with the density unknown, the harder case. All methods run
//! on one core.

#![allow(clippy::print_stdout, reason = "what the methods found stands beside how long they took")]

use std::error::Error;
use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, SamplingMode};
use soilctl_earth_pressure::{Case, ForceModel, ModelSlice, model};
use soilctl_estimator::{Observation, Optimiser, Setup, estimate, local_minima, section, spread_starts};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2, WidthRatio, units};

/// Tool angle (deg), mean force and standard deviation (lbf).
const TICINO: [(f64, f64, f64); 4] =
    [(70.0, 0.85, 0.07), (80.0, 1.29, 0.12), (90.0, 2.01, 0.14), (100.0, 2.95, 0.07)];
const DELTA_DEG: (f64, f64) = (22.0, 24.0);
const SECTIONS_DEG: [f64; 3] = [22.0, 23.0, 24.0];

fn observations() -> Result<Vec<Observation>, Box<dyn Error>> {
    let mut observations = Vec::new();
    for (alpha_deg, force_lbf, sd_lbf) in TICINO {
        let alpha = Angle::from_degrees(alpha_deg);
        let depth_m = units::inches_to_m(1.0) * alpha.sin();
        let plate = Plate::new(alpha, Angle::ZERO, depth_m, units::inches_to_m(5.0))?;
        let [force_n, sd_n] = [force_lbf, sd_lbf].map(units::lbf_to_n);
        observations.push(Observation::new(format!("{alpha_deg} deg"), plate, force_n, sd_n)?);
    }
    Ok(observations)
}

fn estimates(criterion: &mut Criterion, setup: &Setup<'_>) -> Result<(), Box<dyn Error>> {
    estimate(setup)?;
    let mut group = criterion.benchmark_group("estimate");
    group.bench_function("union and three sections", |b| {
        b.iter(|| (estimate(black_box(setup)), SECTIONS_DEG.map(|delta| section(setup, delta))));
    });
    group.bench_function("union over delta", |b| b.iter(|| estimate(black_box(setup))));
    group.bench_function("one section", |b| b.iter(|| section(black_box(setup), 23.0)));
    let known = setup.clone().with_density(1536.0, 1664.0);
    group.bench_function("union and three sections, density known to 4 %", |b| {
        b.iter(|| (estimate(black_box(&known)), SECTIONS_DEG.map(|delta| section(&known, delta))));
    });
    group.finish();
    Ok(())
}

fn least_squares(criterion: &mut Criterion, setup: &Setup<'_>) -> Result<(), Box<dyn Error>> {
    let starts = spread_starts(setup);
    let one = &starts[starts.len() / 2..=starts.len() / 2];
    let mut group = criterion.benchmark_group("least squares");
    for (name, optimiser) in [
        ("Levenberg-Marquardt", Optimiser::LevenbergMarquardt),
        ("downhill simplex", Optimiser::DownhillSimplex),
    ] {
        let found = local_minima(setup, optimiser, &starts)?;
        let phi = |pick: fn(f64, f64) -> f64, from: f64| found.iter().map(|m| m.end.phi_deg).fold(from, pick);
        println!(
            "{name}: {} starts end at phi {:.2} to {:.2} deg",
            found.len(),
            phi(f64::min, f64::INFINITY),
            phi(f64::max, 0.0)
        );
        group.bench_function(format!("{name}, {} starts", starts.len()), |b| {
            b.iter(|| local_minima(black_box(setup), optimiser, &starts));
        });
        group.bench_function(format!("{name}, one start"), |b| {
            b.iter(|| local_minima(black_box(setup), optimiser, one));
        });
    }
    group.finish();
    Ok(())
}

/// What a grid search says: the number of consistent points and the range of phi among them in degrees.
struct Found {
    points: u64,
    phi_deg: [f64; 2],
}

/// Every (phi, delta, density) on a grid of 0.01 deg x 0.05 deg x 0.1 %, phi 38 to 48 deg, density 1000 to
/// 2100 kg/m3; the model is asked once for each (phi, delta, tool angle).
fn grid_search(
    slices: &[Box<dyn ModelSlice + '_>],
    observations: &[Observation],
) -> Result<Found, Box<dyn Error>> {
    let mut found = Found { points: 0, phi_deg: [f64::INFINITY, 0.0] };
    for i in 0..=1000 {
        let phi_deg = 38.0 + 0.01 * f64::from(i);
        for j in 0..=40 {
            let delta_deg = DELTA_DEG.0 + 0.05 * f64::from(j);
            // Force on each plate in N per kg/m3 of density.
            let mut per_density = [0.0; TICINO.len()];
            for ((force, slice), observation) in per_density.iter_mut().zip(slices).zip(observations) {
                let plate = observation.plate();
                let scale = 0.5 * STANDARD_GRAVITY_M_S2 * plate.slant_length_m().powi(2) * plate.width_m();
                *force = scale * slice.net(phi_deg, delta_deg)?.factors.weight;
            }
            let mut density_kg_m3 = 1000.0;
            while density_kg_m3 <= 2100.0 {
                let consistent = per_density.iter().zip(observations).all(|(force, observation)| {
                    let force_n = force * density_kg_m3;
                    observation.low_n() <= force_n && force_n <= observation.high_n()
                });
                if consistent {
                    found.points += 1;
                    found.phi_deg = [found.phi_deg[0].min(phi_deg), found.phi_deg[1].max(phi_deg)];
                }
                density_kg_m3 *= 1.001;
            }
        }
    }
    Ok(found)
}

fn grid(criterion: &mut Criterion, setup: &Setup<'_>) -> Result<(), Box<dyn Error>> {
    let mut slices = Vec::new();
    for observation in &setup.observations {
        slices.push(setup.model.at(
            observation.plate().tool_angle(),
            Angle::ZERO,
            WidthRatio::PLANE_STRAIN,
        )?);
    }
    // A comparison of speed means something only between methods that find the same.
    let (found, estimate) = (grid_search(&slices, &setup.observations)?, estimate(setup)?);
    let enclosing = estimate.phi_deg.ok_or("no soil is consistent")?;
    println!("estimate: phi {:.3} to {:.3} deg", enclosing[0], enclosing[1]);
    println!(
        "grid search: {} points, phi {:.2} to {:.2} deg",
        found.points, found.phi_deg[0], found.phi_deg[1]
    );
    let gap = [found.phi_deg[0] - enclosing[0], enclosing[1] - found.phi_deg[1]];
    if gap.iter().any(|gap| !(-1e-9..0.05).contains(gap)) {
        return Err(format!("the grid search and the estimate differ by {gap:?} deg").into());
    }
    let mut group = criterion.benchmark_group("grid search");
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.bench_function("0.01 deg x 0.05 deg x 0.1 %", |b| {
        b.iter(|| grid_search(black_box(&slices), &setup.observations));
    });
    group.finish();
    Ok(())
}

fn predictions(criterion: &mut Criterion) -> Result<(), Box<dyn Error>> {
    let mut group = criterion.benchmark_group("prediction");
    let case = Case::level_deg(80.0, 42.0, 23.0);
    for id in ["coulomb", "log-spiral", "chen"] {
        let model = model(id)?;
        model.predict(&case)?;
        group.bench_function(id, |b| b.iter(|| model.predict(black_box(&case))));
    }
    for (id, what) in [("thesis-ub", "one table"), ("table", "two tables")] {
        let model = model(id)?;
        let slice = model.at(case.tool_angle, case.surface_slope, case.width_ratio)?;
        slice.net(42.3, 23.4)?;
        group.bench_function(format!("look-up, {what}"), |b| {
            b.iter(|| slice.net(black_box(42.3), black_box(23.4)))
        });
    }
    group.finish();
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_secs(1))
        .measurement_time(Duration::from_secs(4))
        .configure_from_args();
    let model: Box<dyn ForceModel> = model("thesis-ub")?;
    let setup = Setup::new(&*model, observations()?, DELTA_DEG);
    estimates(&mut criterion, &setup)?;
    least_squares(&mut criterion, &setup)?;
    grid(&mut criterion, &setup)?;
    predictions(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}
