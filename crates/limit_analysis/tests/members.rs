//! Bars and sheets: both bounds against exact forces, and against each other.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Kind, MemberEnd, MemberEntry, RegionEntry, Side, SoilEntry, StructureEntry,
};
use soilctl_limit_analysis::{Description, Options, bound};

/// Proven bounds in the units of the description.
fn bounds(it: &Description, elements: usize) -> [f64; 2] {
    let described = it.described().unwrap();
    let options = Options { max_elements: elements, max_gap: 1e-4, ..Options::default() };
    let trace = std::env::var_os("TRACE").is_some();
    let found = bound(&described.problem().unwrap(), &options, &mut |level, gap| {
        if trace {
            println!("{level:?} {gap:?}");
        }
    })
    .unwrap();
    described.in_units([found.lower.value, found.upper.value])
}

fn clay(cohesion_kpa: f64, unit_weight_kn_m3: f64) -> SoilEntry {
    SoilEntry { name: "clay".into(), cohesion_kpa, unit_weight_kn_m3, ..SoilEntry::default() }
}

fn sheet(line: [[f64; 2]; 2], tensile_kn_per_m: f64, bond_factor: f64) -> MemberEntry {
    let line = line.to_vec();
    MemberEntry { name: "sheet".into(), line, tensile_kn_per_m, bond_factor, ..MemberEntry::default() }
}

/// A sheet 4 m long in a block of clay that is held all around, pulled out by a head that the clay cannot hold.
fn pulled(member: MemberEntry) -> Description {
    let polygon = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]];
    Description {
        default_boundary: Some(Kind::Fixed),
        objective: Aim::Structure { name: "head".into(), direction: [-1.0, 0.0] },
        soils: vec![clay(10.0, 0.0)],
        regions: vec![RegionEntry { name: None, soil: "clay".into(), polygon }],
        structures: vec![StructureEntry {
            name: "head".into(),
            edge: vec![[0.0, 3.0], [0.0, 1.0]],
            ..StructureEntry::default()
        }],
        members: vec![MemberEntry { attached: vec![MemberEnd::Start], ..member }],
        ..Description::default()
    }
}

#[test]
fn a_sheet_is_pulled_out_by_what_its_faces_bear() {
    for (tensile, bond) in [(200.0, 0.5), (25.0, 0.5), (25.0, 1.0)] {
        let it = pulled(sheet([[0.0, 2.0], [4.0, 2.0]], tensile, bond));
        let exact = f64::min(tensile, 2.0 * bond * 10.0 * 4.0);
        let [lower, upper] = bounds(&it, 1500);
        println!("{tensile} {bond}: {lower} {upper} exact {exact}");
        assert!(lower <= exact * (1.0 + 1e-9) && exact <= upper * (1.0 + 1e-9), "{lower} {upper} {exact}");
        assert!(upper - lower < 0.05 * exact, "{lower} {upper} {exact}");
    }
}
