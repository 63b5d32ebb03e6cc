//! Random ground with bars and beams in it: lower bounds are below upper ones, and what is stronger bears no less.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Kind, MemberEnd, MemberEntry, Profile, RegionEntry, Side, SoilEntry,
};
use soilctl_limit_analysis::{Description, LimitError, OneSide, Options, bound};

/// A number from 0 to 1, always the same for the same seed.
fn drawn(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// A slope in two layers, with or without friction, with a bar in it.
fn slope(mut seed: u64, strength: f64) -> Description {
    let mut draw = |low: f64, high: f64| low + (high - low) * drawn(&mut seed);
    let soil = |name: &str, phi_deg: f64, cohesion_kpa: f64| SoilEntry {
        name: name.into(),
        phi_deg: Some(phi_deg),
        cohesion_kpa,
        unit_weight_kn_m3: 18.0,
        ..SoilEntry::default()
    };
    let upper_phi = if draw(0.0, 1.0) < 0.3 { 0.0 } else { draw(5.0, 35.0) };
    let lower_phi = if draw(0.0, 1.0) < 0.3 { 0.0 } else { draw(5.0, 35.0) };
    let soils = vec![soil("upper", upper_phi, draw(5.0, 30.0)), soil("lower", lower_phi, draw(5.0, 30.0))];
    let [run, level] = [draw(0.0, 6.0), draw(1.0, 4.0)];
    let on_face = run * level / 5.0;
    let regions = vec![
        RegionEntry {
            name: None,
            soil: "upper".into(),
            polygon: vec![[on_face, level], [18.0, level], [18.0, 5.0], [run, 5.0]],
        },
        RegionEntry {
            name: None,
            soil: "lower".into(),
            polygon: vec![
                [-8.0, 0.0],
                [-8.0, -4.0],
                [18.0, -4.0],
                [18.0, level],
                [on_face, level],
                [0.0, 0.0],
            ],
        },
    ];
    // Level ones from inside, upright ones through both layers, or sloping ones within the upper.
    let kind = draw(0.0, 1.0);
    let x = run + draw(0.5, 3.0);
    let line = if kind < 0.4 {
        let y = draw(-2.0, 4.5);
        [[x - 0.4, y], [x + draw(1.0, 5.0), y]]
    } else if kind < 0.6 {
        [[x, level + 0.7], [x, level - draw(0.5, 3.0)]]
    } else {
        [[x, level + 0.2], [x + draw(1.0, 4.0), 5.0 - draw(0.2, 0.6)]]
    };
    let bond = if draw(0.0, 1.0) < 0.4 { 1.0 } else { draw(0.2, 0.95) };
    let member = MemberEntry {
        compressive_kn_per_m: 0.3 * strength,
        tensile_kn_per_m: strength,
        bond_factor: bond,
        line: line.to_vec(),
        name: "bar".into(),
        ..MemberEntry::default()
    };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::UnitWeight {},
        soils,
        regions,
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]),
            BoundaryEntry::on_sides(Kind::Smooth, &[Side::Left, Side::Right]),
        ],
        members: vec![member],
        ..Description::default()
    }
}

/// A wall in two layers, with or without friction, loaded behind it or not, held by a tie or not, with these strengths.
fn wall(mut seed: u64, moment_knm_per_m: f64, tensile_kn_per_m: f64) -> Description {
    let mut draw = |low: f64, high: f64| low + (high - low) * drawn(&mut seed);
    let dug = draw(2.0, 4.5);
    let embedded = draw(0.5, 3.5);
    let change = -draw(0.5, 5.0);
    let mut soil = |name: &str| SoilEntry {
        name: name.into(),
        phi_deg: Some(if draw(0.0, 1.0) < 0.3 { 0.0 } else { draw(5.0, 38.0) }),
        cohesion_kpa: draw(2.0, 25.0),
        unit_weight_kn_m3: draw(16.0, 21.0),
        ..SoilEntry::default()
    };
    let soils = vec![soil("upper"), soil("lower")];
    let region = |soil: &str, polygon: &[[f64; 2]]| RegionEntry {
        name: None,
        soil: soil.into(),
        polygon: polygon.to_vec(),
    };
    let [left, right, bottom] = [-8.0, 12.0, -9.0];
    let regions = if change > -dug {
        let lower =
            [[left, -dug], [left, bottom], [right, bottom], [right, change], [0.0, change], [0.0, -dug]];
        vec![
            region("upper", &[[0.0, change], [right, change], [right, 0.0], [0.0, 0.0]]),
            region("lower", &lower),
        ]
    } else {
        let change = change.min(-dug - 0.3);
        let upper = [[left, -dug], [left, change], [right, change], [right, 0.0], [0.0, 0.0], [0.0, -dug]];
        vec![
            region("upper", &upper),
            region("lower", &[[left, bottom], [right, bottom], [right, change], [left, change]]),
        ]
    };
    let sheet_pile = MemberEntry {
        name: "wall".into(),
        line: vec![[0.0, 0.0], [0.0, -dug - embedded]],
        tensile_kn_per_m: 1e4,
        compressive_kn_per_m: 1e4,
        moment_knm_per_m: Some(moment_knm_per_m),
        shear_kn_per_m: Some(1e4),
        bond_factor: draw(0.1, 1.0),
        ..MemberEntry::default()
    };
    let at = -draw(0.3, 0.8 * dug);
    let tie = MemberEntry {
        name: "tie".into(),
        line: vec![[0.0, at], [right, at]],
        tensile_kn_per_m,
        bond_factor: 1e-3,
        attached: vec![MemberEnd::Start, MemberEnd::End],
        ..MemberEntry::default()
    };
    let members = if draw(0.0, 1.0) < 0.3 { vec![sheet_pile] } else { vec![sheet_pile, tie] };
    let mut boundaries = vec![
        BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom, Side::Right]),
        BoundaryEntry::on_sides(Kind::Smooth, &[Side::Left]),
    ];
    if draw(0.0, 1.0) < 0.5 {
        boundaries.push(BoundaryEntry {
            pressure_kpa: Some(Profile::Uniform(draw(1.0, 20.0))),
            ..BoundaryEntry::on_line(Kind::Load, &[[6.0, 0.0], [1.0, 0.0]])
        });
    }
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::UnitWeight {},
        soils,
        regions,
        boundaries,
        members,
        ..Description::default()
    }
}

/// Proven bounds; nought and infinity where there are none.
fn bounds(it: &Description, elements: usize) -> [f64; 2] {
    let described = it.described().unwrap();
    let options = Options { max_elements: elements, max_gap: 1e-4, ..Options::default() };
    match bound(&described.problem().unwrap(), &options, &mut |_, _| {}) {
        Ok(found) => [found.lower.value, found.upper.value],
        Err(LimitError::NothingProven { proven, .. }) => match proven {
            Some(OneSide::Lower(lower)) => [lower, f64::INFINITY],
            Some(OneSide::Upper(upper)) => [0.0, upper],
            None => [0.0, f64::INFINITY],
        },
        Err(other) => panic!("{other}"),
    }
}

/// How many of each; more where all of verify runs.
fn cases(ordinary: u64) -> u64 {
    std::env::var("STRUCTURES").map_or(ordinary, |count| count.parse().unwrap())
}

#[test]
fn slopes_with_a_bar_are_no_weaker_for_a_stronger_one() {
    for case in 0..cases(2) {
        let [weak, strong] = [5.0, 50.0].map(|strength| bounds(&slope(1000 + case, strength), 700));
        assert!(weak[0] <= weak[1] && strong[0] <= strong[1], "{case}: {weak:?} {strong:?}");
        assert!(weak[0] <= strong[1], "{case}: {weak:?} {strong:?}");
    }
}

/// Without bars, with bars between which the soil goes on and that hold better and better, and with a sheet that sticks.
#[test]
fn slopes_are_no_weaker_for_bars_that_hold_better() {
    for case in 0..cases(1) {
        let mut seed = 3000 + case;
        let with = |pullout: Option<Profile>, free_length_m: f64| {
            let mut it = slope(3000 + case, 50.0);
            let member = &mut it.members[0];
            (member.bond_factor, member.pullout_kn_per_m2) = (1.0, pullout);
            member.free_length_m = free_length_m * member.length_m();
            it
        };
        let [free, at_start, at_end] = [0.6, 20.0, 20.0].map(|most| most * drawn(&mut seed));
        let grip = |times: f64| Some(Profile::Linear([times * at_start, times * at_end]));
        let bare = Description { members: Vec::new(), ..with(None, 0.0) };
        let all = [bare, with(grip(1.0), free), with(grip(3.0), free), with(grip(3.0), 0.0), with(None, 0.0)];
        let all = all.map(|it| bounds(&it, 600));
        for (i, [lower, upper]) in all.into_iter().enumerate() {
            assert!(lower <= upper, "{case}, {i}: {lower} {upper}");
            assert!(all[..i].iter().all(|weaker| weaker[0] <= upper), "{case}, {i}: {all:?}");
        }
    }
}

#[test]
fn walls_are_no_weaker_for_more_of_each_strength() {
    for case in 0..cases(1) {
        let [weak, tied, strong] = [(5.0, 5.0), (5.0, 80.0), (150.0, 80.0)]
            .map(|(moment, tension)| bounds(&wall(2000 + case, moment, tension), 600));
        for [lower, upper] in [weak, tied, strong] {
            assert!(lower <= upper, "{case}: {lower} {upper}");
        }
        assert!(weak[0] <= tied[1] && tied[0] <= strong[1], "{case}: {weak:?} {tied:?} {strong:?}");
    }
}
