//! Random problems of bodies that are pressed or pulled, and of rafts.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Hold, Kind, MemberEnd, PlateEntry, Seismic, Side, SoilEntry, SoilInterface,
    StructureEntry,
};

use crate::draw::Draw;
use crate::ground::{profile, region, water};
use crate::kinds::{bar, beam, layers};

/// What a face bears against a soil.
fn face(draw: &mut Draw, soil: &SoilEntry) -> [f64; 2] {
    let part = draw.between(0.3, 0.8);
    match soil.phi_deg {
        Some(0.0) => [
            0.0,
            part * soil.cohesion_kpa * soil.anisotropy.map_or(1.0, |ratios| ratios.shear.min(ratios.passive)),
        ],
        Some(phi) => [part * phi, 0.5 * part * soil.cohesion_kpa],
        None => [5.0, 0.5],
    }
}

/// A strip that is pressed into two layers, perhaps with a sheet in them.
pub(crate) fn footing(draw: &mut Draw) -> Description {
    let direction = [if draw.chance(0.3) { draw.between(-0.4, 0.4) } else { 0.0 }, -1.0];
    let mut it = layers(draw, Aim::Structure { name: "footing".into(), direction });
    it.surcharge_kpa = draw.between(1.0, 15.0);
    let level = -draw.between(0.5, 3.0);
    it.regions = vec![
        region("upper", &[[-8.0, level], [8.0, level], [8.0, 0.0], [-8.0, 0.0]]),
        region("lower", &[[-8.0, -7.0], [8.0, -7.0], [8.0, level], [-8.0, level]]),
    ];
    let [delta_deg, adhesion_kpa] = face(draw, &it.soils[0]);
    let edge = vec![[-1.0, 0.0], [1.0, 0.0]];
    it.structures = vec![StructureEntry {
        name: "footing".into(),
        edge,
        delta_deg,
        adhesion_kpa,
        ..StructureEntry::default()
    }];
    water(draw, &mut it, [-8.0, -1.2], [8.0, -1.2]);
    if draw.chance(0.6) {
        let y = draw.between(level + 0.1, -0.3);
        let reach = draw.between(1.0, 3.0);
        it.members = vec![bar(draw, [[-reach, y], [reach, y]], &[])];
    }
    it
}

/// Straight strengths instead of curved ones, which take long where there are many fans.
fn straight(it: &mut Description) {
    for soil in &mut it.soils {
        if soil.strength.take().is_some() {
            (soil.phi_deg, soil.cohesion_kpa, soil.strength_factor) = (Some(25.0), 5.0, None);
        }
    }
}

/// A raft that may bend, under a load.
pub(crate) fn raft(draw: &mut Draw) -> Description {
    let mut it = layers(draw, Aim::Load {});
    straight(&mut it);
    it.surcharge_kpa = draw.between(1.0, 15.0);
    let level = -draw.between(0.5, 3.0);
    it.regions = vec![
        region("upper", &[[-8.0, level], [8.0, level], [8.0, 0.0], [-8.0, 0.0]]),
        region("lower", &[[-8.0, -7.0], [8.0, -7.0], [8.0, level], [-8.0, level]]),
    ];
    let middle = draw.between(-0.8, 0.8);
    it.boundaries.push(BoundaryEntry {
        pressure_kpa: Some(profile(draw, 20.0, 60.0)),
        live: true,
        ..BoundaryEntry::on_line(Kind::Load, &[[middle + 1.0, 0.0], [middle - 1.0, 0.0]])
    });
    it.members = vec![beam(draw, "raft", [[-2.0, 0.0], [2.0, 0.0]])];
    if draw.chance(0.4) {
        it.members.push(beam(draw, "piles", [[3.0, -0.4], [3.0, -0.5 + level]]));
    }
    water(draw, &mut it, [-8.0, -1.2], [8.0, -1.2]);
    it
}

/// A buried plate or block that is pulled, perhaps beside a body that stays.
pub(crate) fn anchor(draw: &mut Draw) -> Description {
    let direction = [draw.between(-1.0, 1.0), 1.0];
    let mut it = layers(draw, Aim::Structure { name: "anchor".into(), direction });
    straight(&mut it);
    let level = -draw.between(2.6, 4.5);
    it.regions = vec![
        region("upper", &[[-8.0, level], [8.0, level], [8.0, 0.0], [-8.0, 0.0]]),
        region("lower", &[[-8.0, -7.0], [8.0, -7.0], [8.0, level], [-8.0, level]]),
    ];
    let [delta_deg, adhesion_kpa] = face(draw, &it.soils[0]);
    let deep = draw.between(0.8, 2.2);
    if draw.chance(0.5) {
        let line = vec![[-0.6, -deep], [0.6, -deep - draw.between(0.0, 0.3)]];
        it.plates = vec![PlateEntry {
            name: "anchor".into(),
            line,
            delta_deg,
            adhesion_kpa,
            ..PlateEntry::default()
        }];
    } else {
        let polygon = vec![[-0.5, -deep - 0.3], [0.5, -deep - 0.3], [0.5, -deep + 0.3], [-0.5, -deep + 0.3]];
        it.structures = vec![StructureEntry {
            name: "anchor".into(),
            polygon,
            delta_deg,
            adhesion_kpa,
            ..StructureEntry::default()
        }];
    }
    if draw.chance(0.15) {
        let polygon = vec![[2.0, -1.5], [2.6, -1.5], [2.6, -0.8], [2.0, -0.8]];
        let held = Some(Hold::Fixed);
        it.structures.push(StructureEntry {
            name: "stone".into(),
            polygon,
            held,
            ..StructureEntry::default()
        });
    }
    water(draw, &mut it, [-8.0, -1.2], [8.0, -1.2]);
    it
}

/// A rigid wall that is pushed into the soil or gives way, tied to it.
pub(crate) fn rigid_wall(draw: &mut Draw) -> Description {
    let direction = if draw.chance(0.5) { [1.0, 0.0] } else { [-1.0, 0.0] };
    let mut it = layers(draw, Aim::Structure { name: "wall".into(), direction });
    it.surcharge_kpa = draw.between(1.0, 10.0);
    let level = -draw.between(0.6, 2.4);
    it.regions = vec![
        region("upper", &[[0.0, level], [12.0, level], [12.0, 0.0], [0.0, 0.0]]),
        region("lower", &[[0.0, -3.0], [12.0, -3.0], [12.0, level], [0.0, level]]),
    ];
    it.boundaries = vec![
        BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]),
        BoundaryEntry::on_sides(Kind::Smooth, &[Side::Right]),
    ];
    let mut in_soil = Vec::new();
    for soil in &it.soils {
        let [delta_deg, adhesion_kpa] = face(draw, soil);
        in_soil.push(SoilInterface { soil: soil.name.clone(), delta_deg, adhesion_kpa });
    }
    let polygon = vec![[0.0, 0.0], [-0.5, 0.0], [-0.5, -3.0], [0.0, -3.0]];
    it.structures =
        vec![StructureEntry { name: "wall".into(), polygon, in_soil, ..StructureEntry::default() }];
    water(draw, &mut it, [0.0, -2.0], [12.0, -1.5]);
    it.seismic = (draw.chance(0.2) && it.soils[0].unit_weight_kn_m3 == it.soils[1].unit_weight_kn_m3)
        .then_some(Seismic { kh: 0.1, kv: 0.0 });
    let y = draw.between(-2.5, -0.4);
    let long = draw.between(2.0, 5.0);
    it.members = vec![bar(draw, [[0.0, y], [long, y]], &[MemberEnd::Start])];
    it
}
