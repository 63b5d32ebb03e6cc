//! Meshes of cells: they tile what they shall, and columns follow the plate.

#![allow(clippy::unwrap_used)]

mod mesh_common;

use mesh_common::check;
use soilctl_limit_analysis::mesh::structured::{Below, PlateBlock, block, graded, plate_block, rectangle};
use soilctl_limit_analysis::mesh::{MeshError, Place};

#[test]
fn a_rectangle_has_equal_cells() {
    let (outline, mesh) = rectangle(&[0.0, 1.0, 2.0, 3.0], &[0.0, -1.0, -2.0]).unwrap();
    check(&outline, &mesh);
    assert_eq!(mesh.triangles.len(), 4 * 3 * 2);
    assert_eq!(mesh.vertices.len(), 4 * 3 + 6);
    let quality = mesh.quality();
    assert!((quality.min_angle_deg - 45.0).abs() < 1e-12);
    assert_eq!((quality.shortest_edge, quality.longest_edge), (0.5f64.sqrt(), 1.0));
    assert_eq!(mesh.lines.iter().map(Vec::len).collect::<Vec<_>>(), [3, 4, 3, 4]);
    let (outline, mesh) = rectangle(&[0.1, 0.2], &[0.7, 0.3]).unwrap();
    check(&outline, &mesh);
    assert_eq!(mesh.triangles.len(), 4);
}

#[test]
fn a_block_has_straight_grid_lines() {
    let corners = [[0.0, 3.0], [-1.0, 0.0], [4.0, -1.0], [3.0, 2.5]];
    let (outline, mesh) = block(corners, &[0.0, 0.1, 0.4, 1.0], &[0.0, 0.5, 0.8, 1.0]).unwrap();
    check(&outline, &mesh);
    assert_eq!(mesh.triangles.len(), 36);
    assert_eq!(outline.points, corners);
    for clockwise_or_bent in
        [[corners[0], corners[3], corners[2], corners[1]], [corners[0], [2.5, 1.9], corners[2], corners[3]]]
    {
        assert!(block(clockwise_or_bent, &[0.0, 0.5, 1.0], &[0.0, 0.5, 1.0]).is_err());
    }
}

/// A plate of unit length at an angle (degrees), with a block as wide as given.
fn plate(
    degrees: f64,
    below: Below,
    parallel: [f64; 2],
) -> (Vec<[f64; 2]>, Vec<f64>, soilctl_limit_analysis::mesh::Mesh) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let mut columns = graded(-4.0, 0.0, 8, 0.8).unwrap();
    columns.extend(&graded(0.0, 9.0, 12, 1.1).unwrap()[1..]);
    let mut rows = graded(0.0, -sin, 5, 0.9).unwrap();
    rows.extend(&graded(-sin, -2.5, 6, 1.2).unwrap()[1..]);
    let request = PlateBlock { columns: &columns, rows: &rows, top: 0.0, tip: [cos, -sin], parallel, below };
    let (outline, mesh) = plate_block(&request).unwrap();
    check(&outline, &mesh);
    assert_eq!(mesh.triangles.len(), 4 * 20 * 11);
    assert_eq!(outline.points, [[-4.0, 0.0], [-4.0, -2.5], [9.0, -2.5], [9.0, 0.0], [0.0, 0.0], [cos, -sin]]);
    let corner = (0..12).flat_map(|j| (0..21).map(move |i| j * 21 + i)).map(|v| mesh.vertices[v].position);
    (corner.collect(), columns, mesh)
}

#[test]
fn columns_follow_the_plate() {
    for degrees in [30f64, 60.0, 90.0, 120.0] {
        let slope = 1.0 / degrees.to_radians().tan();
        for below in [Below::Vertical, Below::Parallel] {
            let (corners, columns, mesh) = plate(degrees, below, [1.0, 2.0]);
            assert_eq!(mesh.lines[4].len(), 6);
            for (row, line) in corners.chunks(21).enumerate() {
                for (column, p) in line.iter().enumerate() {
                    let depth =
                        if below == Below::Vertical && row > 5 { degrees.to_radians().sin() } else { -p[1] };
                    let shift = p[0] - columns[column];
                    if (-1.0..=2.0).contains(&columns[column]) {
                        assert!((shift - slope * depth).abs() < 1e-12, "column {column}, row {row}");
                    } else {
                        assert!(shift.abs() <= (slope * depth).abs() + 1e-12);
                    }
                }
                assert_eq!((line[0][0], line[20][0]), (-4.0, 9.0));
            }
        }
    }
}

#[test]
fn slits_have_soil_on_both_sides() {
    let (_, _, mesh) = plate(45.0, Below::Vertical, [0.0, 0.0]);
    // The plate's top has cells of both sides, its tip is surrounded.
    let sides = |v: usize| mesh.triangles.iter().filter(|t| t.corners.contains(&v)).count();
    let (top, tip) = (mesh.lines[4][0], mesh.lines[4][5]);
    assert_eq!(mesh.vertices[tip].place, Place::Corner(5));
    assert_eq!((sides(top), sides(tip)), (4, 8));
}

#[test]
fn lists_are_graded() {
    let list = graded(1.0, 8.0, 3, 2.0).unwrap();
    for (value, wanted) in list.iter().zip([1.0, 2.0, 4.0, 8.0]) {
        assert!((value - wanted).abs() < 1e-12, "{list:?}");
    }
    let back = graded(8.0, 1.0, 3, 0.5).unwrap();
    for (value, wanted) in back.iter().zip([8.0, 4.0, 2.0, 1.0]) {
        assert!((value - wanted).abs() < 1e-12, "{back:?}");
    }
    assert!(graded(0.0, 1.0, 1000, 1e300).is_ok());
    for (to, count, ratio) in [(1.0, 0, 1.0), (1.0, 2_000_000, 1.0), (1.0, 3, 0.0), (f64::NAN, 3, 1.0)] {
        assert!(matches!(graded(0.0, to, count, ratio), Err(MeshError::BadGrid { .. })));
    }
}

#[test]
fn what_is_no_grid_is_refused() {
    let refused = |columns: &[f64], rows: &[f64], place: usize| {
        let error = rectangle(columns, rows).unwrap_err();
        assert!(matches!(error, MeshError::BadGrid { index, .. } if index == place), "{error}");
    };
    refused(&[], &[0.0, -1.0], 0);
    refused(&[0.0, 1.0], &[0.0], 0);
    refused(&[0.0, 1.0, 1.0], &[0.0, -1.0], 2);
    refused(&[0.0, 1.0], &[0.0, 1.0], 1);
    refused(&[0.0, f64::NAN], &[0.0, -1.0], 1);
    refused(&[0.0, f64::INFINITY], &[0.0, -1.0], 1);
    let long: Vec<f64> = (0..1100).map(f64::from).collect();
    let down: Vec<f64> = long.iter().map(|c| -c).collect();
    assert!(matches!(rectangle(&long, &down), Err(MeshError::TooManyTriangles { .. })));
    let (columns, rows) = ([-1.0, 0.0, 1.0], [0.0, -1.0, -2.0]);
    let good = PlateBlock {
        columns: &columns,
        rows: &rows,
        top: 0.0,
        tip: [0.5, -1.0],
        parallel: [0.5; 2],
        below: Below::Vertical,
    };
    assert!(plate_block(&good).is_ok());
    for bad in [
        PlateBlock { top: 0.1, ..good },
        PlateBlock { top: 1.0, ..good },
        PlateBlock { tip: [0.5, -0.9], ..good },
        PlateBlock { tip: [0.5, -2.0], ..good },
        PlateBlock { parallel: [1.0, 0.5], ..good },
        PlateBlock { parallel: [0.5, f64::NAN], ..good },
    ] {
        assert!(matches!(plate_block(&bad), Err(MeshError::BadGrid { .. })));
    }
    // Too near to the side, or through it.
    assert!(plate_block(&PlateBlock { tip: [1.0, -1.0], ..good }).is_err());
    assert!(plate_block(&PlateBlock { tip: [1.5, -1.0], ..good }).is_err());
    assert!(plate_block(&PlateBlock { tip: [0.6, -1.0], below: Below::Parallel, ..good }).is_err());
}
