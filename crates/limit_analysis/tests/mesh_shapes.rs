//! Meshes of the shapes that problems have: plates, interfaces, holes, wedges, guides.

mod mesh_common;

use mesh_common::{check, fraction_of_size, holed, mesh, plate, polygon, two_regions};
use soilctl_certificate::{Line, LineUse, Statement};
use soilctl_limit_analysis::mesh::{Guide, MeshError, Request, generate};

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn plate_graded_to_its_tip() {
    for degrees in [20f64, 30.0, 45.0, 60.0, 75.0, 90.0, 110.0, 135.0] {
        let tip = [degrees.to_radians().cos(), -degrees.to_radians().sin()];
        let size = |p| (0.02 + 0.2 * distance(p, tip)).min(1.0);
        let outline = plate(tip);
        let mesh = mesh(&outline, &[], &size).unwrap();
        check(&outline, &mesh);
        let quality = mesh.quality();
        assert!(quality.min_angle_deg >= degrees.min(22.0) - 1e-9, "{degrees}: {quality:?}");
        assert!(quality.shortest_edge > 0.012 && quality.longest_edge < 1.6, "{degrees}: {quality:?}");
        assert!(fraction_of_size(&mesh, &size) > 0.95, "{degrees}");
        // Integral of 1 / (0.433 size^2) over the box.
        let mut wanted = 0.0;
        for i in 0..1500 {
            for j in 0..300 {
                wanted +=
                    1e-4 / (0.433 * size([-3.0 + 0.01 * (i as f64 + 0.5), -0.01 * (j as f64 + 0.5)]).powi(2));
            }
        }
        let ratio = quality.triangles as f64 / wanted;
        assert!((0.75..1.35).contains(&ratio), "{degrees}: {} triangles for {wanted}", quality.triangles);
    }
}

#[test]
fn interface_and_hole() {
    for (outline, size) in [(two_regions(), 0.1), (holed(), 0.25)] {
        let size = move |_| size;
        let mesh = mesh(&outline, &[], &size).unwrap();
        check(&outline, &mesh);
        assert!(mesh.quality().min_angle_deg > 22.0, "{:?}", mesh.quality());
        assert!(fraction_of_size(&mesh, &size) > 0.95);
    }
}

#[test]
fn coarse_meshes_are_as_coarse_as_the_outline() {
    let outline = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let mesh = mesh(&outline, &[], &|_| f64::INFINITY).unwrap();
    check(&outline, &mesh);
    assert!(mesh.triangles.len() <= 4);
}

#[test]
fn slits_may_float_and_branch() {
    let mut outline = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
    outline.points.extend([[1.0, 2.0], [2.0, 2.1], [2.7, 3.0], [2.9, 1.2]]);
    outline.lines.extend([Line { from: 4, to: 5 }, Line { from: 6, to: 5 }, Line { from: 5, to: 7 }]);
    let used = |line, forward| LineUse { line, forward };
    let around =
        vec![used(4, true), used(6, true), used(6, false), used(5, false), used(5, true), used(4, false)];
    outline.regions[0].loops.push(around);
    let size = |p| 0.03 + 0.2 * distance(p, [2.9, 1.2]);
    let mesh = mesh(&outline, &[], &size).unwrap();
    check(&outline, &mesh);
    assert!(mesh.quality().min_angle_deg > 20.0, "{:?}", mesh.quality());
}

#[test]
fn sharp_corners_and_narrow_gaps_end() {
    let wedge = polygon(&[[0.0, 0.0], [5.0, -0.2], [5.0, 0.2]]);
    let gap = polygon(&[
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.501, 1.0],
        [0.501, 0.2],
        [0.5, 0.2],
        [0.5, 1.0],
        [0.0, 1.0],
    ]);
    let bar = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.002], [0.0, 0.002]]);
    for (outline, least) in [(wedge, 4.5), (gap, 20.0), (bar, 20.0)] {
        for size in [10.0, 0.3, 0.05] {
            let mesh = mesh(&outline, &[], &|_| size).unwrap();
            check(&outline, &mesh);
            let quality = mesh.quality();
            assert!(quality.min_angle_deg > least && quality.triangles < 12_000, "{size} {quality:?}");
        }
    }
}

#[test]
fn rough_sizes_are_graded() {
    let outline = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    // A checkerboard of sizes 1 : 100.
    let size = |p: [f64; 2]| if ((4.0 * p[0]) as i32 + (4.0 * p[1]) as i32) % 2 == 0 { 0.5 } else { 0.005 };
    let mesh = mesh(&outline, &[], &size).unwrap();
    check(&outline, &mesh);
    assert!(mesh.quality().min_angle_deg > 20.0, "{:?}", mesh.quality());
}

/// Total length of the guide edges, and their largest distance from the segment `a` to `b`.
fn along(mesh: &soilctl_limit_analysis::mesh::Mesh, a: [f64; 2], b: [f64; 2]) -> (f64, f64) {
    let (mut length, mut off) = (0.0, 0f64);
    for e in &mesh.guide_edges {
        let p = e.map(|v| mesh.vertices[v].position);
        length += distance(p[0], p[1]);
        for q in p {
            let cross = (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
            off = off.max(cross.abs() / distance(a, b));
        }
    }
    (length, off)
}

#[test]
fn guides_are_followed_across_lines_and_beyond_the_outline() {
    let tip = [0.5, -0.8];
    let outline = plate(tip);
    let size = |p| (0.05 + 0.2 * distance(p, tip)).min(0.5);
    // From outside, through the surface, the plate's tip, and the base.
    let (a, b) = ([1.3, 0.4], [0.5 - 2.5 / 1.5, -3.3]);
    let guides = [Guide { points: vec![a, b] }];
    let through = mesh(&outline, &guides, &size).unwrap();
    check(&outline, &through);
    let (length, off) = along(&through, a, b);
    let inside = 3.0 * distance(a, b) / 3.7;
    assert!((length - inside).abs() < 1e-6 && off < 1e-9, "{length} for {inside}, off by {off}");
    // Across the plate in its middle.
    let guides = [Guide { points: vec![[-1.5, -0.9], [2.0, -0.5]] }];
    let across = mesh(&outline, &guides, &size).unwrap();
    check(&outline, &across);
    let (length, off) = along(&across, guides[0].points[0], guides[0].points[1]);
    assert!(
        (length - distance(guides[0].points[0], guides[0].points[1])).abs() < 1e-6 && off < 1e-9,
        "{length} {off}"
    );
    assert!(across.quality().min_angle_deg > 20.0, "{:?}", across.quality());
}

#[test]
fn guides_too_close_to_anything_give_way() {
    let outline = plate([0.5, -0.8]);
    let size = |_| 0.2;
    let curve = |offset: f64| Guide {
        points: (0..50)
            .map(|i| [-2.0 + 0.1 * i as f64, offset - 1.0 - 0.5 * (0.06 * i as f64).sin()])
            .collect(),
    };
    let mut guides: Vec<Guide> = (0..10).map(|i| curve(0.013 * i as f64)).collect();
    guides.push(Guide { points: vec![[-3.0, -0.01], [12.0, 0.01]] });
    guides.push(Guide { points: vec![[0.0, 0.0], [0.5, -0.81]] });
    guides.push(Guide { points: vec![[0.0, 0.0]] });
    guides.push(Guide { points: vec![[1.0, -1.0], [1.0, -1.0]] });
    guides.push(Guide { points: vec![[100.0, -1.0], [200.0, -1.0]] });
    guides.push(Guide { points: vec![[-1e20, -2.5], [1e20, -2.4], [-1e5, -2.0]] });
    guides.push(Guide::default());
    let mesh = mesh(&outline, &guides, &size).unwrap();
    check(&outline, &mesh);
    assert!(mesh.quality().min_angle_deg > 15.0, "{:?}", mesh.quality());
    assert!(mesh.quality().shortest_edge > 0.05, "{:?}", mesh.quality());
}

#[test]
fn the_same_request_gives_the_same_bits() {
    let outline: Statement = plate([0.5, -0.8]);
    let guides = [Guide { points: vec![[-1.0, 0.0], [0.5, -0.8], [2.0, 0.0]] }];
    let size = |p| 0.02 + 0.1 * distance(p, [0.5, -0.8]);
    assert_eq!(mesh(&outline, &guides, &size).unwrap(), mesh(&outline, &guides, &size).unwrap());
}

#[test]
fn too_many_triangles_and_bad_sizes_are_refused() {
    let outline = plate([0.5, -0.8]);
    for size in [0.02, 1e-4, 1e-300] {
        let request = Request {
            statement: &outline,
            guides: &[],
            fans: &[],
            size: &move |_| size,
            max_triangles: 1000,
        };
        let error = generate(&request).unwrap_err();
        assert!(matches!(error, MeshError::TooManyTriangles { limit: 1000, .. }), "{error}");
    }
    for size in [0.0, -1.0, f64::NAN] {
        assert!(matches!(mesh(&outline, &[], &move |_| size).unwrap_err(), MeshError::BadSize { .. }));
    }
    let guides = [Guide { points: vec![[0.0, 0.0], [f64::NAN, 0.0]] }];
    let error = mesh(&outline, &guides, &|_| 1.0).unwrap_err();
    assert!(matches!(error, MeshError::BadGuide { guide: 0, point: 1, .. }));
}
