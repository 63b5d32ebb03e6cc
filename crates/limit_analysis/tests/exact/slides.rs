//! Slides on a plane: a piece of an infinite slope, with water, and under an earthquake; and walls under one.
//!
//! The piece of slope is in axes along and across it. Its ends carry the tractions of the infinite slope at its limit, as
//! dead loads, so the piece is at its limit too.

use soilctl_certificate::{Condition, Linear, Material, Objective, Statement};

use crate::common::{soil, statement};
use crate::grounds::{heavy, wall};
use crate::{brackets, solve};

const LENGTH: f64 = 3.0;

/// A layer of thickness one on a stronger one; on its base act a pressure and a shear stress at the limit.
fn layer(
    material: Material,
    pressure: f64,
    shear: f64,
    objective: Objective,
    gravity: [f64; 2],
) -> Statement {
    let points = [[0.0, 0.0], [0.0, -1.0], [LENGTH, -1.0], [LENGTH, 0.0], [0.0, -1.5], [LENGTH, -1.5]];
    let strong = Material { cohesion: Linear::uniform(20.0), ..material };
    // The pressure along the layer at its base, where the circle of stresses touches the limit; water adds to both.
    let along = pressure + 2.0 * shear * material.phi_deg.to_radians().tan();
    let regions: [(&[usize], Material); 2] = [(&[0, 1, 2, 3], material), (&[1, 4, 5, 2], strong)];
    let it = statement(&regions, &points, objective, |[x, y]| match () {
        () if y == 0.0 => Condition::Free,
        // Lines lead down on the left, up on the right.
        () if y > -1.0 && x == 0.0 => {
            Condition::Loaded { pressure: [0.0, along], shear: [0.0, shear], live: false }
        }
        () if y > -1.0 => Condition::Loaded { pressure: [along, 0.0], shear: [shear, 0.0], live: false },
        () => Condition::Fixed,
    });
    Statement { gravity, ..it }
}

/// An infinite slope of height one at its limit; the factor on its weight is one. Pore pressure grows with the depth.
fn infinite_slope(beta_deg: f64, phi_deg: f64, water: f64) -> Statement {
    let (sin, cos) = beta_deg.to_radians().sin_cos();
    let cohesion = sin - (cos - water) * phi_deg.to_radians().tan();
    assert!(cohesion > 0.0);
    let pore_pressure = Linear { at_origin: 0.0, gradient: [0.0, -water] };
    let material = Material { pore_pressure, ..heavy(soil(phi_deg, cohesion)) };
    layer(material, cos, sin, Objective::Body { gravity: [sin, -cos] }, [0.0, 0.0])
}

#[test]
fn a_layer_slides_at_the_height_of_the_infinite_slope() {
    brackets("dry slope", &solve(infinite_slope(30.0, 20.0, 0.0), 600), [1.0; 2], 5e-3);
    // Seepage along the slope: half of the unit weight is water's.
    let water = 0.5 * 30.0_f64.to_radians().cos();
    brackets("wet slope", &solve(infinite_slope(30.0, 20.0, water), 600), [1.0; 2], 5e-3);
}

#[test]
fn a_layer_slides_at_the_acceleration_of_its_strength() {
    let (phi_deg, cohesion) = (20.0_f64, 0.1);
    let exact = cohesion + phi_deg.to_radians().tan();
    let objective = Objective::Body { gravity: [1.0, 0.0] };
    let ground = layer(heavy(soil(phi_deg, cohesion)), 1.0, exact, objective, [0.0, -1.0]);
    brackets("earthquake", &solve(ground, 600), [exact; 2], 5e-3);
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
        brackets("wall under earthquake", &solve(ground, 700), [0.97 * wedge, wedge * (1.0 + 1e-6)], 0.06);
    }
}
