//! Smooth walls: Rankine's passive and active force, with cohesion and surcharge.

use crate::common::soil;
use crate::grounds::{heavy, wall};
use crate::{brackets, solve};

/// Force on a smooth wall of height one in soil of unit weight one, as it is pushed (1) or gives way (-1).
fn rankine(phi_deg: f64, cohesion: f64, surcharge: f64, direction: f64) -> f64 {
    let k = (45.0 + direction * phi_deg / 2.0).to_radians().tan().powi(2);
    direction * (k * (0.5 + surcharge) + direction * 2.0 * cohesion * k.sqrt())
}

fn check(phi_deg: f64, cohesion: f64, surcharge: f64, direction: f64, elements: usize, gap: f64) {
    let exact = rankine(phi_deg, cohesion, surcharge, direction);
    let bounds =
        solve(wall(&[(1.0, heavy(soil(phi_deg, cohesion)))], [0.0, -1.0], surcharge, direction), elements);
    let kind = if direction > 0.0 { "passive" } else { "active" };
    let name = format!(
        "smooth wall, {kind}, phi {phi_deg} deg, cohesion {cohesion}, surcharge {surcharge} (Rankine 1857)"
    );
    brackets(&name, &bounds, [exact; 2], gap);
}

#[test]
fn walls_that_are_pushed_carry_rankines_passive_force() {
    for (phi_deg, cohesion, surcharge) in [
        (30.0, 0.0, 0.0),
        (40.0, 0.0, 0.5),
        (45.0, 0.0, 0.5),
        (20.0, 0.3, 0.0),
        (30.0, 0.3, 0.5),
        (0.0, 1.0, 0.0),
    ] {
        check(phi_deg, cohesion, surcharge, 1.0, 600, 2e-3);
    }
}

#[test]
fn walls_that_give_way_carry_rankines_active_force() {
    // With cohesion only as much as leaves pressure on all of the wall: it bears no tension.
    for (phi_deg, cohesion, surcharge) in [(30.0, 0.0, 0.0), (40.0, 0.0, 0.5), (20.0, 0.1, 0.5)] {
        check(phi_deg, cohesion, surcharge, -1.0, 600, 2e-3);
    }
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_walls_of_many_soils() {
    for phi_deg in [10.0, 20.0, 30.0, 40.0, 45.0, 50.0] {
        walls(phi_deg);
    }
}

fn walls(phi_deg: f64) {
    for (cohesion, surcharge) in [(0.0, 0.0), (0.0, 1.0), (0.5, 0.0), (0.5, 1.0)] {
        check(phi_deg, cohesion, surcharge, 1.0, 1500, 1e-3);
        // Rankine's active pressure at the surface must not be a tension.
        if cohesion == 0.0 {
            check(phi_deg, cohesion, surcharge, -1.0, 1500, 1e-3);
        }
    }
}
