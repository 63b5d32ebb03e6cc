//! Rows of bars between which the soil goes on: both bounds against exact forces, against ground without them, and against each other.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_certificate::{
    CertificateError, Grip, Jet, Member, MemberMotion, Statement, prove_lower, prove_upper,
};
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Kind, MemberEnd, MemberEntry, Profile, RegionEntry, Side, SoilEntry, StructureEntry,
};
use soilctl_limit_analysis::{Bounds, Description, Options, bound};

fn solved(it: &Description, elements: usize) -> Bounds {
    let options = Options { max_elements: elements, max_gap: 1e-4, ..Options::default() };
    let found = bound(&it.described().unwrap().problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    // The parts of the gap add up to it.
    assert!(found.identity_residual() < 1e-7, "{:?}", found.levels);
    found
}

/// Proven bounds in the units of the description.
fn bounds(it: &Description, elements: usize) -> [f64; 2] {
    let found = solved(it, elements);
    it.described().unwrap().in_units([found.lower.value, found.upper.value])
}

fn soil(phi_deg: f64, cohesion_kpa: f64, unit_weight_kn_m3: f64) -> SoilEntry {
    SoilEntry {
        name: "soil".into(),
        phi_deg: Some(phi_deg),
        cohesion_kpa,
        unit_weight_kn_m3,
        ..SoilEntry::default()
    }
}

fn bar(line: [[f64; 2]; 2], tensile_kn_per_m: f64, pullout: Profile) -> MemberEntry {
    MemberEntry {
        name: "bar".into(),
        line: line.to_vec(),
        tensile_kn_per_m,
        pullout_kn_per_m2: Some(pullout),
        ..MemberEntry::default()
    }
}

/// A bar in a block of soil that is held all around but at its top, pulled out by a head that the soil cannot hold.
fn pulled(phi_deg: f64, member: MemberEntry) -> Description {
    let polygon = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0]];
    Description {
        default_boundary: Some(Kind::Fixed),
        objective: Aim::Structure { name: "head".into(), direction: [-1.0, 0.0] },
        soils: vec![soil(phi_deg, 10.0, 0.0)],
        regions: vec![RegionEntry { name: None, soil: "soil".into(), polygon }],
        boundaries: vec![BoundaryEntry::on_sides(Kind::Free, &[Side::Top])],
        structures: vec![StructureEntry {
            name: "head".into(),
            edge: vec![[0.0, 3.0], [0.0, 1.0]],
            ..StructureEntry::default()
        }],
        members: vec![MemberEntry { attached: vec![MemberEnd::Start], ..member }],
        ..Description::default()
    }
}

fn encloses([lower, upper]: [f64; 2], exact: f64, gap: f64) {
    assert!(lower <= exact * (1.0 + 1e-9) && exact <= upper * (1.0 + 1e-9), "{lower} {upper} {exact}");
    assert!(upper - lower < gap * exact, "{lower} {upper} {exact}");
}

#[test]
fn a_bar_is_pulled_out_of_strong_soil_by_its_resistance_times_its_length_or_torn() {
    let level = [[0.0, 2.0], [4.0, 2.0]];
    for phi_deg in [0.0, 20.0] {
        for (tensile, pullout, free, exact) in [
            (200.0, Profile::Uniform(5.0), 0.0, 20.0),
            (12.0, Profile::Uniform(5.0), 0.0, 12.0),
            (200.0, Profile::Uniform(5.0), 1.3, 5.0 * 2.7),
            (200.0, Profile::Linear([2.0, 6.0]), 0.0, 16.0),
            (200.0, Profile::Linear([2.0, 6.0]), 2.0, 10.0),
            (200.0, Profile::Linear([0.06, 6.0]), 0.0, 12.12),
        ] {
            let member = MemberEntry { free_length_m: free, ..bar(level, tensile, pullout) };
            encloses(bounds(&pulled(phi_deg, member), 300), exact, 1e-2);
        }
    }
}

/// Grip that begins somewhere on a sloping line, and a head that slides along itself, down or up.
#[test]
fn a_sloping_anchor_bears_what_is_behind_its_free_length() {
    for (line, direction) in [([[0.0, 1.0], [2.0, 3.0]], -1.0), ([[0.0, 3.0], [2.0, 1.0]], 1.0)] {
        let member = MemberEntry { free_length_m: 1.1, ..bar(line, 200.0, Profile::Uniform(5.0)) };
        let mut it = pulled(0.0, member);
        it.objective = Aim::Structure { name: "head".into(), direction: [0.0, direction] };
        it.structures[0].edge = vec![[0.0, 3.5], [0.0, 0.5]];
        it.structures[0].adhesion_kpa = 1e-4;
        // Held all around it is simpler still.
        it.regions[0].polygon = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]];
        it.boundaries.clear();
        let exact = 5.0 * (8.0_f64.sqrt() - 1.1) * 0.5_f64.sqrt() + 3.0 * 1e-4;
        encloses(bounds(&it, 500), exact, 1e-4);
    }
}

/// Soil that fails at both faces of a bar holds it no longer: more grip than that is as much as that, and as that of a sheet that sticks.
#[test]
fn a_bar_with_more_grip_than_the_soil_bears_is_a_sheet_that_sticks() {
    let level = [[0.0, 2.0], [4.0, 2.0]];
    let sheet = MemberEntry { pullout_kn_per_m2: None, ..bar(level, 200.0, Profile::Uniform(0.0)) };
    let [sheet_lower, sheet_upper] = bounds(&pulled(0.0, sheet), 800);
    for pullout in [40.0, 1e6] {
        let [lower, upper] = bounds(&pulled(0.0, bar(level, 200.0, Profile::Uniform(pullout))), 800);
        assert!(lower <= sheet_upper && sheet_lower <= upper, "{lower} {upper} {sheet_lower} {sheet_upper}");
        assert!(upper - lower < 0.06 * upper, "{lower} {upper}");
        // Both faces at the cohesion.
        assert!(lower <= 80.0 && upper >= 79.9, "{lower} {upper}");
    }
}

/// A vertical cut of 4 m with a level bar at half its height, loose at the face.
fn cut(phi_deg: f64, member: Option<(f64, f64)>) -> Description {
    let mut it = Description::slope(soil(phi_deg, 15.0, 18.0), 4.0, 90.0);
    it.objective = Aim::UnitWeight {};
    it.members = member
        .map(|(tensile, pullout)| bar([[0.0, 2.0], [5.0, 2.0]], tensile, Profile::Uniform(pullout)))
        .into_iter()
        .collect();
    it
}

/// The unit weight at which a wedge slides out along a plane through the toe, by hand: with the dilation of the flow rule it moves at `theta -
/// phi` to the horizontal. The bar is torn, or pulled out of the wedge or of what is behind, whichever is least.
fn wedge(phi_deg: f64, tensile: f64, pullout: f64) -> f64 {
    let (phi, cohesion, height): (f64, f64, f64) = (phi_deg.to_radians(), 15.0, 4.0);
    let at = |theta: f64| {
        let in_wedge = 0.5 * height / theta.tan();
        let force = tensile.min(pullout * in_wedge).min(pullout * (5.0 - in_wedge).max(0.0));
        let power = cohesion * height / theta.sin() * phi.cos() + force * (theta - phi).cos();
        power / (0.5 * height * height / theta.tan() * (theta - phi).sin())
    };
    let angles = (1..2000).map(|i| phi + f64::from(i) / 2000.0 * (std::f64::consts::FRAC_PI_2 - phi));
    angles.map(at).fold(f64::INFINITY, f64::min)
}

/// A bar never makes ground weaker, and the stronger it is and the better the grip the more the ground bears; no more than a wedge does.
#[test]
fn a_bar_helps_a_cut_by_no_more_than_a_wedge_says_and_never_weakens_it() {
    // Known: 4 c tan(45 deg + phi/2) / H without a bar.
    let phi_deg: f64 = 20.0;
    let bare = 15.0 * (45.0 + 0.5 * phi_deg).to_radians().tan();
    assert!((wedge(phi_deg, 0.0, 0.0) - bare).abs() < 1e-3 * bare);
    let mut last = [0.0; 2];
    for member in [
        None,
        Some((60.0, 0.0)),
        Some((60.0, 1e-7)),
        Some((60.0, 10.0)),
        Some((60.0, 30.0)),
        Some((120.0, 30.0)),
    ] {
        let [lower, upper] = bounds(&cut(phi_deg, member), 800).map(|factor| 18.0 * factor);
        let (tensile, pullout) = member.unwrap_or_default();
        let wedge = wedge(phi_deg, tensile, pullout);
        assert!(lower <= wedge && upper <= 1.01 * wedge, "{member:?}: {lower} {upper} {wedge}");
        assert!(lower <= upper && upper < 1.06 * lower, "{member:?}: {lower} {upper}");
        assert!(last[0] <= upper && last[1] <= 1.01 * upper, "{member:?}: {last:?} {lower} {upper}");
        if member == Some((60.0, 0.0)) {
            // What the soil hands nothing is as none.
            assert!((lower - last[0]).abs() < 0.02 * lower && (upper - last[1]).abs() < 0.02 * upper);
        }
        last = [lower, upper];
    }
    // It helps by far more than the bounds are apart.
    assert!(last[0] > 1.1 * bare, "{last:?} {bare}");
}

/// A smooth wall of 5 m that moves away from sand, tied to the ground behind by a bar that the sand hands nothing, or anchored in it.
fn tied_wall(member: MemberEntry) -> Description {
    // The sand is cut in two upright, so that bars go along two lines.
    let region = |[left, right]: [f64; 2]| RegionEntry {
        name: None,
        soil: "soil".into(),
        polygon: vec![[left, 0.0], [right, 0.0], [right, 5.0], [left, 5.0]],
    };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::Structure { name: "wall".into(), direction: [-1.0, 0.0] },
        soils: vec![soil(30.0, 0.0, 18.0)],
        regions: vec![region([0.0, 2.0]), region([2.0, 10.0])],
        boundaries: vec![BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom, Side::Right])],
        structures: vec![StructureEntry {
            name: "wall".into(),
            edge: vec![[0.0, 5.0], [0.0, 0.0]],
            ..StructureEntry::default()
        }],
        members: vec![member],
        ..Description::default()
    }
}

/// Rankine's thrust is `Ka gamma H^2/2`. A tie takes its strength off it, an anchor what holds it beyond its free length, which ends
/// behind Rankine's wedge.
#[test]
fn a_tie_or_an_anchor_takes_what_it_bears_off_the_thrust() {
    let tie = MemberEntry {
        attached: vec![MemberEnd::Start, MemberEnd::End],
        ..bar([[0.0, 3.0], [10.0, 3.0]], 30.0, Profile::Uniform(0.0))
    };
    let anchor = MemberEntry {
        attached: vec![MemberEnd::Start],
        free_length_m: 3.0,
        ..bar([[0.0, 3.0], [7.0, 3.0]], 100.0, Profile::Uniform(4.0))
    };
    for (member, exact) in [(tie, 30.0 - 75.0), (anchor, 16.0 - 75.0)] {
        let [lower, upper] = bounds(&tied_wall(member), 1500);
        assert!(lower <= exact + 1e-6 && exact - 1e-6 <= upper, "{lower} {upper} {exact}");
        assert!(upper - lower < 1.5, "{lower} {upper} {exact}");
    }
}

/// What fields prove of a statement they prove of no stronger one from below, and of no weaker one from above.
#[test]
fn altered_bars_are_refused() {
    let level = [[0.0, 2.0], [4.0, 2.0]];
    let member = MemberEntry { free_length_m: 1.0, ..bar(level, 200.0, Profile::Uniform(5.0)) };
    let it = pulled(0.0, member);
    let found = solved(&it, 300);
    let statement = &it.described().unwrap().statement;
    let (lower, upper) = (&found.lower.field, &found.upper.field);
    let with = |resistance: f64, from: f64| {
        let mut other = statement.clone();
        for grip in other.members[0].pullout.iter_mut().flatten() {
            grip.resistance = grip.resistance.map(|r| r * resistance);
            grip.part[0] = from;
        }
        other
    };
    assert!(prove_lower(&with(1.0, 0.25), lower).is_ok());
    let less = prove_lower(&with(0.9, 0.25), lower);
    assert!(matches!(less, Err(CertificateError::NotProven { .. })), "{less:?}");
    assert!((prove_upper(&with(0.5, 0.25), upper).unwrap() - 0.5 * found.upper.value).abs() < 1e-6);
    // Where there is no grip any more the force must not change; where there is more, flows cost more.
    assert!(prove_lower(&with(1.0, 0.5), lower).is_err());
    assert!(prove_lower(&with(1.0, 0.0), lower).is_ok());
    assert!(prove_upper(&with(1.0, 0.0), upper).unwrap() > 1.3 * found.upper.value);
    // The force is one number along the free length, of which nothing may be taken; elsewhere it may be what it is.
    let mut field = lower.clone();
    let free = 1.0 / it.described().unwrap().length_m;
    let head = statement.points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    let is_free = |x: f64| head < x && x < head + free;
    let places: Vec<f64> = field.mesh.vertices.iter().map(|vertex| vertex.position[0]).collect();
    let kink = field.copies.iter_mut().find_map(|copy| match &mut copy.jet {
        Jet::Kinked { jump, .. } if is_free(places[copy.vertex]) => Some(jump),
        _ => None,
    });
    *kink.unwrap() *= 1.0 + 1e-12;
    assert!(matches!(prove_lower(statement, &field), Err(CertificateError::BadField { .. })));
    // A sheet has faces, on which the soil would have to slide.
    let mut sheet = statement.clone();
    sheet.members[0].pullout = None;
    assert!(prove_upper(&sheet, upper).is_err());
    let refused = |change: &dyn Fn(&mut Member)| {
        let mut bad = statement.clone();
        change(&mut bad.members[0]);
        assert!(prove_lower(&bad, lower).is_err() && prove_upper(&bad, upper).is_err());
    };
    let grips = |m: &mut Member, change: &dyn Fn(&mut Grip)| m.pullout.iter_mut().flatten().for_each(change);
    refused(&|m| m.bond = 0.5);
    refused(&|m| m.pullout = Some(Vec::new()));
    refused(&|m| grips(m, &|grip| grip.resistance[0] = -1.0));
    refused(&|m| grips(m, &|grip| grip.part = [0.5, 0.2]));
    // Soil that parts at the bar does not go on; a bar that moves across itself leaves it.
    let mut field = upper.clone();
    field.members[0].motion[1] = MemberMotion::Free { along: 0.0, across: 0.0 };
    assert!(prove_upper(statement, &field).is_err());
    let mut field = upper.clone();
    field.members[0].motion[1] = MemberMotion::Along { along: 0.5 };
    assert!(prove_upper(statement, &field).unwrap() > found.upper.value);
    // Ordinary numbers of files go back and forth.
    let text = serde_json::to_string(statement).unwrap();
    assert_eq!(serde_json::from_str::<Statement>(&text).unwrap(), *statement);
}

#[test]
fn bars_that_make_no_sense_are_refused_in_words() {
    let refused = |change: &dyn Fn(&mut MemberEntry), words: &str| {
        let mut it = cut(20.0, Some((60.0, 10.0)));
        change(&mut it.members[0]);
        let error = it.described().unwrap_err().to_string();
        assert!(error.contains(words) && error.contains("member 1"), "{error}");
    };
    refused(&|m| m.bond_factor = 0.5, "keep one");
    refused(&|m| m.pullout_kn_per_m2 = Some(Profile::Uniform(-1.0)), "pullout_kn_per_m2");
    refused(
        &|m| m.pullout_kn_per_m2 = Some(Profile::Linear([0.0, 10.0])),
        "a hundredth of that at the other",
    );
    refused(&|m| m.free_length_m = 6.0, "free_length_m");
    let mut it = cut(20.0, Some((60.0, 10.0)));
    (it.members[0].pullout_kn_per_m2, it.members[0].free_length_m) = (None, 1.0);
    assert!(it.described().unwrap_err().to_string().contains("goes with pullout_kn_per_m2"));
    refused(
        &|m| {
            (m.moment_knm_per_m, m.shear_kn_per_m, m.compressive_kn_per_m) = (Some(1.0), Some(1.0), 10.0);
        },
        "no pullout_kn_per_m2",
    );
}
