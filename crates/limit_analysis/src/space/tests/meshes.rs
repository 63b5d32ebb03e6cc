//! Meshes fill the box, stay conforming when they are bisected, and keep to the planes of box and plate when they are shaken.

use std::collections::BTreeMap;

use super::super::complex::Complex;
use super::super::region::{GRAIN, Region};
use super::super::shake::{shake, volume};
use super::super::simplices::Simplices;

/// Some tetrahedra bisected, several times.
fn bisected(region: &Region) -> Simplices<3, 4> {
    let mut mesh = region.first();
    for round in 0..3 {
        let from = mesh.vertices.len();
        (0..mesh.cells.len()).filter(|cell| cell % 7 == round).for_each(|cell| mesh.cut(cell));
        shake(&mut mesh, region, from);
    }
    mesh
}

#[test]
fn bisected_tetrahedra_fill_the_box_and_meet_in_whole_faces() {
    for (phi_deg, width) in [(30.0, 5.0), (40.0, 1.0), (20.0, 0.3)] {
        let region = Region::new(phi_deg, width);
        let mesh = bisected(&region);
        let size: f64 = region.planes.iter().map(|planes| planes[planes.len() - 1] - planes[0]).product();
        let sum: f64 = (0..mesh.cells.len()).map(|cell| volume(&mesh, cell).abs() / 6.0).sum();
        assert!((sum - size).abs() < 1e-10 * size, "{sum} {size}");
        assert!((0..mesh.cells.len()).all(|cell| volume(&mesh, cell) != 0.0));
        let mut faces: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        for cell in &mesh.cells {
            for out in 0..4 {
                let mut face: Vec<usize> = (0..4).filter(|&k| k != out).map(|k| cell[k]).collect();
                face.sort_unstable();
                *faces.entry([face[0], face[1], face[2]]).or_default() += 1;
            }
        }
        for (face, count) in faces {
            let in_plane = (0..3).any(|axis| {
                let planes = &region.planes[axis];
                let all = |end: f64| face.iter().all(|&c| mesh.vertices[c][axis] == end);
                all(planes[0]) || all(planes[planes.len() - 1])
            });
            assert!(count == if in_plane { 1 } else { 2 }, "{face:?} {count}");
        }
    }
}

#[test]
fn faces_cover_the_plate_once() {
    let region = Region::new(33.0, 4.0);
    let complex = Complex::new(&bisected(&region));
    let area: f64 = complex.plates().map(|[face, _]| 0.5 * complex.faces[face].normal[0].abs()).sum();
    assert!((area + region.planes[1][0]).abs() < 1e-12, "{area}");
    // Where halves are exact, as the section needs it.
    for place in &complex.places {
        for axis in [0, 2] {
            assert_eq!((place[axis] / GRAIN).fract(), 0.0);
        }
    }
}

#[test]
fn what_is_cut_until_it_is_short_is_short() {
    let mut mesh = Region::new(30.0, 5.0).first();
    mesh.cut_until(|[x, ..]| 0.5 + 0.2 * x.abs());
    for cell in 0..mesh.cells.len() {
        assert!(mesh.length(cell) <= 0.5 + 0.2 * mesh.centroid(cell)[0].abs());
    }
}
