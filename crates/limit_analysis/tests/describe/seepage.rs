//! Pore pressures of water that flows.

use soilctl_limit_analysis::describe::{Aim, FlowUnit, HeadEntry, Kind, Side, StructureEntry};
use soilctl_limit_analysis::describe::{BoundaryEntry, RegionEntry, Seepage, SoilEntry};
use soilctl_limit_analysis::{Description, Options, bound};

use crate::common::{corners, described, soil};

fn head(name: &str, line: &[[f64; 2]], head_m: f64) -> HeadEntry {
    HeadEntry { name: Some(name.into()), line: line.to_vec(), head_m }
}

/// Ground 8 m long and 3 m deep behind a smooth wall, under half a metre of water, with a head of `below` at its base.
fn upwards(below: f64) -> Description {
    let sand = SoilEntry { unit_weight_kn_m3: 20.0, ..soil("sand", 30.0, 1.0) };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::Structure { name: "wall".into(), direction: [1.0, 0.0] },
        regions: vec![RegionEntry {
            name: None,
            soil: "sand".into(),
            polygon: vec![[0.0, -3.0], [8.0, -3.0], [8.0, 0.0], [0.0, 0.0]],
        }],
        soils: vec![sand],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]),
            BoundaryEntry::on_sides(Kind::Smooth, &[Side::Right]),
        ],
        structures: vec![StructureEntry {
            name: "wall".into(),
            edge: vec![[0.0, 0.0], [0.0, -3.0]],
            ..StructureEntry::default()
        }],
        heads: vec![
            head("water", &[[8.0, 0.0], [0.0, 0.0]], 0.5),
            head("base", &[[0.0, -3.0], [8.0, -3.0]], below),
        ],
        seepage: Some(Seepage { unit_weight_kn_m3: 10.0 }),
        ..Description::default()
    }
}

#[test]
fn pressure_along_a_column_is_linear() {
    let d = upwards(1.5);
    let found = described(&d);
    let s = &found.statement;
    let top = s.points.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
    for (i, region) in s.regions.iter().enumerate() {
        for p in corners(s, i) {
            let y = (p[1] - top) * found.length_m;
            let kpa = region.material.pore_pressure.at(p) * found.stress_kpa;
            let expected = 10.0 * (0.5 - y * (1.0 + 1.0 / 3.0));
            assert!((kpa - expected).abs() < 1e-6, "{y}: {kpa} for {expected}");
        }
    }
    let flowed = found.flowed.unwrap();
    assert_eq!(flowed.unit, FlowUnit::OverPermeability);
    assert!(
        (flowed.heads[1].inflow - 8.0 / 3.0).abs() < 1e-9
            && (flowed.heads[0].inflow + 8.0 / 3.0).abs() < 1e-9
    );
    let (gradient, at) = flowed.exit_gradient.unwrap();
    assert!((gradient - 1.0 / 3.0).abs() < 1e-9 && at[1] == 0.0);
    assert!(flowed.kept_within_kpa < 1e-6 && flowed.found_within_kpa < 1e-6);
}

#[test]
fn a_wall_is_held_by_what_the_flow_leaves_of_the_weight() {
    // Rankine: effective unit weight of the soil under water, less the gradient times that of water.
    for below in [0.5, 1.5, -0.4] {
        let gradient = (below - 0.5) / 3.0;
        let water = 10.0 * (0.5 * 3.0 + (1.0 + gradient) * 4.5);
        let cohesion = 2.0 * 3.0_f64.sqrt() * 3.0;
        let exact = 0.5 * 3.0 * (20.0 - 10.0 - gradient * 10.0) * 9.0 + cohesion + water;
        let d = described(&upwards(below));
        let options = Options { max_gap: 0.01, ..Options::default() };
        let found = bound(&d.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
        let [lower, upper] = d.in_units([found.lower.value, found.upper.value]);
        assert!(
            lower <= exact * (1.0 + 1e-6) && exact <= upper * (1.0 + 1e-6),
            "{below}: {lower} {exact} {upper}"
        );
        assert!(upper - lower < 0.02 * exact, "{below}: {lower} {exact} {upper}");
    }
}

/// A dam on rock, 5 m high with slopes of 1 in 2, with water up to `level` on its left.
fn dam(level: f64) -> Description {
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::StrengthReduction {},
        regions: vec![RegionEntry {
            name: None,
            soil: "fill".into(),
            polygon: vec![[0.0, 0.0], [24.0, 0.0], [14.0, 5.0], [10.0, 5.0]],
        }],
        soils: vec![SoilEntry { permeability_m_per_s: Some(1e-6), ..soil("fill", 32.0, 5.0) }],
        boundaries: vec![BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom])],
        heads: vec![head("reservoir", &[[0.0, 0.0], [10.0, 5.0]], level)],
        ..Description::default()
    }
}

#[test]
fn a_dam_has_a_free_surface_and_lets_water_out_at_its_toe() {
    let found = described(&dam(4.0));
    let flowed = found.flowed.unwrap();
    assert_eq!(flowed.unit, FlowUnit::M2PerS);
    // Schaffernak and van Iterson: the height a / sin(beta) over which water comes out of a slope of angle beta solves
    // q = k a sin(beta)^2, with d the way from the entry, of which Casagrande takes three tenths of the wetted slope off.
    let (slope, wetted): (f64, f64) = (0.5_f64.atan(), 8.0);
    let way = 24.0 - wetted + 0.3 * wetted;
    let along = way / slope.cos() - ((way / slope.cos()).powi(2) - (4.0 / slope.sin()).powi(2)).sqrt();
    let flow = 1e-6 * along * slope.sin() * slope.tan();
    assert!((flowed.heads[0].inflow / flow - 1.0).abs() < 0.15, "{} for {flow}", flowed.heads[0].inflow);
    assert!((flowed.seepage / flowed.heads[0].inflow - 1.0).abs() < 1e-6);
    let highest = flowed.free_surface.iter().flatten().map(|p| p[1]).fold(0.0, f64::max);
    assert!((3.5..=4.05).contains(&highest), "{highest}");
    assert!(flowed.kept_within_kpa < 0.15 * flowed.greatest_kpa, "{flowed:?}");
    // Open water presses on the slope below its level only.
    assert!(found.statement.regions.len() > 40);
    let dry =
        described(&dam(4.0)).statement.regions.iter().filter(|r| r.material.pore_pressure.is_zero()).count();
    assert!(dry >= 1);
}

#[test]
fn flow_through_soils_of_other_weight_is_taken_where_they_lie_level() {
    let mut d = upwards(1.5);
    d.soils[0].permeability_m_per_s = Some(1e-4);
    d.soils.push(SoilEntry {
        permeability_m_per_s: Some(1e-5),
        unit_weight_kn_m3: 18.0,
        ..soil("silt", 25.0, 2.0)
    });
    d.regions[0].polygon = vec![[0.0, -2.0], [8.0, -2.0], [8.0, 0.0], [0.0, 0.0]];
    d.regions.push(RegionEntry {
        name: None,
        soil: "silt".into(),
        polygon: vec![[0.0, -3.0], [8.0, -3.0], [8.0, -2.0], [0.0, -2.0]],
    });
    let found = described(&d);
    let flowed = found.flowed.unwrap();
    let exact = 8.0 / (2.0 / 1e-4 + 1.0 / 1e-5);
    assert!((flowed.heads[1].inflow / exact - 1.0).abs() < 1e-9, "{flowed:?}");
}

#[test]
fn what_water_cannot_do_is_refused() {
    let refused = |words: &str, change: &dyn Fn(&mut Description)| {
        let mut d = upwards(1.5);
        change(&mut d);
        let error = d.described().unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    };
    refused("no head is given", &|d| d.heads.clear());
    refused("not on the outline", &|d| d.heads[0].line = vec![[0.0, 0.0], [9.0, 0.0]]);
    refused("lets no water through", &|d| d.heads[0].line = vec![[0.0, 0.0], [0.0, -3.0]]);
    refused("both hold between", &|d| d.heads.push(d.heads[0].clone()));
    refused("beyond far sides water is at rest", &|d| d.boundaries[1].kind = Kind::Far);
    refused("keep one", &|d| {
        d.water = Some(soilctl_limit_analysis::describe::Water::fresh(vec![[0.0, 0.0]]))
    });
    refused("keep one", &|d| d.soils[0].pore_pressure_ratio = 0.2);
    refused("permeability_m_per_s is 0", &|d| d.soils[0].permeability_m_per_s = Some(0.0));
    refused("head_m is", &|d| d.heads[0].head_m = f64::NAN);
    refused("no head is given that reaches", &|d| {
        // All heads are above their ground by less than nothing: dry ground has none.
        d.heads = vec![head("dry", &[[0.0, -3.0], [8.0, -3.0]], -4.0)];
    });
}
