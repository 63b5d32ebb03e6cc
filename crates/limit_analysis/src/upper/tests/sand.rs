//! Soil with friction.

use std::f64::consts::{FRAC_PI_4, PI};

use soilctl_certificate::{Condition, Linear, Objective};

use super::grounds::{footing, pressed, slope, soil};
use super::{bounds, near_from_above};

/// Prandtl's factor on surcharge.
fn surcharge_factor(phi_deg: f64) -> f64 {
    let phi = phi_deg.to_radians();
    (PI * phi.tan()).exp() * (FRAC_PI_4 + phi / 2.0).tan().powi(2)
}

#[test]
fn a_strip_load_beside_a_surcharge_is_prandtls() {
    let sand = soil(30.0, 0.0, 0.0);
    let s = footing(0.5, [8.0, 4.0], pressed(1.0, true), pressed(1.0, false), sand, Objective::Loads);
    near_from_above(&bounds(&s, &[700, 1400]), surcharge_factor(30.0), 0.02);
}

#[test]
fn a_strip_load_on_soil_with_cohesion_is_prandtls() {
    let s =
        footing(0.5, [6.0, 3.0], pressed(1.0, true), Condition::Free, soil(20.0, 1.0, 0.0), Objective::Loads);
    let exact = (surcharge_factor(20.0) - 1.0) / 20.0_f64.to_radians().tan();
    near_from_above(&bounds(&s, &[700, 1400]), exact, 0.02);
}

#[test]
fn rigid_footings_are_prandtls_too() {
    let exact = (surcharge_factor(20.0) - 1.0) / 20.0_f64.to_radians().tan();
    let down = Objective::Structure { velocity: [0.0, -1.0] };
    for (delta_deg, adhesion) in [(0.0, 0.0), (20.0, 1.0)] {
        let face = Condition::Face { delta_deg, adhesion };
        // The force on half a strip of width one.
        let s = footing(0.5, [6.0, 3.0], face, Condition::Free, soil(20.0, 1.0, 0.0), down);
        near_from_above(&bounds(&s, &[700, 1400]), 0.5 * exact, 0.03);
    }
}

#[test]
fn soil_under_water_weighs_what_is_left() {
    let wet = |unit_weight: f64, gradient: f64| {
        let mut meshed = soil(20.0, 1.0, unit_weight);
        meshed.pore_pressure = Linear { at_origin: 0.0, gradient: [0.0, -gradient] };
        let s = footing(0.5, [6.0, 3.0], pressed(1.0, true), Condition::Free, meshed, Objective::Loads);
        bounds(&s, &[]).pop().unwrap().proven
    };
    let (dry, submerged) = (wet(1.0, 0.0), wet(2.0, 1.0));
    assert!((dry - submerged).abs() < 1e-4 * dry, "{dry} {submerged}");
}

#[test]
fn a_slope_with_friction_carries_more_than_one_without() {
    let with = |phi_deg| bounds(&slope(60.0, soil(phi_deg, 1.0, 1.0)), &[700]).pop().unwrap().proven;
    let (clay, sand) = (with(0.0), with(20.0));
    // Log spirals give 5.25 and 10.4 (Chen 1975).
    assert!(clay > 5.1 && clay < 5.25 && sand > 10.0 && sand < 10.7, "{clay} {sand}");
}
