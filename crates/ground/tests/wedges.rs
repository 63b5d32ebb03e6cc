//! Wedges of layered ground, with random errors: how often ground of the kind that made the forces is excluded, and whether its friction angles are lost.
//!
//! A wedge moves as one body, so that its slip line leaves the velocity everywhere at the friction angle there: a mechanism in which what layers add is no sum
//! of local pressures. In one soil it is Coulomb's wedge.

#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::f64::consts::PI;
use std::sync::Arc;

use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;
use soilctl_earth_pressure::model;
use soilctl_ground::profile::{Asked, Coefficients, Explains, Ground, Layering, Search, Shape, Stroke};
use soilctl_soil::{Angle, WidthRatio};

const G: f64 = 9.80665;
const DELTA: f64 = 20.0;
const PHI: (f64, f64) = (26.0, 46.0);
const DENSITY: [f64; 2] = [1300.0, 1800.0];
const ANGLES: [f64; 3] = [55.0, 70.0, 80.0];
const DEPTHS_M: [f64; 4] = [0.02, 0.035, 0.055, 0.08];

/// Force per width of the wedge with a velocity at `omega`; passive with sign 1, active with -1.
fn wedge_n(soil: &dyn Fn(f64) -> [f64; 2], alpha: f64, depth_m: f64, omega: f64, sign: f64) -> Option<f64> {
    const SLICES: usize = 80;
    let plate = if sign > 0.0 { alpha.to_radians() } else { PI - alpha.to_radians() };
    let delta = DELTA.to_radians();
    let step = depth_m / SLICES as f64;
    let (mut ahead, mut mass) = (0.0, 0.0);
    for i in (0..SLICES).rev() {
        let z = (i as f64 + 0.5) * step;
        let [phi, density] = soil(z);
        let rise = omega - sign * phi.to_radians();
        if rise <= 0.02 || rise >= PI - plate - 1e-3 {
            return None;
        }
        let run = step / rise.tan();
        let width = ahead + 0.5 * run + (depth_m - z) / plate.tan();
        if width <= 0.0 {
            return None;
        }
        mass += density * width * step;
        ahead += run;
    }
    let push = [
        plate.sin() * delta.cos() + sign * plate.cos() * delta.sin(),
        plate.cos() * delta.cos() - sign * plate.sin() * delta.sin(),
    ];
    let power = push[0] * omega.cos() + push[1] * omega.sin();
    (power > 1e-6).then(|| G * mass * omega.sin() / power)
}

/// Passive minus active force per width, each of its best velocity.
fn force_n(soil: &dyn Fn(f64) -> [f64; 2], alpha: f64, depth_m: f64) -> f64 {
    let best = |sign: f64| {
        let value =
            |omega: f64| wedge_n(soil, alpha, depth_m, omega, sign).map_or(f64::INFINITY, |f| sign * f);
        let (mut at, mut reach) = (0.5 * PI, 0.5 * PI);
        for _ in 0..6 {
            let all = (-20..=20).map(|i| at + reach * f64::from(i) / 20.0).filter(|o| *o > 0.0 && *o < PI);
            at = all.min_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap();
            reach *= 0.1;
        }
        sign * value(at)
    };
    best(1.0) - best(-1.0)
}

fn uniform(random: &mut Pcg64Mcg, low: f64, high: f64) -> f64 {
    low + (high - low) * ((random.next_u64() >> 11) as f64 / (1u64 << 53) as f64)
}

fn normal(random: &mut Pcg64Mcg) -> f64 {
    let (a, b) = (1.0 - uniform(random, 0.0, 1.0), uniform(random, 0.0, 1.0));
    (-2.0 * a.ln()).sqrt() * (2.0 * PI * b).cos()
}

/// In one soil the wedge is Coulomb's.
#[test]
fn in_one_soil_it_is_coulombs_wedge() {
    let coulomb = model("coulomb").unwrap();
    for alpha in ANGLES {
        let slice = coulomb.at(Angle::from_degrees(alpha), Angle::ZERO, WidthRatio::PLANE_STRAIN).unwrap();
        let k = slice.net(36.0, DELTA).unwrap().weight_lower;
        let slant = 0.05 / alpha.to_radians().sin();
        let exact = 0.5 * G * 1500.0 * slant * slant * k;
        assert!((force_n(&|_| [36.0, 1500.0], alpha, 0.05) / exact - 1.0).abs() < 1e-3);
    }
}

/// With bands that all hold together in 95 % of cases (12 of 2 % each, by Šidák 2.86 deviations), the kind that made the forces is excluded in 5 % of grounds at
/// most; its friction angles are in the ranges unless a band is missed; and of one soil changes are not claimed.
#[test]
fn the_kind_that_made_the_forces_is_hardly_ever_excluded() {
    const GROUNDS: usize = 16;
    let coulomb = model("coulomb").unwrap();
    let coefficients: Vec<Arc<Coefficients>> = ANGLES
        .iter()
        .map(|alpha| {
            let slice =
                coulomb.at(Angle::from_degrees(*alpha), Angle::ZERO, WidthRatio::PLANE_STRAIN).unwrap();
            Arc::new(Coefficients::of(&*slice, PHI, (19.0, 21.0)).unwrap())
        })
        .collect();
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let to_m = DEPTHS_M[3];
    let (mut wrong, mut told) = (0, 0);
    for shape in [Shape::Uniform, Shape::Gradient { to_m }, Shape::Step] {
        for _ in 0..GROUNDS {
            let draw = |random: &mut Pcg64Mcg| [uniform(random, 32.0, 41.0), uniform(random, 1400.0, 1700.0)];
            let (top, below) = (draw(&mut random), draw(&mut random));
            let bottom = if shape == Shape::Uniform { top } else { below };
            let step_m = uniform(&mut random, 0.02, 0.06);
            let soil = move |z: f64| match shape {
                Shape::Uniform => top,
                Shape::Gradient { to_m } => [0, 1].map(|i| top[i] + (bottom[i] - top[i]) * z / to_m),
                Shape::Step => {
                    if z < step_m {
                        top
                    } else {
                        bottom
                    }
                }
            };
            let mut missed = false;
            let mut strokes = Vec::new();
            for (alpha, coefficients) in ANGLES.iter().zip(&coefficients) {
                for depth_m in DEPTHS_M {
                    let off = 0.02 * normal(&mut random);
                    missed |= off.abs() > 0.02 * 2.86;
                    let read = force_n(&soil, *alpha, depth_m) * off.exp();
                    strokes.push(Stroke {
                        depth_m,
                        unit_n: G * (depth_m / alpha.to_radians().sin()).powi(2),
                        force_n: [-2.86, 2.86].map(|d: f64| read * (0.02 * d).exp()),
                        end_tolerance: 0.0,
                        layering: Layering::at(*alpha).unwrap(),
                        coefficients: Arc::clone(coefficients),
                    });
                }
            }
            let search = |shape| Search {
                shape,
                strokes: &strokes,
                start: Ground {
                    phi_deg: [[PHI.0, PHI.1]; 2],
                    delta_deg: [19.0, 21.0],
                    ends: [0.0; 2],
                    step_m: [0.014, 0.076],
                },
                density_kg_m3: DENSITY,
                budget: 1500,
            };
            let found = search(shape).ranges(&[Asked::Friction(0.0), Asked::Friction(1.0)]);
            if found.explains == Explains::No {
                wrong += 1;
                continue;
            }
            if !missed {
                for (value, [low, high]) in [top[0], bottom[0]].into_iter().zip(&found.ranges) {
                    assert!(*low <= value && value <= *high, "{shape:?}: {value} not in {low} to {high}");
                }
            }
            if shape != Shape::Uniform && search(Shape::Uniform).explains() == Explains::No {
                told += 1;
            }
        }
    }
    println!("{wrong} of {} excluded, change told in {told} of {}", 3 * GROUNDS, 2 * GROUNDS);
    assert!(wrong <= 5, "{wrong}");
    assert!(told >= GROUNDS / 2, "{told}");
}
