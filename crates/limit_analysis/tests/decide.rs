//! Whether a quantity reaches a value, beside what it is exactly.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_limit_analysis::describe::{Aim, BoundaryEntry, Kind, Profile, RegionEntry, Side, SoilEntry};
use soilctl_limit_analysis::{Decision, Description, Options, Reach, decide};

fn decided(it: &Description, wanted: f64) -> (Decision, usize) {
    let options = Options { max_elements: 4000, max_gap: 0.02, ..Options::default() };
    let mut levels = 0;
    let decision = decide(it, wanted, &options, &mut |_, _| levels += 1).unwrap();
    (decision, levels)
}

fn soil(phi_deg: f64, cohesion_kpa: f64, unit_weight_kn_m3: f64) -> Vec<SoilEntry> {
    vec![SoilEntry {
        name: "soil".into(),
        phi_deg: Some(phi_deg),
        cohesion_kpa,
        unit_weight_kn_m3,
        ..SoilEntry::default()
    }]
}

fn ground(polygon: &[[f64; 2]]) -> Vec<RegionEntry> {
    vec![RegionEntry { name: None, soil: "soil".into(), polygon: polygon.to_vec() }]
}

/// A slope of 3 m that runs so far, with fixed ground below and beside it.
fn slope(run: f64, soils: Vec<SoilEntry>, objective: Aim) -> Description {
    let polygon = [[run, 3.0], [-6.0, 3.0], [-6.0, -4.0], [run + 6.0, -4.0], [run + 6.0, 0.0]];
    let (mut outline, mut free) = (polygon.to_vec(), vec![[-6.0, 3.0]]);
    // The crest is where the first point is, the toe as far away as it runs.
    outline[0] = [0.0, 3.0];
    outline.push([run, 0.0]);
    free.extend([[0.0, 3.0], [run, 0.0], [run + 6.0, 0.0]]);
    Description {
        default_boundary: Some(Kind::Fixed),
        objective,
        soils,
        regions: ground(&outline),
        boundaries: vec![BoundaryEntry::on_line(Kind::Free, &free)],
        ..Description::default()
    }
}

#[test]
fn a_factor_of_safety_is_decided_without_being_searched() {
    // Martin (2011): a vertical cut falls where weight over cohesion is 3.7764 to 3.7776.
    let cut = slope(0.0, soil(0.0, 20.0, 18.0), Aim::StrengthReduction {});
    let exact = 3.777 * 20.0 / 54.0;
    for (part, reach) in
        [(0.5, Reach::Reached), (0.97, Reach::Reached), (1.03, Reach::Missed), (3.0, Reach::Missed)]
    {
        let wanted = part * exact;
        let (decision, levels) = decided(&cut, wanted);
        assert_eq!(decision.reach, reach, "{part}");
        let proven = [decision.lower, decision.upper].into_iter().flatten().collect::<Vec<_>>();
        assert!(proven.len() == 1 && (proven[0] / wanted - 1.0).abs() < 1e-13, "{decision:?}");
        assert!(levels < 6 && (levels == 1 || (part - 1.0_f64).abs() < 0.1), "{part}: {levels}");
    }
    // Within what bounds may leave open nothing is said.
    assert_eq!(decided(&cut, exact).0.reach, Reach::Open);
}

#[test]
fn a_load_is_decided_by_its_bounds() {
    let polygon = [[-6.0, -4.0], [6.0, -4.0], [6.0, 0.0], [-6.0, 0.0]];
    let load = BoundaryEntry {
        pressure_kpa: Some(Profile::Uniform(1.0)),
        live: true,
        ..BoundaryEntry::on_line(Kind::Load, &[[1.0, 0.0], [-1.0, 0.0]])
    };
    let it = Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::Load {},
        soils: soil(0.0, 10.0, 0.0),
        regions: ground(&polygon),
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom, Side::Left, Side::Right]),
            load,
        ],
        ..Description::default()
    };
    let prandtl = 10.0 * (2.0 + std::f64::consts::PI);
    let (reached, levels) = decided(&it, 0.8 * prandtl);
    assert!(reached.reach == Reach::Reached && levels == 1, "{reached:?}");
    assert!(reached.lower.unwrap() >= 0.8 * prandtl && reached.lower.unwrap() <= prandtl);
    let (missed, levels) = decided(&it, 1.2 * prandtl);
    assert!(missed.reach == Reach::Missed && levels == 1 && missed.upper.unwrap() >= prandtl, "{missed:?}");
}

#[test]
fn ground_that_falls_by_itself_reaches_nothing() {
    // A slope of sand that is steeper than its friction, and is asked how much of an earthquake it bears.
    let it = slope(3.0, soil(34.0, 0.0, 18.0), Aim::Seismic { leftwards: false });
    let (decision, _) = decided(&it, 0.0);
    assert_eq!(decision.reach, Reach::Missed, "{decision:?}");
}
