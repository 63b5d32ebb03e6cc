//! Slides on a plane: a piece of an infinite slope, with water, and under an earthquake; and walls under one.

use soilctl_certificate::Objective;

use crate::common::soil;
use crate::grounds::{heavy, wall};
use crate::infinite::{infinite_slope, layer};
use crate::{brackets, solve};

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_layer_slides_at_the_height_of_the_infinite_slope() {
    brackets(
        "infinite slope, dry, factor on the weight",
        &solve(infinite_slope(30.0, 20.0, 0.0), 600),
        [1.0; 2],
        5e-3,
    );
    // Seepage along the slope: half of the unit weight is water's.
    let water = 0.5 * 30.0_f64.to_radians().cos();
    brackets(
        "infinite slope, seepage, factor on the weight",
        &solve(infinite_slope(30.0, 20.0, water), 600),
        [1.0; 2],
        5e-3,
    );
}

#[test]
fn a_layer_slides_at_the_acceleration_of_its_strength() {
    let (phi_deg, cohesion) = (20.0_f64, 0.1);
    let exact = cohesion + phi_deg.to_radians().tan();
    let objective = Objective::Body { gravity: [1.0, 0.0] };
    let ground = layer(heavy(soil(phi_deg, cohesion)), 1.0, exact, objective, [0.0, -1.0]);
    brackets("layer under an earthquake, critical acceleration", &solve(ground, 600), [exact; 2], 5e-3);
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_wall_before_bare_sand_under_an_earthquake_is_pushed_with_the_force_of_the_worst_wedge() {
    for acceleration in [-0.1, 0.1] {
        let wedge = worst_wedge(30.0, 0.0, acceleration);
        let ground = wall(&[(1.0, heavy(soil(30.0, 0.0)))], [acceleration, -1.0], 0.0, 1.0);
        brackets(
            &format!("smooth wall, bare sand, earthquake of {acceleration} g (worst wedge)"),
            &solve(ground, 700),
            [0.96 * wedge, wedge * (1.0 + 1e-6)],
            0.08,
        );
    }
}

/// Force on a smooth wall that is pushed, from the worst plane wedge (Mononobe and Okabe, with a surcharge): unit weight
/// and height are one, the acceleration is towards the soil if it is above zero.
fn worst_wedge(phi_deg: f64, surcharge: f64, acceleration: f64) -> f64 {
    let phi = phi_deg.to_radians();
    let most = std::f64::consts::FRAC_PI_2 - phi;
    let force = |angle: f64| {
        let weight = 0.5 / angle.tan();
        (weight + surcharge / angle.tan()) * (angle + phi).tan() - acceleration * weight
    };
    (1..10_000).map(|i| force(most * f64::from(i) / 10_000.0)).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_wall_under_an_earthquake_is_pushed_with_the_force_of_the_worst_wedge() {
    for acceleration in [-0.1, 0.1] {
        let wedge = worst_wedge(30.0, 0.2, acceleration);
        let ground = wall(&[(1.0, heavy(soil(30.0, 0.0)))], [acceleration, -1.0], 0.2, 1.0);
        // Wedges give an upper bound that is near the truth.
        brackets(
            &format!("smooth wall, surcharge, earthquake of {acceleration} g (worst wedge)"),
            &solve(ground, 700),
            [0.97 * wedge, wedge * (1.0 + 1e-6)],
            0.06,
        );
    }
}
