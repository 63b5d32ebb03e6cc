use soilctl_certificate::Condition;
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{RegionEntry, Water};

use crate::common::{corners, described, region, soil};

fn water(table: &[[f64; 2]]) -> Option<Water> {
    Some(Water { table: table.to_vec(), rise_m: 0.0, unit_weight_kn_m3: 10.0 })
}

#[test]
fn pressure_below_a_bent_table_is_hydrostatic_and_none_above() {
    let mut d = Description::slope(soil("silt", 25.0, 10.0), 6.0, 45.0);
    d.water = water(&[[0.0, 0.0], [6.0, 2.0], [20.0, 4.0]]);
    let found = described(&d);
    let s = &found.statement;
    let table = |x: f64| match x {
        x if x <= 0.0 => 0.0,
        x if x <= 6.0 => x / 3.0,
        x if x <= 20.0 => 2.0 + (x - 6.0) / 7.0,
        _ => 4.0,
    };
    // Back to metres: the middle of the soil, from -18 to 30, and the ground on top.
    let metres = |p: [f64; 2]| [6.0 + p[0] * found.length_m, 6.0 + p[1] * found.length_m];
    let datum = metres([0.0, 0.0]);
    assert_eq!(datum, [6.0, 6.0]);
    let (mut wet, mut dry) = (0, 0);
    for (i, r) in s.regions.iter().enumerate() {
        for p in corners(s, i) {
            let [x, y] = metres(p);
            let expected = if r.material.pore_pressure.is_zero() {
                dry += 1;
                assert!(y >= table(x) - 1e-9);
                0.0
            } else {
                wet += 1;
                10.0 * (table(x) - y)
            };
            let found = r.material.pore_pressure.at(p) * found.stress_kpa;
            assert!((found - expected).abs() < 1e-9, "at ({x}, {y}): {found} for {expected}");
        }
    }
    assert!(wet > 8 && dry > 3);
    // One dry region and four below the parts of the table.
    assert_eq!(s.regions.len(), 5);
}

#[test]
fn open_water_loads_the_ground() {
    let mut d = Description::slope(soil("silt", 25.0, 10.0), 6.0, 45.0);
    d.water = water(&[[0.0, 2.0], [20.0, 2.0]]);
    d.surcharge_kpa = 5.0;
    let found = described(&d);
    let s = &found.statement;
    let mut most = 0.0_f64;
    for b in &s.boundaries {
        let line = s.lines[b.line];
        for (end, p) in [line.from, line.to].into_iter().enumerate() {
            let y = 6.0 + s.points[p][1] * found.length_m;
            match b.condition {
                Condition::Loaded { pressure, live: false, .. } => {
                    let kpa = pressure[end] * found.stress_kpa;
                    assert!((kpa - 5.0 - 10.0 * (2.0 - y)).abs() < 1e-9, "{kpa} at {y}");
                    most = most.max(kpa);
                }
                Condition::Free => assert!(y >= 2.0 - 1e-9),
                _ => {}
            }
        }
    }
    assert!((most - 25.0).abs() < 1e-9);
    assert!((s.surcharge * found.stress_kpa - 5.0).abs() < 1e-12);
}

#[test]
fn level_ground_under_a_lake_is_free_under_its_pressure() {
    let mut d = Description::strip_footing(soil("silt", 25.0, 10.0), 2.0, 10.0, 0.0);
    d.water = water(&[[0.0, 3.0]]);
    let found = described(&d);
    assert!((found.statement.surcharge * found.stress_kpa - 30.0).abs() < 1e-12);
    assert!(!found.statement.boundaries.iter().any(|b| matches!(b.condition, Condition::Loaded { .. })));
    let pore = found.statement.regions[0].material.pore_pressure;
    assert!((pore.at([0.0, -1.0]) * found.stress_kpa - 50.0).abs() < 1e-9);
}

#[test]
fn a_table_at_the_surface_leaves_it_dry_exactly() {
    let mut d = Description::strip_footing(soil("sand", 35.0, 0.0), 0.7, 10.0, 0.0);
    let lift = |p: &mut [f64; 2]| p[1] += 101.3;
    d.regions[0].polygon.iter_mut().for_each(lift);
    d.structures[0].edge.iter_mut().for_each(lift);
    d.water = water(&[[0.0, 101.3]]);
    assert_eq!(described(&d).statement.regions[0].material.pore_pressure.at_origin, 0.0);
}

#[test]
fn a_pore_pressure_ratio_counts_the_weight_of_all_soil_above() {
    let mut d = Description::strip_footing(soil("cover", 30.0, 4.0), 2.0, 10.0, 0.0);
    let mut wet = soil("wet", 30.0, 4.0);
    wet.pore_pressure_ratio = 0.4;
    d.soils.push(wet);
    // A sloping interface between the two.
    let at = |p: &[[f64; 2]], soil: &str| RegionEntry { ..region(soil, p) };
    d.regions = vec![
        at(&[[-16.0, 0.0], [-16.0, -2.0], [0.0, -4.0], [16.0, -4.0], [16.0, 0.0]], "cover"),
        at(&[[-16.0, -2.0], [-16.0, -16.0], [16.0, -16.0], [16.0, -4.0], [0.0, -4.0]], "wet"),
    ];
    let found = described(&d);
    let s = &found.statement;
    for (i, r) in s.regions.iter().enumerate() {
        for p in corners(s, i) {
            let kpa = r.material.pore_pressure.at(p) * found.stress_kpa;
            let depth = -p[1] * found.length_m;
            let expected = if r.material.pore_pressure.is_zero() { 0.0 } else { 0.4 * 18.0 * depth };
            assert!((kpa - expected).abs() < 1e-9, "{kpa} for {expected}");
        }
    }
    assert!(s.regions.iter().any(|r| !r.material.pore_pressure.is_zero()));
}
