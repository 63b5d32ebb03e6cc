//! Beams: both bounds against exact moments, and against each other.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_certificate::{Bending, CertificateError, MemberMotion, Statement, prove_lower, prove_upper};
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Kind, MemberEnd, MemberEntry, Profile, RegionEntry, Side, SoilEntry,
};
use soilctl_limit_analysis::{Description, Options, bound};

/// Proven bounds in the units of the description.
fn bounds(it: &Description, elements: usize) -> [f64; 2] {
    let described = it.described().unwrap();
    let options = Options { max_elements: elements, max_gap: 1e-4, ..Options::default() };
    let found = bound(&described.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    // The parts of the gap add up to it.
    assert!(found.identity_residual() < 1e-7, "{:?}", found.levels);
    described.in_units([found.lower.value, found.upper.value])
}

/// A beam that no axial force and no shear force is too much for.
fn beam(line: [[f64; 2]; 2], moment_knm_per_m: f64) -> MemberEntry {
    MemberEntry {
        name: "beam".into(),
        line: line.to_vec(),
        tensile_kn_per_m: 1e4,
        compressive_kn_per_m: 1e4,
        moment_knm_per_m: Some(moment_knm_per_m),
        shear_kn_per_m: Some(1e4),
        ..MemberEntry::default()
    }
}

fn encloses([lower, upper]: [f64; 2], exact: f64, gap: f64) {
    // The wall is smooth but for a thousandth.
    assert!(lower <= exact * 1.002 && exact <= upper * (1.0 + 1e-9), "{lower} {upper} {exact}");
    assert!(upper - lower < gap * exact, "{lower} {upper} {exact}");
}

/// A nearly smooth wall of 4 m on rock that clamps it, with sand behind it and a load on that.
fn cantilever(moment_knm_per_m: f64) -> Description {
    let polygon = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]];
    let sand = SoilEntry {
        name: "sand".into(),
        phi_deg: Some(30.0),
        unit_weight_kn_m3: 18.0,
        ..SoilEntry::default()
    };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::Load {},
        soils: vec![sand],
        regions: vec![RegionEntry { name: None, soil: "sand".into(), polygon }],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]),
            BoundaryEntry::on_sides(Kind::Smooth, &[Side::Right]),
            BoundaryEntry {
                pressure_kpa: Some(Profile::Uniform(1.0)),
                live: true,
                ..BoundaryEntry::on_line(Kind::Load, &[[8.0, 4.0], [0.0, 4.0]])
            },
        ],
        members: vec![MemberEntry {
            bond_factor: 1e-3,
            attached: vec![MemberEnd::End],
            ..beam([[0.0, 4.0], [0.0, 0.0]], moment_knm_per_m)
        }],
        ..Description::default()
    }
}

#[test]
fn a_cantilever_wall_bears_rankines_pressure_up_to_its_moment() {
    // The moment at the base is K (gamma H^3 / 6 + q H^2 / 2).
    let (k, h) = (1.0 / 3.0, 4.0_f64);
    for moment in [100.0, 200.0] {
        let exact = (moment / k - 18.0 * h.powi(3) / 6.0) / (h.powi(2) / 2.0);
        encloses(bounds(&cantilever(moment), 800), exact, 0.04);
    }
}

/// A raft of 2 m on clay without weight, loaded on its middle metre.
fn raft(moment_knm_per_m: f64) -> Description {
    let polygon = vec![[-6.0, -4.0], [6.0, -4.0], [6.0, 0.0], [-6.0, 0.0]];
    let clay =
        SoilEntry { name: "clay".into(), phi_deg: Some(0.0), cohesion_kpa: 10.0, ..SoilEntry::default() };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::Load {},
        soils: vec![clay],
        regions: vec![RegionEntry { name: None, soil: "clay".into(), polygon }],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom, Side::Left, Side::Right]),
            BoundaryEntry {
                pressure_kpa: Some(Profile::Uniform(1.0)),
                live: true,
                ..BoundaryEntry::on_line(Kind::Load, &[[0.5, 0.0], [-0.5, 0.0]])
            },
        ],
        // Next to no axial force, or it would hold the soil beside the load together.
        members: vec![MemberEntry {
            tensile_kn_per_m: 1e-3,
            compressive_kn_per_m: 1e-3,
            ..beam([[-1.0, 0.0], [1.0, 0.0]], moment_knm_per_m)
        }],
        ..Description::default()
    }
}

#[test]
fn a_raft_spreads_a_load_as_far_as_it_is_strong() {
    let prandtl = 10.0 * (2.0 + std::f64::consts::PI);
    // Without strength the load is on 1 m, with more than it needs on 2 m.
    encloses(bounds(&raft(1e-3), 1200), prandtl, 0.04);
    encloses(bounds(&raft(1e4), 1200), 2.0 * prandtl, 0.04);
    let [lower, upper] = bounds(&raft(10.0), 1200);
    assert!(prandtl < lower && upper < 2.0 * prandtl);
}

/// A rigid footing of 2 m on clay without weight that holds on to it, under a pressure that is linear along it.
fn footing(pressure_kpa: [f64; 2]) -> Description {
    let mut it = raft(1e3);
    it.boundaries.truncate(1);
    it.boundaries.push(BoundaryEntry {
        pressure_kpa: Some(Profile::Linear(pressure_kpa)),
        live: true,
        ..BoundaryEntry::on_line(Kind::Load, &[[1.0, 0.0], [-1.0, 0.0]])
    });
    it.members = vec![beam([[-1.0, 0.0], [1.0, 0.0]], 1e3)];
    it
}

#[test]
fn a_footing_turns_on_a_scoop_of_clay() {
    // On a circle through both edges, with half its angle `a` at the centre: tan a = 2 a, and M = c B^2 a / (2 sin^2 a).
    let mut a: f64 = 1.2;
    for _ in 0..60 {
        a = (2.0 * a).atan();
    }
    let scoop = 10.0 * 4.0 * a / (2.0 * a.sin().powi(2));
    // The moment of a pressure from p to -p over B is p B^2 / 6.
    let [lower, upper] = bounds(&footing([1.0, -1.0]), 1600).map(|p| p * 4.0 / 6.0);
    assert!(lower < scoop && upper < 1.06 * scoop && upper - lower < 0.06 * scoop, "{lower} {upper} {scoop}");
    // In the middle it is Prandtl's.
    encloses(bounds(&footing([1.0, 1.0]), 1200), 10.0 * (2.0 + std::f64::consts::PI), 0.04);
}

/// A wall of 6 m in sand, dug out to 4 m, held near its top by a tie to a fixed side; all that acts is multiplied.
fn tied_wall(moment_knm_per_m: f64, tensile_kn_per_m: f64) -> Description {
    let polygon = vec![[-8.0, -4.0], [-8.0, -9.0], [12.0, -9.0], [12.0, 0.0], [0.0, 0.0], [0.0, -4.0]];
    let sand = SoilEntry {
        name: "sand".into(),
        phi_deg: Some(32.0),
        cohesion_kpa: 2.0,
        unit_weight_kn_m3: 18.0,
        ..SoilEntry::default()
    };
    let wall = MemberEntry {
        name: "wall".into(),
        bond_factor: 0.6,
        ..beam([[0.0, 0.0], [0.0, -6.0]], moment_knm_per_m)
    };
    let tie = MemberEntry {
        name: "tie".into(),
        line: vec![[0.0, -1.0], [12.0, -1.0]],
        tensile_kn_per_m,
        bond_factor: 1e-3,
        attached: vec![MemberEnd::Start, MemberEnd::End],
        ..MemberEntry::default()
    };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::StrengthReduction {},
        soils: vec![sand],
        regions: vec![RegionEntry { name: None, soil: "sand".into(), polygon }],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom, Side::Right]),
            BoundaryEntry::on_sides(Kind::Smooth, &[Side::Left]),
        ],
        members: vec![wall, tie],
        ..Description::default()
    }
}

#[test]
fn a_tied_wall_is_as_safe_as_its_weakest_part() {
    let [strong, weak_tie, weak_wall] =
        [(200.0, 200.0), (200.0, 10.0), (5.0, 200.0)].map(|(m, t)| bounds(&tied_wall(m, t), 600));
    for [lower, upper] in [strong, weak_tie, weak_wall] {
        assert!(lower <= upper && upper < 2.0 * lower, "{lower} {upper}");
    }
    assert!(weak_tie[1] < strong[0] && weak_wall[1] < strong[0], "{strong:?} {weak_tie:?} {weak_wall:?}");
}

#[test]
fn walls_in_clay_are_held_by_ties_and_clamps() {
    let clay = |it: &mut Description| {
        (it.soils[0].phi_deg, it.soils[0].cohesion_kpa) = (Some(0.0), 25.0);
    };
    // Soil on both sides of the wall and of the tie keeps its volume, and goes along with the wall.
    let [weak, strong] = [(5.0, 5.0), (200.0, 200.0)].map(|(moment, tension)| {
        let mut it = tied_wall(moment, tension);
        clay(&mut it);
        bounds(&it, 600)
    });
    let mut clamped = tied_wall(200.0, 200.0);
    clay(&mut clamped);
    clamped.members[0].line[1] = [0.0, -9.0];
    clamped.members[0].attached = vec![MemberEnd::End];
    let clamped = bounds(&clamped, 600);
    for [lower, upper] in [weak, strong, clamped] {
        assert!(lower <= upper && upper < 1.3 * lower, "{lower} {upper}");
    }
    // What is stronger bears no less.
    assert!(weak[0] <= strong[1] && strong[0] <= clamped[1], "{weak:?} {strong:?} {clamped:?}");
}

#[test]
fn a_proof_is_for_the_beam_that_is_stated() {
    let it = cantilever(100.0).described().unwrap();
    let options = Options { max_elements: 200, max_gap: 1e-4, ..Options::default() };
    let found = bound(&it.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    let (lower, upper) = (found.lower.field, found.upper.field);
    let with = |change: &dyn Fn(&mut Bending)| {
        let mut statement: Statement = it.statement.clone();
        statement.members[0].bending.iter_mut().for_each(change);
        statement
    };
    assert_eq!(prove_lower(&it.statement, &lower).unwrap(), found.lower.value);
    // What a stronger beam bears is borne, by a weaker one it is not; flows cost what the beam is worth.
    let stronger = with(&|b| b.moment *= 1.1);
    assert_eq!(prove_lower(&stronger, &lower).unwrap(), found.lower.value);
    let weaker = with(&|b| b.moment *= 0.9);
    let refused = prove_lower(&weaker, &lower).unwrap_err();
    let is_moment = |e: &CertificateError| matches!(e, CertificateError::NotProven { quantity, .. } if quantity.contains("moment"));
    assert!(is_moment(&refused), "{refused}");
    let sheared = prove_lower(&with(&|b| b.shear *= 1e-3), &lower).unwrap_err();
    assert!(sheared.to_string().contains("shear force"), "{sheared}");
    assert!(prove_upper(&weaker, &upper).unwrap() < found.upper.value);
    assert!(prove_upper(&stronger, &upper).unwrap() > found.upper.value);
    // The end is clamped; if it were not, its moment would come from nowhere.
    let mut loose = it.statement.clone();
    loose.members[0].attached = [false; 2];
    assert!(prove_lower(&loose, &lower).is_err() && prove_upper(&loose, &upper).is_err());
    // Nor does it come from nowhere if the beam is cut in two.
    let mut cut = upper.clone();
    let middle = cut.members.len() / 2;
    for flow in &mut cut.members[middle..] {
        for motion in &mut flow.motion {
            if let MemberMotion::Free { across, .. } = motion {
                *across *= 0.5;
            }
        }
    }
    assert!(prove_upper(&it.statement, &cut).map_or(true, |value| value > found.upper.value));
    // And a load on a beam is none on the soil.
    let mut bare = it.statement.clone();
    bare.members.clear();
    assert!(prove_lower(&bare, &lower).is_err() && prove_upper(&bare, &upper).is_err());
}

#[test]
fn beams_that_no_proof_covers_are_refused_in_words() {
    let refused = |change: &dyn Fn(&mut Description), words: &str| {
        let mut it = tied_wall(100.0, 100.0);
        change(&mut it);
        let problem = it.described().unwrap_err().to_string();
        assert!(problem.contains(words), "{words}: {problem}");
    };
    refused(&|it| it.members[0].shear_kn_per_m = None, "has both moment_knm_per_m and shear_kn_per_m");
    refused(&|it| it.members[0].moment_knm_per_m = Some(0.0), "moment_knm_per_m");
    refused(&|it| it.members[0].compressive_kn_per_m = 0.0, "compressive_kn_per_m");
    refused(&|it| it.members[0].line[0] = [0.0, 1.0], "must have soil all along");
    refused(&|it| it.members[0].line[1] = [0.0, -9.0], "is at what holds the soil");
    refused(&|it| it.members[0].attached = vec![MemberEnd::End], "only a fixed side can clamp");
    refused(&|it| it.members[0].line = vec![[-8.0, -9.0], [4.0, -9.0]], "lies along what holds the soil");
    refused(&|it| it.members[1].line[0] = [-2.0, -5.0], "meets another line");
    refused(&|it| it.members[1].line = vec![[0.0, 0.0], [12.0, -1.0]], "very end of a beam");
    refused(&|it| it.members.push(beam([[-3.0, -5.0], [3.0, -5.0]], 10.0)), "which no proof covers");
}
