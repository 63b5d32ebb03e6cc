//! Fans: as many triangles as the angle asks for, spokes where guides leave, and a good mesh around them.

mod mesh_common;

use mesh_common::{check, holed, mesh, mesh_with_fans, plate, polygon, two_regions};
use soilctl_certificate::{Place, Statement};
use soilctl_limit_analysis::mesh::{Fan, Guide, Mesh, MeshError};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn corner(mesh: &Mesh, point: usize) -> usize {
    let found = mesh.vertices.iter().position(|v| v.place == Place::Corner { point });
    found.unwrap_or_else(|| panic!("no vertex at point {point}"))
}

/// Direction (degrees, 0 to 360) of an edge from a vertex.
fn direction(mesh: &Mesh, from: usize, to: usize) -> f64 {
    let [a, b] = [from, to].map(|v| mesh.vertices[v].position);
    (b[1] - a[1]).atan2(b[0] - a[0]).to_degrees().rem_euclid(360.0)
}

/// Checks the triangles at a corner, which make up a fan of the given radius, and returns for each the directions of
/// its two spokes in degrees, in order around the corner.
fn fan(mesh: &Mesh, point: usize, radius: f64) -> Vec<[f64; 2]> {
    let apex = corner(mesh, point);
    let mut sectors = Vec::new();
    for t in &mesh.triangles {
        let Some(i) = t.corners.iter().position(|&v| v == apex) else { continue };
        let ends = [t.corners[(i + 1) % 3], t.corners[(i + 2) % 3]];
        for v in ends {
            let length = distance(mesh.vertices[v].position, mesh.vertices[apex].position);
            assert!((length - radius).abs() < 1e-9 * radius, "a spoke of {length} for {radius}");
        }
        sectors.push(ends.map(|v| direction(mesh, apex, v)));
    }
    sectors.sort_by(|a, b| a[0].total_cmp(&b[0]));
    sectors
}

fn width(sector: [f64; 2]) -> f64 {
    (sector[1] - sector[0]).rem_euclid(360.0)
}

/// Lengths of the edges, relative to the fan's outer edges, of triangles that share a vertex with the fan but are not
/// in it.
fn around(mesh: &Mesh, point: usize, chord: f64) -> (f64, f64) {
    let apex = corner(mesh, point);
    let has = |t: &[usize; 3], v: usize| t.contains(&v);
    let ring: Vec<usize> =
        mesh.triangles.iter().filter(|t| has(&t.corners, apex)).flat_map(|t| t.corners).collect();
    let (mut least, mut most) = (f64::INFINITY, 0f64);
    for t in mesh.triangles.iter().map(|t| t.corners).filter(|t| !has(t, apex)) {
        if t.iter().any(|v| ring.contains(v)) {
            for i in 0..3 {
                let [a, b] = [t[i], t[(i + 1) % 3]].map(|v| mesh.vertices[v].position);
                least = least.min(distance(a, b) / chord);
                most = most.max(distance(a, b) / chord);
            }
        }
    }
    (least, most)
}

#[test]
fn all_round_the_tip_of_a_plate() {
    for degrees in [30f64, 60.0, 90.0, 120.0] {
        let tip = [degrees.to_radians().cos(), -degrees.to_radians().sin()];
        let outline = plate(tip);
        for (angle, count) in [(15.0, 24), (10.0, 36), (7.3, 50), (90.0, 4)] {
            let fans = [Fan { point: 5, radius: 0.1, angle: angle * DEGREE }];
            let chord = 0.2 * (0.5 * 360.0 / count as f64 * DEGREE).sin();
            // Wanted sizes much larger and somewhat smaller than the fan's edges.
            for size in [1.0, chord, 0.4 * chord] {
                let size = move |p| (size + 0.3 * distance(p, tip)).min(1.0);
                let made = mesh_with_fans(&outline, &[], &fans, &size).unwrap();
                check(&outline, &made);
                let sectors = fan(&made, 5, 0.1);
                assert_eq!(sectors.len(), count);
                assert!(sectors.iter().all(|&s| (width(s) - 360.0 / count as f64).abs() < 1e-6));
                assert!(made.guide_edges.is_empty());
                let (least, most) = around(&made, 5, chord);
                assert!(least > 0.6 && most < 1.9, "{degrees} {angle}: {least} to {most}");
                assert!(
                    outside_angle(&made, &[5]) > 20.0,
                    "{degrees} {angle}: {}",
                    outside_angle(&made, &[5])
                );
            }
        }
    }
}

/// Smallest angle (degrees) of triangles that are in no fan.
fn outside_angle(mesh: &Mesh, fans: &[usize]) -> f64 {
    let apexes: Vec<usize> = fans.iter().map(|&p| corner(mesh, p)).collect();
    let mut outside = mesh.clone();
    outside.triangles.retain(|t| !t.corners.iter().any(|v| apexes.contains(v)));
    outside.quality().min_angle_deg
}

#[test]
fn guides_leave_along_spokes() {
    let tip = [0.5, -0.8];
    let outline = plate(tip);
    let plate_at = direction_of([-0.5, 0.8]);
    for (first, second) in [(41.3, 97.7), (3.0, 200.1), (60.0, 70.0), (359.9, 181.0)] {
        // Straight, and bent beyond the fan; the second guide comes to the tip instead of leaving it.
        let at = |degrees: f64, r: f64| {
            let (sin, cos) = (degrees * DEGREE).sin_cos();
            [tip[0] + r * cos, tip[1] + r * sin]
        };
        let guides = [
            Guide { points: vec![tip, at(first, 4.0)] },
            Guide { points: vec![at(second + 30.0, 1.5), at(second, 0.3), at(second, 0.07), tip] },
        ];
        let fans = [Fan { point: 5, radius: 0.1, angle: 15.0 * DEGREE }];
        let made = mesh_with_fans(&outline, &guides, &fans, &|_| 0.3).unwrap();
        check(&outline, &made);
        let sectors = fan(&made, 5, 0.1);
        let apex = corner(&made, 5);
        let mut spokes: Vec<f64> = made
            .guide_edges
            .iter()
            .filter(|e| e.contains(&apex))
            .map(|e| direction(&made, apex, e[0] + e[1] - apex))
            .collect();
        spokes.sort_by(f64::total_cmp);
        let mut wanted = [first, second];
        wanted.sort_by(f64::total_cmp);
        assert_eq!(spokes.len(), 2);
        for i in 0..2 {
            assert!((spokes[i] - wanted[i]).abs() < 1e-6, "{spokes:?} for {wanted:?}");
        }
        // Between lines and guides, the triangles are equal, and as few as can be.
        let fixed = [plate_at, first, second];
        let next = |a: f64| {
            fixed.iter().map(|b| (b - a).rem_euclid(360.0)).filter(|w| *w > 1e-6).fold(360.0, f64::min)
        };
        let count: usize = fixed.iter().map(|&a| (next(a) / 15.0 - 1e-9).ceil() as usize).sum();
        assert_eq!(sectors.len(), count);
        for &a in &fixed {
            let first = sectors
                .iter()
                .find(|s| {
                    (s[0] - a + 180.0).rem_euclid(360.0) - 180.0 < 1e-6
                        && (s[0] - a + 180.0).rem_euclid(360.0) - 180.0 > -1e-6
                })
                .unwrap();
            let gap = next(a);
            assert!((width(*first) - gap / (gap / 15.0 - 1e-9).ceil()).abs() < 1e-6);
        }
        // The guides go on from the spokes.
        for (guide, degrees) in [(0, first), (1, second)] {
            let p = at(degrees, 0.1);
            let touching = made
                .guide_edges
                .iter()
                .filter(|e| e.iter().any(|&v| distance(made.vertices[v].position, p) < 1e-9));
            assert_eq!(touching.count(), 2, "guide {guide}");
        }
        assert!(outside_angle(&made, &[5]) > 20.0, "{}", outside_angle(&made, &[5]));
    }
}

fn direction_of(way: [f64; 2]) -> f64 {
    way[1].atan2(way[0]).to_degrees().rem_euclid(360.0)
}

#[test]
fn corners_of_the_boundary() {
    let outline = polygon(&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]);
    let fans = [
        Fan { point: 1, radius: 0.2, angle: 15.0 * DEGREE },
        Fan { point: 2, radius: 0.2, angle: 15.0 * DEGREE },
        Fan { point: 4, radius: 0.2, angle: 90.0 * DEGREE },
    ];
    let made = mesh_with_fans(&outline, &[], &fans, &|_| 0.4).unwrap();
    check(&outline, &made);
    for (point, count) in [(1, 12), (2, 6), (4, 1)] {
        let sectors = fan(&made, point, 0.2);
        assert_eq!(sectors.len(), count, "at point {point}");
        let each = sectors.iter().map(|&s| width(s)).sum::<f64>() / count as f64;
        assert!(sectors.iter().all(|&s| (width(s) - each).abs() < 1e-6));
    }
    assert!(outside_angle(&made, &[1, 2, 4]) > 20.0, "{}", outside_angle(&made, &[1, 2, 4]));
}

#[test]
fn the_top_of_a_plate_has_two_sectors_and_an_interface_another() {
    let outline = plate([0.5, -0.8]);
    let fans = [
        Fan { point: 3, radius: 0.05, angle: 15.0 * DEGREE },
        Fan { point: 5, radius: 0.05, angle: 10.0 * DEGREE },
    ];
    // A guide from corner to corner, one along the plate, and one that leaves the domain.
    let guides = [
        Guide { points: vec![[0.0, 0.0], [0.6, -0.3], [0.5, -0.8]] },
        Guide { points: vec![[0.5, -0.8], [0.0, 0.0]] },
        Guide { points: vec![[0.0, 0.0], [0.5, 0.8]] },
    ];
    let made = mesh_with_fans(&outline, &guides, &fans, &|_| 0.4).unwrap();
    check(&outline, &made);
    // The plate is at 58 degrees from one side of the surface: 4 and 9 triangles; the guide splits the 58 into
    // 26.6 and 31.4, which takes 2 and 3.
    assert_eq!(fan(&made, 3, 0.05).len(), 14);
    let ends: Vec<usize> = [3, 5].map(|p| corner(&made, p)).to_vec();
    for end in ends {
        assert_eq!(made.guide_edges.iter().filter(|e| e.contains(&end)).count(), 1);
    }
    assert!(outside_angle(&made, &[3, 5]) > 20.0, "{}", outside_angle(&made, &[3, 5]));
    let outline = two_regions();
    let fans = [1, 2].map(|point| Fan { point, radius: 0.1, angle: 15.0 * DEGREE });
    let made = mesh_with_fans(&outline, &[], &fans, &|_| 0.4).unwrap();
    check(&outline, &made);
    // The interface leans by atan(0.3) = 16.7 degrees.
    assert_eq!(fan(&made, 1, 0.1).len(), 5 + 8);
    assert_eq!(fan(&made, 2, 0.1).len(), 8 + 5);
}

#[test]
fn guides_that_pass_by_stop_and_those_through_the_corner_are_two() {
    let tip = [0.5, -0.8];
    let outline = plate(tip);
    let fans = [Fan { point: 5, radius: 0.1, angle: 15.0 * DEGREE }];
    let past = Guide { points: vec![[-1.0, -0.85], [2.0, -0.85]] };
    let made = mesh_with_fans(&outline, &[past], &fans, &|_| 0.2).unwrap();
    check(&outline, &made);
    assert_eq!(fan(&made, 5, 0.1).len(), 24);
    assert!(made.guide_edges.len() > 5);
    for v in made.guide_edges.iter().flatten() {
        assert!(distance(made.vertices[*v].position, tip) > 0.129);
    }
    let through = Guide { points: vec![[-1.0, -0.8], [2.0, -0.8]] };
    let made = mesh_with_fans(&outline, &[through], &fans, &|_| 0.2).unwrap();
    check(&outline, &made);
    let apex = corner(&made, 5);
    assert_eq!(made.guide_edges.iter().filter(|e| e.contains(&apex)).count(), 2);
    let length: f64 = made
        .guide_edges
        .iter()
        .map(|e| distance(made.vertices[e[0]].position, made.vertices[e[1]].position))
        .sum();
    assert!((length - 3.0).abs() < 1e-6, "{length}");
}

#[test]
fn the_radius_is_reduced_where_there_is_no_room() {
    let at = |outline: &Statement, points: &[usize], radii: &[f64]| {
        let fans: Vec<Fan> = points.iter().map(|&point| Fan { point, radius: 9.0, angle: 0.3 }).collect();
        let made = mesh_with_fans(outline, &[], &fans, &|_| 5.0).unwrap();
        check(outline, &made);
        for (&point, &radius) in points.iter().zip(radii) {
            fan(&made, point, radius);
        }
        assert!(outside_angle(&made, points) > 18.0, "{}", outside_angle(&made, points));
    };
    let outline = plate([0.5, -0.8]);
    let length = 0.89f64.sqrt();
    // Half of the way to another corner; a third of that to another fan; half of that to a line.
    at(&outline, &[5], &[0.4]);
    at(&outline, &[3], &[0.5 * length]);
    at(&outline, &[3, 5], &[length / 3.0, length / 3.0]);
    at(&holed(), &[4, 5, 6, 7], &[1.0 / 3.0; 4]);
}

#[test]
fn what_is_no_fan_is_refused() {
    let mut outline = plate([0.5, -0.8]);
    outline.points.push([3.0, 0.0]);
    let good = Fan { point: 5, radius: 0.1, angle: 0.2 };
    let refused = |fans: &[Fan]| mesh_with_fans(&outline, &[], fans, &|_| 1.0).unwrap_err();
    for (fan, what) in [
        (Fan { point: 6, ..good }, "the point"),
        (Fan { point: 7, ..good }, "the point"),
        (Fan { radius: 0.0, ..good }, "the radius"),
        (Fan { radius: f64::NAN, ..good }, "the radius"),
        (Fan { radius: f64::INFINITY, ..good }, "the radius"),
        (Fan { angle: 0.0, ..good }, "the angle"),
        (Fan { angle: 1.6, ..good }, "the angle"),
        (Fan { angle: f64::NAN, ..good }, "the angle"),
    ] {
        let error = refused(&[Fan { point: 4, ..good }, fan]);
        let MeshError::BadFan { fan: 1, what: found, .. } = error else { panic!("{error}") };
        assert_eq!(what, found);
    }
    assert!(matches!(refused(&[good, good]), MeshError::BadFan { fan: 1, what: "the point", .. }));
    assert!(matches!(refused(&[Fan { radius: 1e-9, ..good }]), MeshError::BadFan { fan: 0, .. }));
    assert!(matches!(refused(&[good; 1001]), MeshError::TooMuch { what: "fans", .. }));
}

#[test]
fn without_fans_nothing_changes_and_with_them_bits_repeat() {
    let outline = plate([0.5, -0.8]);
    let guides = [Guide { points: vec![[-1.0, 0.0], [0.5, -0.8], [2.0, 0.0]] }];
    let size = |p| 0.05 + 0.1 * distance(p, [0.5, -0.8]);
    let plain = mesh(&outline, &guides, &size).unwrap();
    assert_eq!(plain, mesh_with_fans(&outline, &guides, &[], &size).unwrap());
    let fans = [Fan { point: 5, radius: 0.1, angle: 0.2 }];
    let fanned = mesh_with_fans(&outline, &guides, &fans, &size).unwrap();
    assert_eq!(fanned, mesh_with_fans(&outline, &guides, &fans, &size).unwrap());
}
