//! Bars and sheets: both bounds against exact forces, and against each other.
#![allow(clippy::unwrap_used, reason = "tests")]

use soilctl_certificate::{CertificateError, Jet, MemberMotion, prove_lower, prove_upper};
use soilctl_limit_analysis::describe::{
    Aim, AnisotropyEntry, BoundaryEntry, Kind, MemberEnd, MemberEntry, RegionEntry, Side, SoilEntry,
    StructureEntry,
};
use soilctl_limit_analysis::{Description, Options, bound};

/// Proven bounds in the units of the description.
fn bounds(it: &Description, elements: usize) -> [f64; 2] {
    let described = it.described().unwrap();
    let options = Options { max_elements: elements, max_gap: 1e-4, ..Options::default() };
    let found = bound(&described.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    described.in_units([found.lower.value, found.upper.value])
}

fn clay(cohesion_kpa: f64, unit_weight_kn_m3: f64) -> SoilEntry {
    SoilEntry {
        name: "clay".into(),
        phi_deg: Some(0.0),
        cohesion_kpa,
        unit_weight_kn_m3,
        ..SoilEntry::default()
    }
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
        let [lower, upper] = bounds(&it, 800);
        assert!(lower <= exact * (1.0 + 1e-9) && exact <= upper * (1.0 + 1e-9), "{lower} {upper} {exact}");
        assert!(upper - lower < 0.05 * exact, "{lower} {upper} {exact}");
    }
}

/// Clay whose active strength is 10 kPa, and its own. A level sheet shears it in simple shear; along one that slopes at 45 degrees one face loads the
/// clay as an active wall does and the other as a passive one, whichever way the sheet goes.
#[test]
fn faces_of_a_sheet_bear_what_the_direction_of_the_clay_allows() {
    let (passive, shear) = (0.5, 0.7);
    let sloped = |bond: f64| bond * 10.0 * (1.0 + passive) * 2.0;
    for (line, bond, direction, exact) in [
        ([[0.0, 2.0], [4.0, 2.0]], 0.5, [-1.0, 0.0], 0.5 * 10.0 * 2.0 * shear * 4.0),
        ([[0.0, 1.0], [2.0, 3.0]], 0.5, [0.0, -1.0], sloped(0.5)),
        ([[0.0, 3.0], [2.0, 1.0]], 0.8, [0.0, 1.0], sloped(0.8)),
    ] {
        let mut it = pulled(sheet(line, 200.0, bond));
        it.objective = Aim::Structure { name: "head".into(), direction };
        // A head that a sheet slopes away from must not be smooth: it slides along itself, and next to nothing holds it.
        it.structures[0].edge = vec![[0.0, 3.5], [0.0, 0.5]];
        it.structures[0].adhesion_kpa = if direction[0] == 0.0 { 1e-4 } else { 0.0 };
        it.soils[0].anisotropy = Some(AnisotropyEntry { passive, shear });
        let [lower, upper] = bounds(&it, 1500);
        assert!(lower <= exact * (1.0 + 1e-9) && exact <= upper * (1.0 + 1e-9), "{lower} {upper} {exact}");
        assert!(upper - lower < 0.05 * exact, "{lower} {upper} {exact}");
    }
}

/// A smooth wall of 5 m that moves away from sand, tied to the ground behind.
fn tied_wall(tensile: f64) -> Description {
    let polygon = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 5.0], [0.0, 5.0]];
    let sand = SoilEntry {
        name: "sand".into(),
        phi_deg: Some(30.0),
        unit_weight_kn_m3: 18.0,
        ..SoilEntry::default()
    };
    let tie = MemberEntry {
        attached: vec![MemberEnd::Start, MemberEnd::End],
        ..sheet([[0.0, 3.0], [8.0, 3.0]], tensile, 0.5)
    };
    Description {
        default_boundary: Some(Kind::Free),
        objective: Aim::Structure { name: "wall".into(), direction: [-1.0, 0.0] },
        soils: vec![sand],
        regions: vec![RegionEntry { name: None, soil: "sand".into(), polygon }],
        boundaries: vec![
            BoundaryEntry::on_sides(Kind::Smooth, &[Side::Bottom]),
            BoundaryEntry::on_sides(Kind::Fixed, &[Side::Right]),
        ],
        structures: vec![StructureEntry {
            name: "wall".into(),
            edge: vec![[0.0, 5.0], [0.0, 0.0]],
            ..StructureEntry::default()
        }],
        members: vec![tie],
        ..Description::default()
    }
}

/// Rankine's wedge goes along with the wall at the same speed, so the tie only stretches where it leaves the wedge, and takes its
/// strength off the thrust `Ka gamma H^2/2`; the same field of stress with the tie at its strength all along proves it.
#[test]
fn a_tie_takes_its_strength_off_the_thrust_on_a_smooth_wall() {
    for tensile in [0.0, 30.0] {
        let exact = tensile - 75.0;
        let [lower, upper] = bounds(&tied_wall(tensile), 1500);
        assert!(lower <= exact + 1e-6 && exact - 1e-6 <= upper, "{lower} {upper} {exact}");
        assert!(upper - lower < 1.5, "{lower} {upper} {exact}");
    }
}

/// A vertical cut of 4 m in clay with a level sheet at half its height.
fn cut(tensile: f64, bond: f64) -> Description {
    let mut it = Description::slope(clay(20.0, 18.0), 4.0, 90.0);
    it.objective = Aim::UnitWeight {};
    it.members = vec![sheet([[0.0, 2.0], [6.0, 2.0]], tensile, bond)];
    it
}

/// The unit weight that a vertical cut of height 4 m bears by hand: soil of 20 kPa turns as one on a circle through the toe, and tears a
/// sheet at half the height. With the centre at `m` and the radius `R`, the arc takes `c R^2 angle` and the sheet its strength times its
/// distance from the centre along y, for a turn of one; the least over all circles.
fn turning(tensile: f64) -> f64 {
    let (cohesion, height) = (20.0, 4.0);
    let mut least = f64::INFINITY;
    for i in 1..80 {
        let top = 0.02 * f64::from(i) * height;
        for j in 1..400 {
            let (chord, out) = (top.hypot(height), 0.01 * f64::from(j) * height);
            let m = [0.5 * top - out * height / chord, 0.5 * height + out * top / chord];
            let radius = m[0].hypot(m[1]);
            let angle = 2.0 * (0.5 * chord / radius).asin();
            // The soil between the face at x = 0 and the arc.
            let rows = 200;
            let (mut moment, mut is_cut) = (0.0, true);
            for k in 0..rows {
                let y = (f64::from(k) + 0.5) / f64::from(rows) * height;
                let x = m[0] + (radius * radius - (y - m[1]) * (y - m[1])).max(0.0).sqrt();
                is_cut &= x >= 0.0;
                moment += x * (0.5 * x - m[0]) * height / f64::from(rows);
            }
            if is_cut && moment > 0.0 {
                let power = cohesion * radius * radius * angle + tensile * (m[1] - 0.5 * height).abs();
                least = least.min(power / moment);
            }
        }
    }
    least
}

/// A wedge at 45 degrees that the sheet is torn by bears `4 c/H + 2 T/H^2`; a circle is near the truth where the sheet is torn.
#[test]
fn a_sheet_helps_a_vertical_cut_by_no_more_than_wedges_and_circles_say() {
    // Known: 3.83 c/H.
    assert!((turning(0.0) - 3.83 * 5.0).abs() < 0.02, "{}", turning(0.0));
    let mut last = [0.0; 2];
    for tensile in [0.0, 20.0, 60.0] {
        let [lower, upper] = bounds(&cut(tensile, 1.0), 1500).map(|factor| 18.0 * factor);
        let wedge = 4.0 * 20.0 / 4.0 + 2.0 * tensile / 16.0;
        let circle = turning(tensile);
        assert!(lower <= wedge.min(circle) && lower <= upper, "{lower} {upper} {wedge} {circle}");
        // Finer flows bear less than rigid ones.
        assert!(upper <= 1.01 * wedge.min(circle), "{upper} {wedge} {circle}");
        // Where the sheet is not too strong to be torn, a rigid circle is near the truth.
        assert!(tensile > 20.0 || lower >= 0.94 * circle, "{lower} {circle}");
        assert!(last[0] <= upper && last[1] <= 1.001 * upper, "{last:?} {lower} {upper}");
        last = [lower, upper];
    }
}

/// Without a sheet, and with one that bears nothing, bounds are those of the same ground, on different meshes.
#[test]
fn a_sheet_that_bears_nothing_is_as_none() {
    let with = bounds(&cut(0.0, 1.0), 1000);
    let without = bounds(&Description { members: Vec::new(), ..cut(0.0, 1.0) }, 1000);
    assert!(with[0] <= without[1] && without[0] <= with[1], "{with:?} {without:?}");
    assert!(
        (with[0] - without[0]).abs() < 0.02 && (with[1] - without[1]).abs() < 0.02,
        "{with:?} {without:?}"
    );
}

/// What fields prove of a statement they prove of no stronger one from below, and of no weaker one from above.
#[test]
fn altered_members_are_refused() {
    let described = pulled(sheet([[0.0, 2.0], [4.0, 2.0]], 200.0, 0.5)).described().unwrap();
    let options = Options { max_elements: 700, max_gap: 1e-4, ..Options::default() };
    let found = bound(&described.problem().unwrap(), &options, &mut |_, _| {}).unwrap();
    let (lower, upper) = (&found.lower.field, &found.upper.field);
    let statement = &described.statement;
    let mut weaker = statement.clone();
    weaker.members[0].tension = 0.9 * found.lower.value;
    assert!(matches!(prove_lower(&weaker, lower), Err(CertificateError::NotProven { .. })));
    let mut slippery = statement.clone();
    slippery.members[0].bond = 0.4;
    assert!(matches!(prove_lower(&slippery, lower), Err(CertificateError::NotProven { .. })));
    let less = prove_upper(&slippery, upper).unwrap();
    assert!((less - 0.8 * found.upper.value).abs() < 1e-4, "{less} {}", found.upper.value);
    let mut loose = statement.clone();
    loose.members[0].attached = [false; 2];
    assert!(matches!(prove_lower(&loose, lower), Err(CertificateError::BadField { .. })));
    // The same flow, in which a sheet without a hold stays with the head, proves the same.
    let none = prove_upper(&loose, upper).unwrap();
    assert!(none > found.upper.value - 1e-9, "{none}");
    let mut reversed = statement.clone();
    reversed.members[0].path.reverse();
    reversed.members[0].path.iter_mut().for_each(|side| *side = side.reversed());
    assert!(prove_lower(&reversed, lower).is_err() && prove_upper(&reversed, upper).is_err());

    let mut field = lower.clone();
    let kinked = |jet: &Jet| matches!(jet, Jet::Kinked { .. });
    let copy = field.copies.iter().position(|copy| kinked(&copy.jet)).unwrap();
    field.copies[copy].jet = Jet::Free { base: 0, f: 0.0, fx: 0.0, fy: 0.0 };
    assert!(matches!(prove_lower(statement, &field), Err(CertificateError::BadField { .. })));
    let mut field = upper.clone();
    field.members.pop();
    assert!(matches!(prove_upper(statement, &field), Err(CertificateError::Length { .. })));
    let mut field = upper.clone();
    let corner = field.members[0].corner;
    field.members[0].corner = (corner + 1) % 3;
    assert!(prove_upper(statement, &field).is_err());
    // Any other motion of the sheet costs more.
    let mut field = upper.clone();
    field.members[0].motion[1] = MemberMotion::Along { along: 0.5 };
    assert!(prove_upper(statement, &field).unwrap() > found.upper.value);
    let mut field = upper.clone();
    field.members[0].motion[1] = MemberMotion::Free { along: 0.0, across: 0.5 };
    assert!(prove_upper(statement, &field).is_err());
    // Ordinary numbers of files go back and forth.
    let text = serde_json::to_string(statement).unwrap();
    assert_eq!(serde_json::from_str::<soilctl_certificate::Statement>(&text).unwrap(), *statement);
}

/// What no proof covers is refused in words.
#[test]
fn members_that_no_proof_covers_are_refused() {
    let refused = |change: &dyn Fn(&mut Description), words: &str| {
        let mut it = cut(20.0, 1.0);
        change(&mut it);
        let error = it.described().unwrap_err().to_string();
        assert!(error.contains(words) && error.contains("member 1"), "{error}");
    };
    refused(&|it| it.members[0].line = vec![[0.0, 2.0], [60.0, 2.0]], "soil on both sides");
    refused(&|it| it.members[0].line.push([6.0, 1.0]), "straight");
    refused(&|it| it.members[0].attached = vec![MemberEnd::End], "attached");
    refused(&|it| it.members[0].attached = vec![MemberEnd::Start], "attached");
    refused(&|it| it.members[0].bond_factor = 0.0, "bond_factor");
    refused(&|it| it.members[0].tensile_kn_per_m = -1.0, "tensile_kn_per_m");
    refused(&|it| it.soils[0].cohesion_kpa = 0.0, "without cohesion");
    let drown = |it: &mut Description| {
        it.soils[0].cohesion_kpa = 0.0;
        it.water = Some(serde_json::from_value(serde_json::json!({"table": [[0.0, 50.0]]})).unwrap());
    };
    refused(&drown, "without cohesion");
    let crossing = MemberEntry { name: "nail".into(), ..sheet([[3.0, 1.0], [3.0, 3.0]], 5.0, 1.0) };
    let mut it = cut(20.0, 1.0);
    it.members.push(crossing);
    let error = it.described().unwrap_err().to_string();
    assert!(error.contains("member 2 (\"nail\")") && error.contains("meets"), "{error}");
    let mut it = tied_wall(30.0);
    it.default_boundary = Some(Kind::Far);
    it.boundaries.clear();
    it.boundaries.push(BoundaryEntry::on_sides(Kind::Free, &[Side::Top]));
    let error = it.described().unwrap_err().to_string();
    assert!(error.contains("far side"), "{error}");
}
