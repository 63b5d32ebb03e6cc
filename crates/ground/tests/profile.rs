//! Ground that changes with depth: no ground that explains the strokes is lost, against brute force with sums of local pressures written anew, and against
//! wedges of layered ground, a mechanism of another form.

#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::sync::Arc;

use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;
use soilctl_earth_pressure::{ForceModel, model};
use soilctl_ground::profile::{Asked, Coefficients, Explains, Ground, Layering, Search, Shape, Stroke};
use soilctl_soil::{Angle, WidthRatio};

const G: f64 = 9.80665;
const WIDTH_M: f64 = 0.1;
const PHI: (f64, f64) = (25.0, 48.0);
const DELTA: (f64, f64) = (18.0, 20.0);
const DENSITY: [f64; 2] = [1300.0, 1800.0];
const DEEPEST_M: f64 = 0.08;
const PLATES: [(f64, f64); 6] =
    [(50.0, 0.03), (50.0, 0.05), (50.0, 0.08), (75.0, 0.03), (75.0, 0.05), (75.0, 0.08)];

/// A ground: friction angles at top and bottom, densities, the depth of a step.
#[derive(Debug, Clone, Copy)]
struct Truth {
    phi: [f64; 2],
    density: [f64; 2],
    step_m: f64,
    delta: f64,
}

struct Setting {
    coulomb: Box<dyn ForceModel>,
    coefficients: Vec<Arc<Coefficients>>,
}

impl Setting {
    fn new() -> Self {
        let coulomb = model("coulomb").unwrap();
        let coefficients = PLATES
            .iter()
            .map(|(alpha, _)| {
                let slice =
                    coulomb.at(Angle::from_degrees(*alpha), Angle::ZERO, WidthRatio::PLANE_STRAIN).unwrap();
                Arc::new(Coefficients::of(&*slice, PHI, DELTA).unwrap())
            })
            .collect();
        Self { coulomb, coefficients }
    }

    /// The force in N by local pressures, summed in a thousand slices.
    fn force_n(&self, shape: Shape, truth: &Truth, place: usize) -> f64 {
        const SLICES: usize = 1000;
        let (alpha, depth_m) = PLATES[place];
        let slice =
            self.coulomb.at(Angle::from_degrees(alpha), Angle::ZERO, WidthRatio::PLANE_STRAIN).unwrap();
        let at = |of: [f64; 2], z: f64| match shape {
            Shape::Uniform => of[0],
            Shape::Gradient { to_m } => of[0] + (of[1] - of[0]) * z / to_m,
            Shape::Step => of[usize::from(z > truth.step_m)],
        };
        let k = |phi: f64| slice.net(phi, truth.delta).unwrap().weight_lower;
        let of_step = [k(truth.phi[0]), k(truth.phi[1])];
        let dz = depth_m / SLICES as f64;
        let (mut above, mut sum) = (0.0, 0.0);
        for i in 0..SLICES {
            let z = (i as f64 + 0.5) * dz;
            let own = G * at(truth.density, z) * dz;
            let k = match shape {
                Shape::Gradient { .. } => k(at(truth.phi, z)),
                Shape::Uniform | Shape::Step => at(of_step, z),
            };
            sum += (above + 0.5 * own) * k * dz;
            above += own;
        }
        sum * WIDTH_M / alpha.to_radians().sin().powi(2)
    }

    fn strokes(&self, forces_n: &[f64], share: f64) -> Vec<Stroke> {
        (PLATES.iter().zip(forces_n).zip(&self.coefficients))
            .map(|(((alpha, depth_m), force_n), coefficients)| Stroke {
                depth_m: *depth_m,
                unit_n: G * WIDTH_M * (depth_m / alpha.to_radians().sin()).powi(2),
                force_n: [force_n * (1.0 - share), force_n * (1.0 + share)],
                end_tolerance: 0.0,
                layering: Layering::at(*alpha).unwrap(),
                coefficients: Arc::clone(coefficients),
            })
            .collect()
    }
}

fn search(shape: Shape, strokes: &[Stroke]) -> Search<'_> {
    let start = Ground {
        phi_deg: [[PHI.0, PHI.1]; 2],
        delta_deg: [DELTA.0, DELTA.1],
        ends: [0.0; 2],
        step_m: [0.02, 0.075],
    };
    Search { shape, strokes, start, density_kg_m3: DENSITY, budget: 3000 }
}

const GRADIENT: Shape = Shape::Gradient { to_m: DEEPEST_M };

fn uniform(random: &mut Pcg64Mcg, low: f64, high: f64) -> f64 {
    low + (high - low) * (random.next_u32() as f64 / f64::from(u32::MAX))
}

fn any_ground(random: &mut Pcg64Mcg, shape: Shape) -> Truth {
    let phi = [uniform(random, 30.0, 42.0), uniform(random, 30.0, 42.0)];
    let density = [uniform(random, 1350.0, 1750.0), uniform(random, 1350.0, 1750.0)];
    let of_one = shape == Shape::Uniform;
    Truth {
        phi: if of_one { [phi[0]; 2] } else { phi },
        density: if of_one { [density[0]; 2] } else { density },
        step_m: uniform(random, 0.025, 0.07),
        delta: uniform(random, DELTA.0, DELTA.1),
    }
}

/// Grounds whose forces by slices lie in all bands lie in all ranges, and the shape that made the forces is never excluded.
#[test]
fn no_ground_that_explains_the_strokes_is_lost() {
    let setting = Setting::new();
    let mut random = Pcg64Mcg::seed_from_u64(7);
    for shape in [Shape::Uniform, GRADIENT, Shape::Step] {
        for _ in 0..3 {
            let truth = any_ground(&mut random, shape);
            let forces: Vec<f64> = (0..PLATES.len()).map(|i| setting.force_n(shape, &truth, i)).collect();
            let off: Vec<f64> = forces.iter().map(|f| f * uniform(&mut random, 0.965, 1.035)).collect();
            let strokes = setting.strokes(&off, 0.04);
            let asked = [
                Asked::Friction(0.0),
                Asked::Friction(1.0),
                Asked::Density(0.0),
                Asked::Density(1.0),
                Asked::FrictionGrowth,
                Asked::LogForce(strokes[1].clone()),
            ];
            let found = search(shape, &strokes).ranges(&asked);
            assert_ne!(found.explains, Explains::No, "{truth:?}");
            let check = |t: &Truth, force_n: f64| {
                let of = [t.phi[0], t.phi[1], t.density[0], t.density[1], t.phi[1] - t.phi[0], force_n.ln()];
                for (value, [low, high]) in of.into_iter().zip(&found.ranges) {
                    assert!(*low <= value && value <= *high, "{value} not in {low} to {high}: {t:?}");
                }
            };
            check(&truth, forces[1]);
            // Others beside it.
            let mut explained = 0;
            for _ in 0..60 {
                let mut near = truth;
                let one = shape == Shape::Uniform;
                for end in 0..2 {
                    near.phi[end] += uniform(&mut random, -1.5, 1.5);
                    near.density[end] *= uniform(&mut random, 0.93, 1.07);
                }
                if one {
                    (near.phi[1], near.density[1]) = (near.phi[0], near.density[0]);
                }
                if !near.density.iter().all(|d| (DENSITY[0]..=DENSITY[1]).contains(d)) {
                    continue;
                }
                let of: Vec<f64> = (0..PLATES.len()).map(|i| setting.force_n(shape, &near, i)).collect();
                if of.iter().zip(&strokes).all(|(f, s)| (s.force_n[0]..=s.force_n[1]).contains(f)) {
                    explained += 1;
                    check(&near, of[1]);
                }
            }
            assert!(explained > 0, "{truth:?}");
        }
    }
}

/// Ground with a step of 7 deg is not one soil; and one soil is a gradient and a step without change.
#[test]
fn what_is_excluded_and_what_is_not() {
    let setting = Setting::new();
    let forces = |shape, truth: &Truth| -> Vec<f64> {
        (0..PLATES.len()).map(|i| setting.force_n(shape, truth, i)).collect()
    };
    let truth = Truth { phi: [33.0, 40.0], density: [1500.0; 2], step_m: 0.035, delta: 19.0 };
    let strokes = setting.strokes(&forces(Shape::Step, &truth), 0.03);
    assert_eq!(search(Shape::Uniform, &strokes).explains(), Explains::No);
    assert_eq!(search(Shape::Step, &strokes).explains(), Explains::Yes);
    let one = Truth { phi: [36.0; 2], density: [1500.0; 2], ..truth };
    let strokes = setting.strokes(&forces(Shape::Uniform, &one), 0.02);
    for shape in [Shape::Uniform, GRADIENT, Shape::Step] {
        assert_eq!(search(shape, &strokes).explains(), Explains::Yes, "{shape:?}");
    }
}

/// The end of the budget makes ranges wider, never narrower.
#[test]
fn a_smaller_budget_loses_nothing() {
    let setting = Setting::new();
    let truth = Truth { phi: [34.0, 39.0], density: [1450.0, 1600.0], step_m: 0.04, delta: 19.0 };
    let forces: Vec<f64> = (0..PLATES.len()).map(|i| setting.force_n(GRADIENT, &truth, i)).collect();
    let strokes = setting.strokes(&forces, 0.03);
    let asked = [Asked::Friction(0.0), Asked::Friction(1.0), Asked::Density(0.5)];
    let sharp = search(GRADIENT, &strokes).ranges(&asked);
    for budget in [0, 20, 200] {
        let soon = Search { budget, ..search(GRADIENT, &strokes) }.ranges(&asked);
        for (wide, [low, high]) in soon.ranges.iter().zip(&sharp.ranges) {
            // What ends a search early may be told to its tolerance.
            assert!(
                wide[0] <= low + 25.0 * f64::from(*low > 100.0) + 0.3
                    && wide[1] >= high - 25.0 * f64::from(*high > 100.0) - 0.3
            );
        }
    }
}
