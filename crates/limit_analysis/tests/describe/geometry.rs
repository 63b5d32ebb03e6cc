use soilctl_certificate::{Condition, Objective};
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{
    Aim, BoundaryEntry, Hold, Interface, Kind, PlateEntry, Profile, Quantity, Side, StructureEntry,
};

use crate::common::{area, described, length, region, soil};

fn is_face(c: &Condition) -> bool {
    matches!(c, Condition::Face { .. })
}

fn is_free(c: &Condition) -> bool {
    *c == Condition::Free
}

#[test]
fn a_footing_is_in_units_of_its_width() {
    let described = described(&Description::strip_footing(soil("sand", 30.0, 5.0), 2.0, 20.0, 1.0));
    let s = &described.statement;
    assert_eq!((described.length_m, described.stress_kpa), (2.0, 36.0));
    assert_eq!(described.quantity, Quantity::ForceKnPerM);
    assert_eq!(s.objective, Objective::Structure { velocity: [0.0, -1.0] });
    assert_eq!((s.datum, s.surcharge, s.gravity), (0.0, 0.0, [0.0, -1.0]));
    let m = s.regions[0].material.clone();
    assert_eq!((m.unit_weight, m.cohesion.at_origin), (1.0, 5.0 / 36.0));
    assert_eq!(length(s, is_face), 1.0);
    assert_eq!(length(s, is_free), 15.0);
    assert_eq!(length(s, |c| *c == Condition::Far), 8.0 + 16.0 + 8.0);
    let [lower, upper] = described.in_units([1.0, 1.0]);
    assert!(lower <= 72.0 && 72.0 <= upper && upper - lower < 1e-12);
}

#[test]
fn polygons_may_run_either_way_round_and_share_edges_cut_differently() {
    let mut d = Description::level_ground(soil("clay", 0.0, 10.0), 4.0, 2.0);
    d.regions = vec![
        region("clay", &[[-4.0, -1.0], [4.0, -1.0], [4.0, 0.0], [-4.0, 0.0]]),
        // Clockwise, with two corners on the edge of the first one, one of them off by rounding.
        region("clay", &[[-4.0, -2.0], [-4.0, -1.0], [-1.0, -1.0 + 1e-10], [4.0, -1.0], [4.0, -2.0]]),
    ];
    d.boundaries.push(BoundaryEntry {
        pressure_kpa: Some(Profile::Uniform(1.0)),
        live: true,
        ..BoundaryEntry::on_line(Kind::Load, &[[-1.0, 0.0], [1.0, 0.0]])
    });
    let s = described(&d).statement;
    assert_eq!(s.regions.len(), 2);
    // The load is as wide as the unit of length.
    assert!((area(&s, 0) - 2.0).abs() < 1e-12 && (area(&s, 1) - 2.0).abs() < 1e-12);
    // Two common lines, both level.
    let common: Vec<_> =
        s.lines.iter().filter(|l| [l.from, l.to].iter().all(|p| s.points[*p][1] == -0.5)).collect();
    assert_eq!(common.len(), 2);
}

#[test]
fn a_plate_is_a_slit_with_a_face_on_each_side() {
    let mut d = Description::embedded_plate(soil("sand", 35.0, 0.0), 70.0, 0.5, 20.0);
    d.plates[0].right = Some(Interface { delta_deg: 10.0, adhesion_kpa: 0.0 });
    // It sticks out of the ground.
    d.plates[0].line[0] = [-0.5 * 70.0_f64.to_radians().cos(), 0.5 * 70.0_f64.to_radians().sin()];
    let s = described(&d).statement;
    let faces: Vec<_> = s.boundaries.iter().filter(|b| is_face(&b.condition)).collect();
    assert_eq!(faces.len(), 2);
    assert_eq!(faces[0].line, faces[1].line);
    for face in faces {
        let line = s.lines[face.line];
        let (from, to) = if face.forward { (line.from, line.to) } else { (line.to, line.from) };
        // Walked downwards, the soil on the left is ahead of the plate.
        let downwards = s.points[to][1] < s.points[from][1];
        let delta = if downwards { 20.0 } else { 10.0 };
        assert_eq!(face.condition, Condition::Face { delta_deg: delta, adhesion: 0.0 });
    }
    assert!((length(&s, is_face) - 2.0 * 0.5 / (0.5 * 70.0_f64.to_radians().sin())).abs() < 1e-12);
}

#[test]
fn a_buried_plate_is_a_hole_without_area() {
    let mut d = Description::level_ground(soil("sand", 35.0, 2.0), 4.0, 4.0);
    let line = vec![[-0.5, -1.0], [0.0, -1.1], [0.5, -1.0]];
    d.plates = vec![PlateEntry { name: "anchor".into(), line, delta_deg: 10.0, ..PlateEntry::default() }];
    d.objective = Aim::Structure { name: "anchor".into(), direction: [0.0, 3.0] };
    let s = described(&d).statement;
    assert_eq!(s.regions[0].loops.len(), 2);
    assert_eq!(s.regions[0].loops[1].len(), 4);
    assert!((area(&s, 0) - 32.0).abs() < 1e-12);
    assert_eq!(s.objective, Objective::Structure { velocity: [0.0, 1.0] });
}

#[test]
fn a_block_is_cut_out_of_all_soils_that_it_covers() {
    let mut d = Description::level_ground(soil("sand", 30.0, 1.0), 4.0, 4.0);
    d.soils.push(soil("clay", 0.0, 20.0));
    d.regions = vec![
        region("sand", &[[-4.0, -1.0], [4.0, -1.0], [4.0, 0.0], [-4.0, 0.0]]),
        region("clay", &[[-4.0, -4.0], [4.0, -4.0], [4.0, -1.0], [-4.0, -1.0]]),
    ];
    let in_soil = vec![soilctl_limit_analysis::describe::SoilInterface {
        soil: "clay".into(),
        delta_deg: 0.0,
        adhesion_kpa: 5.0,
    }];
    d.structures = vec![StructureEntry {
        name: "block".into(),
        polygon: vec![[-0.5, -1.5], [-0.5, -0.5], [0.5, -0.5], [0.5, -1.5]],
        delta_deg: 15.0,
        in_soil,
        ..StructureEntry::default()
    }];
    d.objective = Aim::Structure { name: "block".into(), direction: [1.0, 0.0] };
    let s = described(&d).statement;
    assert!((area(&s, 0) + area(&s, 1) - (32.0 - 1.0)).abs() < 1e-12);
    assert!((length(&s, is_face) - 4.0).abs() < 1e-12);
    let sticky = length(&s, |c| matches!(c, Condition::Face { delta_deg: 0.0, adhesion } if *adhesion > 0.0));
    assert!((sticky - 2.0).abs() < 1e-12);
}

#[test]
fn a_second_structure_is_held() {
    let mut d = Description::strip_footing(soil("sand", 30.0, 1.0), 2.0, 20.0, 0.0);
    d.structures.push(StructureEntry {
        name: "tunnel".into(),
        polygon: vec![[-1.0, -5.0], [1.0, -5.0], [1.0, -3.0], [-1.0, -3.0]],
        held: Some(Hold::Fixed),
        ..StructureEntry::default()
    });
    let s = described(&d).statement;
    assert_eq!(s.regions[0].loops.len(), 2);
    assert!((length(&s, |c| *c == Condition::Fixed) - 4.0).abs() < 1e-12);
}

#[test]
fn loads_vary_along_their_line_and_shear_points_along_it() {
    let clay = || soil("clay", 0.0, 10.0);
    for reversed in [false, true] {
        let mut line = vec![[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0]];
        if reversed {
            line.reverse();
        }
        let mut d = Description::level_ground(clay(), 4.0, 4.0);
        d.boundaries.push(BoundaryEntry {
            pressure_kpa: Some(Profile::Linear([18.0, 36.0])),
            shear_kpa: Some(Profile::Uniform(9.0)),
            live: true,
            ..BoundaryEntry::on_line(Kind::Load, &line)
        });
        let s = described(&d).statement;
        let mut loaded = 0;
        for b in &s.boundaries {
            let Condition::Loaded { pressure, shear, live } = b.condition else { continue };
            loaded += 1;
            assert!(live);
            let l = s.lines[b.line];
            for (end, point) in [l.from, l.to].into_iter().enumerate() {
                // The unit of length is 2 m, that of stress 36 kPa.
                let x = 2.0 * s.points[point][0] * if reversed { -1.0 } else { 1.0 };
                assert!((pressure[end] - (18.0 + 18.0 * (x + 1.0) / 2.0) / 36.0).abs() < 1e-12);
                // Walked with the soil on the left, the surface runs to the left.
                let along = if reversed { 0.25 } else { -0.25 };
                assert_eq!(shear[end], along);
            }
        }
        assert_eq!(loaded, 2);
    }
}

#[test]
fn lines_take_precedence_over_sides_and_sides_over_the_default() {
    let mut d = Description::slope(soil("clay", 0.0, 20.0), 4.0, 45.0);
    d.boundaries = vec![
        BoundaryEntry::on_sides(Kind::Fixed, &[Side::Left, Side::Right, Side::Bottom]),
        BoundaryEntry::on_line(Kind::Smooth, &[[-12.0, -4.0], [-12.0, -1.0]]),
        BoundaryEntry::on_sides(Kind::Free, &[Side::Top]),
    ];
    d.default_boundary = None;
    let described = described(&d);
    let s = &described.statement;
    assert_eq!(described.length_m, 4.0);
    assert!((length(s, |c| *c == Condition::Smooth) - 0.75).abs() < 1e-12);
    assert!((length(s, is_free) - (3.0 + 2.0_f64.sqrt() + 4.0)).abs() < 1e-12);
    assert_eq!(s.gravity, [0.0, -1.0]);
    assert_eq!(s.objective, Objective::Everything);
}

#[test]
fn a_sheet_pile_has_one_face_above_the_dredge_line_and_two_below() {
    let mut d = Description::level_ground(soil("sand", 30.0, 0.0), 10.0, 10.0);
    d.regions = vec![
        region("sand", &[[-10.0, -10.0], [0.0, -10.0], [0.0, -3.0], [-10.0, -3.0]]),
        region("sand", &[[0.0, -10.0], [10.0, -10.0], [10.0, 0.0], [0.0, 0.0]]),
    ];
    d.plates = vec![PlateEntry {
        name: "pile".into(),
        line: vec![[0.0, 0.0], [0.0, -6.0]],
        delta_deg: 15.0,
        ..PlateEntry::default()
    }];
    d.objective = Aim::Structure { name: "pile".into(), direction: [-1.0, 0.0] };
    // Bare ground at two heights is beyond the checker, but it is a sound statement.
    let found = d.described().unwrap();
    let refusals = crate::common::refusals(&found.statement);
    assert!(refusals.iter().all(|e| matches!(e, soilctl_certificate::CertificateError::NotCovered { .. })));
    assert!((length(&found.statement, is_face) * found.length_m - 9.0).abs() < 1e-12);
}

/// Where the zero of heights is makes no difference, to the last bit where it does not round.
#[test]
fn a_problem_lifted_is_the_same_statement() {
    let it = Description::strip_footing(soil("sand", 30.0, 1.0), 2.0, 20.0, 0.5);
    let mut lifted = it.clone();
    let points = lifted.regions.iter_mut().flat_map(|r| &mut r.polygon);
    let edges = lifted.structures.iter_mut().flat_map(|s| &mut s.edge);
    points.chain(edges).for_each(|p| p[1] += 4.0);
    assert_eq!(described(&it).statement, described(&lifted).statement);
}
