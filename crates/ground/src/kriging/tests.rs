use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;

fn uniform(random: &mut Pcg64Mcg) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

fn normal(random: &mut Pcg64Mcg) -> f64 {
    let (a, b) = (1.0 - uniform(random), uniform(random));
    libm::sqrt(-2.0 * libm::log(a)) * libm::cos(std::f64::consts::TAU * b)
}

fn random_sites(random: &mut Pcg64Mcg, count: usize) -> Vec<Site> {
    (0..count)
        .map(|_| {
            let (x_m, y_m, low) =
                (10.0 * uniform(random), 10.0 * uniform(random), 35.0 + 5.0 * uniform(random));
            Site { x_m, y_m, low, high: low + 0.5 + uniform(random) }
        })
        .collect()
}

/// Cressie's equations with the variogram and a Lagrange multiplier (3.2.12 to 3.2.16), solved as they stand.
fn by_the_textbook(sites: &[Site], length_m: f64, x_m: f64, y_m: f64) -> (Vec<f64>, f64) {
    let n = sites.len();
    let gamma = |distance: f64| 1.0 - (-distance / length_m).exp();
    let mut matrix = DMatrix::from_element(n + 1, n + 1, 1.0);
    let mut right = DVector::from_element(n + 1, 1.0);
    matrix[(n, n)] = 0.0;
    for (i, a) in sites.iter().enumerate() {
        right[i] = gamma((a.x_m - x_m).hypot(a.y_m - y_m));
        for (j, b) in sites.iter().enumerate() {
            matrix[(i, j)] = gamma((a.x_m - b.x_m).hypot(a.y_m - b.y_m));
        }
    }
    let solved = matrix.lu().solve(&right).unwrap();
    (solved.iter().take(n).copied().collect(), solved.dot(&right))
}

proptest! {
    #[test]
    fn weights_and_variance_are_those_of_the_textbook(seed in 0u64..1000, length in 0.5..40.0, x in -5.0..15.0, y in -5.0..15.0) {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let sites = random_sites(&mut random, 12);
        let system = System::new(&sites, Variogram { length_m: length, sd: 1.0 }).unwrap();
        let (weights, variance) = system.weights(&sites, x, y);
        let (expected, expected_variance) = by_the_textbook(&sites, length, x, y);
        for (found, expected) in weights.iter().zip(&expected) {
            prop_assert!((found - expected).abs() < 1e-8, "{found} {expected}");
        }
        prop_assert!((variance - expected_variance).abs() < 1e-8);
    }

    #[test]
    fn at_a_place_its_own_interval_is_left(seed in 0u64..100) {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let sites = random_sites(&mut random, 8);
        let field = Field::new(&sites, 1.96).unwrap();
        for site in &sites {
            let found = field.at(site.x_m, site.y_m);
            // The root of a variance that is 0 to 16 digits.
            prop_assert!((found.low - site.low).abs() < 1e-5 && (found.high - site.high).abs() < 1e-5, "{found:?} {site:?}");
        }
    }

    /// Leaving all places behind, what kriging errs by grows.
    #[test]
    fn uncertainty_grows_with_the_distance(seed in 0u64..100, turn in 0.0..std::f64::consts::TAU) {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let field = Field::new(&random_sites(&mut random, 8), 1.96).unwrap();
        let at = |distance: f64| field.at(5.0 + distance * turn.cos(), 5.0 + distance * turn.sin()).sd;
        let along: Vec<f64> = (0..10).map(|i| at(8.0 + 2.0 * f64::from(i))).collect();
        prop_assert!(along.windows(2).all(|pair| pair[0] <= pair[1] * (1.0 + 1e-9)), "{along:?}");
    }
}

/// Patterson and Thompson's likelihood, by contrasts that do not know the mean: for any basis of them it differs by a constant.
#[test]
fn the_restricted_likelihood_is_that_of_contrasts() {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    let sites = random_sites(&mut random, 6);
    let values = DVector::from_fn(6, |i, _| 0.5 * (sites[i].low + sites[i].high));
    let of_contrasts = |covariance: &DMatrix<f64>| {
        let contrasts = DMatrix::from_fn(5, 6, |i, j| f64::from(i == j) - f64::from(j == i + 1));
        let covariance = &contrasts * covariance * contrasts.transpose();
        let values = &contrasts * &values;
        -0.5 * covariance.determinant().ln() - 0.5 * values.dot(&covariance.lu().solve(&values).unwrap())
    };
    let differences: Vec<f64> = [0.7, 3.0, 20.0]
        .iter()
        .map(|length| {
            let covariance = correlations(&sites, *length) * 2.5 + DMatrix::identity(6, 6) * 0.3;
            of_contrasts(&covariance) - restricted_likelihood(covariance, &values).unwrap()
        })
        .collect();
    assert!(differences.iter().all(|d| (d - differences[0]).abs() < 1e-9), "{differences:?}");
}

/// Fields that are not of the covariance that is assumed: smooth hills (sums of waves), a tilted plane, and two soils with a straight border.
/// The truth is to be in the interval at 95 of 100 points; at the border of two soils it may be less.
#[test]
fn the_truth_of_other_fields_is_in_the_interval() {
    let mut random = Pcg64Mcg::seed_from_u64(11);
    let mut held = [0usize; 3];
    const FIELDS: usize = 60;
    const POINTS: usize = 10;
    for round in 0..3 * FIELDS {
        let kind = round % 3;
        let waves: Vec<[f64; 4]> = (0..6)
            .map(|_| {
                let (k, turn) =
                    (0.2 + 0.6 * uniform(&mut random), std::f64::consts::TAU * uniform(&mut random));
                [
                    k * turn.cos(),
                    k * turn.sin(),
                    std::f64::consts::TAU * uniform(&mut random),
                    normal(&mut random),
                ]
            })
            .collect();
        let value = |x: f64, y: f64| match kind {
            0 => {
                waves.iter().map(|[kx, ky, phase, size]| size * (kx * x + ky * y + phase).sin()).sum::<f64>()
            }
            1 => waves[0][0] * x + waves[0][1] * y,
            _ => {
                if x * waves[0][0] + y * waves[0][1] > 5.0 * (waves[0][0] + waves[0][1]) {
                    3.0
                } else {
                    0.0
                }
            }
        };
        let sites: Vec<Site> = (0..14)
            .map(|_| {
                let (x_m, y_m) = (10.0 * uniform(&mut random), 10.0 * uniform(&mut random));
                let width = 0.4 + uniform(&mut random);
                let low = 38.0 + value(x_m, y_m) - width * uniform(&mut random);
                Site { x_m, y_m, low, high: low + width }
            })
            .collect();
        let field = Field::new(&sites, 1.96).unwrap();
        for _ in 0..POINTS {
            let (x, y) = (1.0 + 8.0 * uniform(&mut random), 1.0 + 8.0 * uniform(&mut random));
            let truth = 38.0 + value(x, y);
            let found = field.at(x, y);
            held[kind] += usize::from(found.low <= truth && truth <= found.high);
        }
    }
    let part = held.map(|n| n as f64 / (FIELDS * POINTS) as f64);
    assert!(part.iter().all(|part| *part >= 0.95), "{part:?}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let site = |x_m: f64, low: f64, high: f64| Site { x_m, y_m: 0.0, low, high };
    let good: Vec<Site> = (0..5).map(|i| site(f64::from(i), 30.0, 31.0)).collect();
    assert!(matches!(Field::new(&good[..3], 1.96), Err(GroundError::Count { count: 3, .. })));
    let mut same = good.clone();
    same[4].x_m = 2.0;
    assert!(matches!(Field::new(&same, 1.96), Err(GroundError::SamePoint { x_m, .. }) if x_m == 2.0));
    let mut bad = good.clone();
    bad[1].high = f64::NAN;
    assert!(matches!(Field::new(&bad, 1.96), Err(GroundError::BadSite { .. })));
    // Equal middles say nothing of how far the ground varies, but intervals do.
    let field = Field::new(&good, 1.96).unwrap();
    let found = field.at(2.5, 1.0);
    assert!(found.sd > 0.0 && found.low < 30.0 && found.high > 31.0);
}
