//! How fast bounds converge.
//!
//! On adaptive meshes the edge length is that of equal elements: `h^2` goes with one over their number.

use soilctl_certificate::Statement;

use crate::common::soil;
use crate::grounds::{footing, heavy, slope, strip};
use crate::{prandtl, solve};

/// The power of `h` with which errors fall, by least squares through all levels.
fn order(points: &[(usize, f64)]) -> f64 {
    let logs: Vec<[f64; 2]> = points.iter().map(|(n, e)| [-0.5 * (*n as f64).ln(), e.ln()]).collect();
    let count = logs.len() as f64;
    let mean = [0, 1].map(|i| logs.iter().map(|l| l[i]).sum::<f64>() / count);
    let sum = |i: usize, j: usize| logs.iter().map(|l| (l[i] - mean[i]) * (l[j] - mean[j])).sum::<f64>();
    sum(0, 1) / sum(0, 0)
}

/// Orders of the lower and the upper bound.
fn orders(name: &str, statement: Statement, exact: f64, elements: usize) -> [f64; 2] {
    let bounds = solve(statement, elements);
    let errors =
        |proven: Option<(usize, f64)>, sign: f64| proven.map(|(n, v)| (n, sign * (v - exact) / exact));
    let lower: Vec<(usize, f64)> = bounds
        .levels
        .iter()
        .filter_map(|l| errors(l.lower.and_then(|s| Some((s.elements, s.proven?))), -1.0))
        .collect();
    let upper: Vec<(usize, f64)> = bounds
        .levels
        .iter()
        .filter_map(|l| errors(l.upper.proven.map(|v| (l.upper.elements, v)), 1.0))
        .collect();
    assert!(lower.len() > 1 && upper.len() > 1);
    let orders = [order(&lower), order(&upper)];
    println!("{name}: orders {orders:.2?}, {lower:.4?}, {upper:.4?}");
    orders
}

#[test]
fn bounds_of_a_strip_on_clay_converge() {
    let exact = 2.0 + std::f64::consts::PI;
    let [lower, upper] = orders("Nc 0", strip(soil(0.0, 1.0), 0.0, [4.0, 2.0]), exact, 1000);
    assert!(lower > 1.0 && upper > 1.0);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_problems_converge_at_more_than_first_order() {
    let problems = [
        ("Nc 0", strip(soil(0.0, 1.0), 0.0, [4.0, 2.0]), 2.0 + std::f64::consts::PI),
        ("Nq 30", strip(soil(30.0, 0.0), 1.0, [8.0, 4.0]), prandtl::nq(30.0)),
        ("N_gamma 30", footing(heavy(soil(30.0, 0.0)), 30.0, 0.0, [8.0, 4.0]), 14.754_3),
        ("cut", slope(soil(0.0, 1.0), 90.0), 3.777),
    ];
    for (name, statement, exact) in problems {
        let [lower, upper] = orders(name, statement, exact, 4000);
        assert!(lower > 1.0 && upper > 1.0, "{name}: {lower} {upper}");
    }
}
