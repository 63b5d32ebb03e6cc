//! What makes no sense is refused in words that name the entry.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Hold, Kind, PlateEntry, Profile, Seismic, Side, StructureEntry, Water,
};

use crate::common::{region, soil};

fn footing() -> Description {
    Description::strip_footing(soil("sand", 30.0, 1.0), 2.0, 20.0, 0.5)
}

fn plate(line: &[[f64; 2]]) -> PlateEntry {
    PlateEntry { name: "plate".into(), line: line.to_vec(), held: Some(Hold::Fixed), ..PlateEntry::default() }
}

fn load(kind: Kind, line: &[[f64; 2]], kpa: f64) -> BoundaryEntry {
    BoundaryEntry { pressure_kpa: Some(Profile::Uniform(kpa)), ..BoundaryEntry::on_line(kind, line) }
}

#[track_caller]
fn refused(words: &str, change: impl Fn(&mut Description)) {
    let mut description = footing();
    change(&mut description);
    let error = description.described().unwrap_err().to_string();
    assert!(error.contains(words), "{error}");
}

#[test]
fn numbers_out_of_range() {
    refused("soil 1 (\"sand\"): phi_deg is 90", |d| d.soils[0].phi_deg = Some(90.0));
    refused("phi_deg is NaN", |d| d.soils[0].phi_deg = Some(f64::NAN));
    refused("cohesion_kpa is -1", |d| d.soils[0].cohesion_kpa = -1.0);
    refused("unit_weight_kn_m3 is inf", |d| d.soils[0].unit_weight_kn_m3 = f64::INFINITY);
    refused("pore_pressure_ratio is 1.5", |d| d.soils[0].pore_pressure_ratio = 1.5);
    refused("structure 1 (\"footing\"): delta_deg is -5", |d| d.structures[0].delta_deg = -5.0);
    refused("region 1 (\"sand\"): y is -inf", |d| d.regions[0].polygon[0][1] = f64::NEG_INFINITY);
    refused("surcharge_kpa is -1", |d| d.surcharge_kpa = -1.0);
    refused("kv is 1", |d| d.seismic = Some(Seismic { kh: 0.0, kv: 1.0 }));
    refused("cohesion_level_m", |d| d.soils[0].cohesion_gradient_kpa_per_m = 1.0);
    refused("cohesion is -", |d| {
        d.soils[0].cohesion_gradient_kpa_per_m = -1.0;
        d.soils[0].cohesion_level_m = Some(0.0);
    });
    refused("nothing resists or drives", |d| {
        d.soils[0].unit_weight_kn_m3 = 0.0;
        d.soils[0].cohesion_kpa = 0.0;
        d.structures[0].adhesion_kpa = 0.0;
    });
}

#[test]
fn polygons_that_are_none() {
    refused("region 1 (\"sand\"): polygon has 2 points", |d| d.regions[0].polygon.truncate(2));
    refused("region 1 (\"sand\"): it crosses or touches itself", |d| d.regions[0].polygon.swap(0, 1));
    refused("follow each other are both at (-16, 0)", |d| d.regions[0].polygon.insert(0, [-16.0, 0.0]));
    // A spike, and a corner on another edge.
    refused("crosses or touches itself", |d| {
        d.regions[0].polygon = vec![[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    });
    refused("crosses or touches itself", |d| {
        d.regions[0].polygon = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]];
    });
    refused("region 2 (\"clay\"): soil is \"clay\"", |d| d.regions.push(region("clay", &[[0.0; 2]; 3])));
}

#[test]
fn regions_that_overlap_or_nearly_touch() {
    let [w, deep] = [16.0, 16.0];
    refused("region 1 (\"sand\") and region 2 (\"sand\") overlap", |d| {
        d.regions.push(region("sand", &[[-1.0, -2.0], [1.0, -2.0], [1.0, 1.0], [-1.0, 1.0]]));
    });
    refused("overlap", |d| d.regions.push(d.regions[0].clone()));
    refused("nearly touch at", |d| {
        d.regions
            .push(region("sand", &[[w + 1e-6, -deep], [2.0 * w, -deep], [2.0 * w, 0.0], [w + 1e-6, 0.0]]));
    });
}

#[test]
fn boundaries_that_do_not_fit() {
    refused("no boundary condition on the outline from (", |d| d.default_boundary = None);
    refused("boundary 2: its line is not on the outline", |d| {
        d.boundaries.push(BoundaryEntry::on_line(Kind::Fixed, &[[3.0, 0.0], [4.0, 1.0]]));
    });
    refused("structure 1 (\"footing\") and boundary 2 both hold between", |d| {
        d.boundaries.push(load(Kind::Load, &[[0.0, 0.0], [4.0, 0.0]], 10.0));
    });
    refused("boundary 2 and boundary 3 both hold", |d| {
        d.boundaries.push(load(Kind::Load, &[[2.0, 0.0], [4.0, 0.0]], 10.0));
        d.boundaries.push(load(Kind::Load, &[[3.0, 0.0], [5.0, 0.0]], 10.0));
    });
    refused("boundary 1 and boundary 2 both hold", |d| {
        d.boundaries.push(BoundaryEntry::on_sides(Kind::Fixed, &[Side::Left]));
    });
    refused("only vertical lines on the far left and right", |d| d.default_boundary = Some(Kind::Far));
    refused("either sides", |d| d.boundaries.push(BoundaryEntry::on_line(Kind::Fixed, &[])));
    refused("a load needs pressure_kpa", |d| {
        d.boundaries.push(BoundaryEntry::on_line(Kind::Load, &[[2.0, 0.0], [3.0, 0.0]]));
    });
    refused("only kind = \"load\"", |d| d.boundaries.push(load(Kind::Free, &[[2.0, 0.0], [3.0, 0.0]], 1.0)));
    refused("there is no outline on its sides", |d| {
        d.regions[0].polygon[0][0] = -15.0;
        d.boundaries[0].sides = vec![Side::Right, Side::Bottom];
        d.boundaries.push(BoundaryEntry::on_sides(Kind::Fixed, &[Side::Left]));
    });
}

#[test]
fn structures_that_do_not_fit() {
    refused("plate 1 (\"plate\"): it is not in the soil", |d| {
        d.plates.push(plate(&[[0.0, 1.0], [2.0, 2.0]]))
    });
    refused("plate 1 (\"plate\"): line has 1 points", |d| d.plates.push(plate(&[[0.0, 1.0]])));
    refused("structure 2 (\"block\"): it does not touch the soil", |d| {
        d.structures.push(StructureEntry {
            name: "block".into(),
            polygon: vec![[0.0, 3.0], [1.0, 3.0], [0.0, 4.0]],
            held: Some(Hold::Fixed),
            ..StructureEntry::default()
        });
    });
    refused("structure 1 (\"footing\"): its edge is not on the outline", |d| {
        d.structures[0].edge[0][1] = -1.0
    });
    refused("give either polygon or edge", |d| d.structures[0].edge.clear());
    refused("delta is 20 deg, but it meets soil \"sand\" with phi 0 deg", |d| d.soils[0].phi_deg = Some(0.0));
    refused("adhesion without friction", |d| d.structures[0].delta_deg = 0.0);
}

#[test]
fn objectives_without_object() {
    refused("objective: name is \"wall\", but there is none of that name; there is \"footing\"", |d| {
        d.objective = Aim::Structure { name: "wall".into(), direction: [1.0, 0.0] };
    });
    refused("direction is [0, 0]", |d| {
        d.objective = Aim::Structure { name: "footing".into(), direction: [0.0, 0.0] };
    });
    refused("no live load", |d| d.objective = Aim::Load {});
    refused("no soil has weight", |d| {
        d.soils[0].unit_weight_kn_m3 = 0.0;
        d.objective = Aim::StrengthReduction {};
    });
    refused("\"pile\" does not move; say held", |d| {
        let mut pile = plate(&[[4.0, 0.0], [4.0, -1.0]]);
        (pile.name, pile.held) = ("pile".into(), None);
        d.plates.push(pile);
    });
}

#[test]
fn water_that_makes_no_sense() {
    let table =
        |points: &[[f64; 2]]| Some(Water { table: points.to_vec(), rise_m: 0.0, unit_weight_kn_m3: 10.0 });
    refused("water: table has 0 points", |d| d.water = table(&[]));
    refused("from left to right", |d| d.water = table(&[[1.0, 0.0], [0.0, 0.0]]));
    refused("exclude each other", |d| {
        d.water = table(&[[1.0, 0.0]]);
        d.soils[0].pore_pressure_ratio = 0.2;
    });
    refused("different heights above the ground beyond the two far sides", |d| {
        d.water = table(&[[-8.0, 1.0], [8.0, 2.0]]);
    });
}

#[test]
fn too_much_of_anything_is_refused_at_once() {
    refused("points, at most 2000", |d| d.regions[0].polygon = vec![[0.0; 2]; 10_000_000]);
    refused("regions, at most 256", |d| d.regions = vec![d.regions[0].clone(); 1000]);
    // A comb of plates through which another comb runs.
    refused("points where lines meet", |d| {
        for i in 0..120 {
            let x = -15.0 + 0.25 * f64::from(i);
            d.plates.push(plate(&[[x, -0.1], [x, -15.0]]));
            d.plates.push(plate(&[[-15.0, -0.1 - 0.12 * f64::from(i)], [15.0, -0.1 - 0.12 * f64::from(i)]]));
        }
    });
    refused("lines after cutting, at most 1024", |d| {
        let point = |i: i32| [4.0 + 0.008 * f64::from(i), -2.0 + 0.1 * f64::from(i % 2)];
        d.plates.push(plate(&(0..1300).map(point).collect::<Vec<_>>()));
    });
}

#[test]
fn horizontal_force_with_different_weights_is_not_covered() {
    refused("not covered", |d| {
        d.soils.push(soil("clay", 0.0, 10.0));
        d.soils[1].unit_weight_kn_m3 = 20.0;
        d.regions[0].polygon[1][1] = -8.0;
        d.regions[0].polygon[2][1] = -8.0;
        d.regions.push(region("clay", &[[-16.0, -16.0], [16.0, -16.0], [16.0, -8.0], [-16.0, -8.0]]));
        d.seismic = Some(Seismic { kh: 0.1, kv: 0.0 });
    });
}
