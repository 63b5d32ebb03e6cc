//! Random problems of each kind of structure.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Aim, BoundaryEntry, Kind, MemberEnd, MemberEntry, Profile, Side};

use crate::bodies::{anchor, footing, raft, rigid_wall};
use crate::draw::Draw;
use crate::ground::{flow, profile, region, soil, water};

/// What makes a problem from what is drawn.
type Make = fn(&mut Draw) -> Description;

/// A problem and what kind it is. Rafts and anchors take long, and are fewer.
pub(crate) fn any(draw: &mut Draw) -> (&'static str, Description) {
    let (name, make): (_, Make) = match draw.index(16) {
        0..=3 => ("slope with bars, sheets or piles", slope),
        4..=6 => ("cut with a facing", cut),
        7..=9 => ("wall in the ground", wall),
        10..=11 => ("footing", footing),
        12 => ("raft", raft),
        13 => ("anchor", anchor),
        _ => ("rigid wall with ties", rigid_wall),
    };
    (name, make(draw))
}

const SIDES: [Side; 2] = [Side::Left, Side::Right];

pub(crate) fn layers(draw: &mut Draw, objective: Aim) -> Description {
    Description {
        default_boundary: Some(Kind::Free),
        objective,
        soils: vec![soil(draw, "upper"), soil(draw, "lower")],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]),
            BoundaryEntry::on_sides(Kind::Smooth, &SIDES),
        ],
        ..Description::default()
    }
}

/// A bar that is level or slopes: a sheet, a row of bars, or one with a free length.
pub(crate) fn bar(draw: &mut Draw, line: [[f64; 2]; 2], attached: &[MemberEnd]) -> MemberEntry {
    let plain = MemberEntry {
        name: "bar".into(),
        line: line.to_vec(),
        tensile_kn_per_m: draw.between(5.0, 80.0),
        compressive_kn_per_m: if draw.chance(0.5) { draw.between(1.0, 20.0) } else { 0.0 },
        attached: attached.to_vec(),
        ..MemberEntry::default()
    };
    if draw.chance(0.35) {
        return MemberEntry { bond_factor: draw.between(0.5, 1.0), ..plain };
    }
    let free_length_m = if draw.chance(0.3) { draw.between(0.2, 0.6) * plain.length_m() } else { 0.0 };
    MemberEntry { pullout_kn_per_m2: Some(profile(draw, 3.0, 30.0)), free_length_m, ..plain }
}

pub(crate) fn beam(draw: &mut Draw, name: &str, line: [[f64; 2]; 2]) -> MemberEntry {
    MemberEntry {
        name: name.into(),
        line: line.to_vec(),
        moment_knm_per_m: Some(draw.between(5.0, 150.0)),
        shear_kn_per_m: Some(draw.between(50.0, 500.0)),
        tensile_kn_per_m: draw.between(100.0, 1000.0),
        compressive_kn_per_m: draw.between(100.0, 1000.0),
        bond_factor: draw.between(0.1, 1.0),
        ..MemberEntry::default()
    }
}

/// What a slope of a given height bears: a factor on its weight, or an earthquake.
fn slope(draw: &mut Draw) -> Description {
    let aim = if draw.chance(0.7) { Aim::UnitWeight {} } else { Aim::Seismic { leftwards: true } };
    let mut it = layers(draw, aim);
    if matches!(it.objective, Aim::Seismic { .. }) {
        it.soils[1].unit_weight_kn_m3 = it.soils[0].unit_weight_kn_m3;
    }
    let [run, level] = [draw.between(0.5, 8.0), draw.between(1.0, 4.0)];
    let on_face = run * level / 5.0;
    it.regions = vec![
        region("upper", &[[on_face, level], [18.0, level], [18.0, 5.0], [run, 5.0]]),
        region(
            "lower",
            &[[0.0, 0.0], [-8.0, 0.0], [-8.0, -4.0], [18.0, -4.0], [18.0, level], [on_face, level]],
        ),
    ];
    water(draw, &mut it, [-8.0, 0.0], [18.0, 3.0]);
    flow(draw, &mut it, [&[[-8.0, 0.0], [0.0, 0.0]], &[[18.0, -4.0], [18.0, level]]], [0.8, level + 0.8]);
    let x = run + draw.between(0.5, 3.0);
    it.members = match draw.index(4) {
        0 => {
            let [y, long] = [draw.between(-2.0, 4.5), draw.between(1.0, 5.0)];
            vec![bar(draw, [[x - 0.4, y], [x + long, y]], &[])]
        }
        1 => {
            let [first, next, long] =
                [(0.3, 1.8), (2.2, 4.6), (2.0, 7.0)].map(|(low, high)| draw.between(low, high));
            let row = |y: f64| MemberEntry {
                name: format!("row at {y} m"),
                ..bar(draw, [[run + 0.2, y], [run + 0.2 + long, y]], &[])
            };
            [first, next].map(row).to_vec()
        }
        2 => {
            let deep = draw.between(0.5, 4.0);
            vec![beam(draw, "piles", [[x, level + 0.7], [x, level - deep]])]
        }
        _ => {
            let end = [x + draw.between(1.0, 4.0), 5.0 - draw.between(0.2, 0.6)];
            vec![bar(draw, [[x, level + 0.2], end], &[])]
        }
    };
    it
}

/// An upright cut of 5 m whose facing is held by rows of nails or sheets.
fn cut(draw: &mut Draw) -> Description {
    let mut it = layers(draw, Aim::UnitWeight {});
    let level = draw.between(0.5, 4.0);
    it.regions = vec![
        region("upper", &[[0.0, level], [14.0, level], [14.0, 5.0], [0.0, 5.0]]),
        region("lower", &[[0.0, 0.0], [-6.0, 0.0], [-6.0, -4.0], [14.0, -4.0], [14.0, level], [0.0, level]]),
    ];
    water(draw, &mut it, [-6.0, -1.6], [14.0, 0.0]);
    it.members = vec![beam(draw, "facing", [[0.0, 5.0], [0.0, 0.0]])];
    let long = draw.between(2.0, 6.0);
    // Those that slope stay in one layer.
    for y in [4.7, 2.6, 0.8] {
        let falls = draw.chance(0.5) && !(level - 0.1..level + 0.2 * long + 0.1).contains(&y);
        let end = if falls { y - 0.2 * long } else { y };
        let crosses = it.water.is_some() && falls;
        if draw.chance(0.7) && !crosses {
            let row = bar(draw, [[0.0, y], [long, end]], &[MemberEnd::Start]);
            it.members.push(MemberEntry { name: format!("row at {y} m"), ..row });
        }
    }
    it
}

/// A sheet pile wall that is dug out, with or without a tie to the far side or to an anchor wall, loaded or not.
fn wall(draw: &mut Draw) -> Description {
    let mut it = layers(draw, Aim::UnitWeight {});
    let [dug, embedded, change] =
        [(2.0, 4.5), (0.5, 3.5), (0.5, 7.0)].map(|(low, high)| draw.between(low, high));
    let [left, right, bottom] = [-8.0, 12.0, -10.0];
    let change = if change < dug { -change } else { -change.max(dug + 0.3) };
    it.regions = if change > -dug {
        vec![
            region("upper", &[[0.0, change], [right, change], [right, 0.0], [0.0, 0.0]]),
            region(
                "lower",
                &[[left, -dug], [left, bottom], [right, bottom], [right, change], [0.0, change], [0.0, -dug]],
            ),
        ]
    } else {
        let upper = [[left, -dug], [left, change], [right, change], [right, 0.0], [0.0, 0.0], [0.0, -dug]];
        vec![
            region("upper", &upper),
            region("lower", &[[left, bottom], [right, bottom], [right, change], [left, change]]),
        ]
    };
    it.boundaries = vec![
        BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom, Side::Right]),
        BoundaryEntry::on_sides(Kind::Smooth, &[Side::Left]),
    ];
    if draw.chance(0.4) {
        it.boundaries.push(BoundaryEntry {
            pressure_kpa: Some(Profile::Uniform(draw.between(1.0, 20.0))),
            ..BoundaryEntry::on_line(Kind::Load, &[[6.0, 0.0], [1.0, 0.0]])
        });
    }
    water(draw, &mut it, [left, -dug], [right, -dug + 1.0]);
    it.members = vec![beam(draw, "wall", [[0.0, 0.0], [0.0, -dug - embedded]])];
    let at = -draw.between(0.4, 0.6 * dug);
    let tie = |draw: &mut Draw, end: f64| MemberEntry {
        bond_factor: 1.0,
        pullout_kn_per_m2: Some(Profile::Uniform(0.0)),
        free_length_m: 0.0,
        ..bar(draw, [[0.0, at], [end, at]], &[MemberEnd::Start, MemberEnd::End])
    };
    match draw.index(3) {
        0 => {}
        1 => it.members.push(tie(draw, right)),
        _ => {
            let ends = [[7.0, at + 0.3], [7.0, at - 0.7]];
            it.members.push(beam(draw, "anchor wall", ends));
            it.members.push(tie(draw, 7.0));
        }
    }
    it
}
