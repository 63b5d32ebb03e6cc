//! Insertion with and without accommodation.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod rig;

use rig::{SURFACE_Z_M, above, ground, homed};
use soilctl_controller::{Params, Request, Trajectory, Tunable};
use soilctl_plant::PlantParams;

/// Largest lateral force in N, and depth reached in m.
fn insert(alpha_deg: f64, accommodate: bool) -> (f64, f64) {
    let plant = PlantParams::thesis();
    let sand = ground(&plant, "ticino_rained", "table");
    let start = above(0.4318, 0.0, alpha_deg, SURFACE_Z_M + 0.002);
    let mut simulation = homed(Params::thesis(), plant, Some(sand), &start);
    simulation.tick(Some(Request::BiasForce), &mut |_| {}).unwrap();
    simulation.run(300, &mut |_| {}).unwrap();
    simulation.tick(Some(Request::Tune(Tunable::Accommodate(accommodate))), &mut |_| {}).unwrap();
    let insertion = Request::Push(Trajectory::Insert { depth_m: 0.025 });
    let (mut worst, mut deepest) = (0.0_f64, 0.0_f64);
    simulation.tick(Some(insertion), &mut |_| {}).unwrap();
    for _ in 0..20_000 {
        simulation
            .tick(None, &mut |tick| {
                worst = worst.max(tick.truth.soil.normal_n.abs());
                deepest = deepest.max(tick.truth.soil.depth_m);
            })
            .unwrap();
        assert!(simulation.state().fault.is_none(), "{:?}", simulation.state().fault);
        if simulation.state().idle {
            break;
        }
    }
    (worst, deepest)
}

/// 1.5 lbf without and 0.05 to 0.15 lbf with it in the thesis (figures 5-4, 5-5); the bar is a tenth.
#[test]
fn accommodation_lowers_the_lateral_force_tenfold() {
    for alpha_deg in [80.0, 90.0] {
        let ((with, depth), (without, _)) = (insert(alpha_deg, true), insert(alpha_deg, false));
        println!(
            "{alpha_deg} deg: lateral force {without:.2} N without, {with:.2} N with, {:.2} mm deep",
            1e3 * depth
        );
        assert!(without > 2.0, "{without} N");
        assert!(with < 0.1 * without, "{with} N against {without} N");
    }
}

/// What slipped while the plate was shallow is a smaller share of the deeper wedge: way times depth squared stays.
#[test]
fn soil_that_slipped_at_a_shallow_depth_does_not_weaken_a_deep_wedge() {
    let plant = PlantParams::thesis();
    let sand = ground(&plant, "ticino_rained", "table");
    let start = above(0.3048, 0.0, 90.0, SURFACE_Z_M + 0.002);
    let mut simulation = homed(Params::thesis(), plant, Some(sand), &start);
    let insertion = Request::Push(Trajectory::Insert { depth_m: 0.025 });
    simulation.tick(Some(insertion), &mut |_| {}).unwrap();
    let (mut deepest_m, mut first, mut held, mut longest) = (0.0_f64, 0.0, 0, 0);
    for _ in 0..6_000 {
        simulation
            .tick(None, &mut |tick| {
                let soil = tick.truth.soil;
                deepest_m = deepest_m.max(soil.depth_m);
                let now = soil.slip_m * deepest_m * deepest_m;
                // Far from failing nothing slips.
                if soil.mobilisation.abs() < 0.8 && soil.depth_m > 0.0 && now > 0.0 {
                    if held == 0 {
                        first = now;
                    }
                    held += 1;
                    longest = longest.max(held);
                    assert!((now / first - 1.0_f64).abs() < 0.01, "{now} {first}");
                } else {
                    held = 0;
                }
            })
            .unwrap();
    }
    assert!(longest > 1000 && deepest_m > 0.015, "{longest} ticks, {deepest_m} m");
}
