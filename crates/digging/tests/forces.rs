//! Forces that fail the soil against closed forms, and over sets of soils.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_digging::{Bite, Contact, Soils, borne, sliding_n};
use soilctl_earth_pressure::{Case, plane_model};

const G: f64 = 9.80665;

fn exact(phi: f64, delta: f64, density: f64) -> Soils {
    Soils::within([phi; 2], [delta; 2], [density; 2], G).unwrap()
}

fn bite(tool_angle_deg: f64) -> Bite {
    Bite { tool_angle_deg, depth_m: 0.025, heap_m: 0.0, width_m: 0.127 }
}

/// Rankine (1857): a smooth upright plate is pushed with `1/2 gamma H^2 w (K_p - K_a)`, and a heap adds `q H w K_p`.
#[test]
fn a_smooth_upright_plate_is_rankines() {
    let table = plane_model("table").unwrap();
    for phi in [25.0_f64, 35.0, 45.0] {
        let sin = phi.to_radians().sin();
        let (kp, ka) = ((1.0 + sin) / (1.0 - sin), (1.0 - sin) / (1.0 + sin));
        let scale = 0.5 * 1500.0 * G * 0.025 * 0.025 * 0.127;
        for delta in [0.0, 15.0] {
            let found = borne(table.as_ref(), &exact(phi, delta, 1500.0), &bite(90.0), 0.0).unwrap();
            let (bears, fails) = (found.bears_n.unwrap(), found.fails_n.unwrap());
            let exact = scale * (kp - ka);
            assert!(
                bears <= exact * (1.0 + 1e-9) && exact <= fails * (1.0 + 1e-9),
                "{bears} {exact} {fails}"
            );
            assert!(fails / bears < 1.02, "{bears} {fails}");
        }
        let heaped = Bite { heap_m: 0.01, ..bite(90.0) };
        let soils = exact(phi, 0.0, 1500.0);
        let of = |bite: &Bite| borne(table.as_ref(), &soils, bite, 0.0).unwrap().fails_n.unwrap();
        let heap = of(&heaped) - of(&bite(90.0));
        let expected = 1500.0 * G * 0.01 * 0.025 * 0.127 * kp;
        assert!((heap / expected - 1.0).abs() < 1e-6, "{heap} {expected}");
    }
}

/// What a plate does by the inclination; what fails soil is never below what it bears, grows with the inclination, and does not depend on a
/// roughness that the force does not use.
#[test]
fn contacts_and_order() {
    let table = plane_model("table").unwrap();
    let soils = Soils::within([38.0, 42.0], [20.0, 24.0], [1450.0, 1550.0], G).unwrap();
    let at = |deg: f64| borne(table.as_ref(), &soils, &bite(80.0), deg).unwrap();
    for (deg, contact) in [
        (-25.0, Contact::SlipsUp),
        (-22.0, Contact::Open),
        (-10.0, Contact::Sticks),
        (0.0, Contact::Sticks),
        (20.0, Contact::Sticks),
        (22.0, Contact::Open),
        (30.0, Contact::Dives),
    ] {
        assert_eq!(at(deg).contact, contact, "{deg}");
    }
    let mut last = 0.0;
    for deg in [-20.0, -10.0, 0.0, 10.0, 20.0, 30.0] {
        let found = at(deg);
        let fails = found.fails_n.unwrap();
        assert!(fails > last && found.bears_n.is_none_or(|bears| bears < fails), "{found:?}");
        last = fails;
    }
    assert_eq!(at(45.0).fails_n, None);
    let rougher = Soils::within([38.0, 42.0], [28.0, 30.0], [1450.0, 1550.0], G).unwrap();
    let same = borne(table.as_ref(), &rougher, &bite(80.0), 10.0).unwrap();
    assert_eq!((same.bears_n, same.fails_n), (at(10.0).bears_n, at(10.0).fails_n));
}

/// Every soil of a set fails between the set's ends.
#[test]
fn a_set_holds_its_soils() {
    let table = plane_model("table").unwrap();
    let set = Soils::within([36.0, 44.0], [18.0, 26.0], [1400.0, 1600.0], G).unwrap();
    let (low, high) = sliding_n(table.as_ref(), &set, &bite(75.0)).unwrap();
    for i in 0..=4 {
        for j in 0..=4 {
            for k in 0..=4 {
                let part = |n: i32| f64::from(n) / 4.0;
                let (phi, delta, density) =
                    (36.0 + 8.0 * part(i), 18.0 + 8.0 * part(j), 1400.0 + 200.0 * part(k));
                let one = table.predict(&Case::level_deg(75.0, phi, delta)).unwrap();
                let slant = 0.025 / 75f64.to_radians().sin();
                let scale = 0.5 * density * G * slant * slant * 0.127;
                assert!(low.unwrap() <= scale * one.net_lower.0 && scale * one.net_upper.0 <= high);
            }
        }
    }
}

#[test]
fn refusals_say_what_is_allowed() {
    for (phi, delta, density) in [
        ([45.0, 40.0], [20.0, 20.0], [1500.0, 1500.0]),
        ([40.0, 45.0], [20.0, 41.0], [1500.0, 1500.0]),
        ([40.0, 45.0], [20.0, 30.0], [f64::NAN, 1500.0]),
    ] {
        let problem = Soils::within(phi, delta, density, G).unwrap_err().to_string();
        assert!(problem.contains("must be from"), "{problem}");
    }
}
