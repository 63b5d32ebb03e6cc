//! The section between the ends: triangles within the faces of tetrahedra on the side of the box, whose pressure is that across.

use std::collections::BTreeMap;

use soilctl_conic::Form;

use super::adapt::Lengths;
use super::complex::Complex;
use super::element::Point;
use super::sheets::Sheets;
use super::simplices::Simplices;

/// The faces on the side of the box where s is least, as triangles of x and z, cut until none is longer than allowed. The parent of
/// each is its face.
pub(super) fn cut(complex: &Complex<3, 4>, lengths: &Lengths) -> Simplices<2, 3> {
    let mut numbers = BTreeMap::new();
    let mut vertices = Vec::new();
    let (mut cells, mut parents) = (Vec::new(), Vec::new());
    for (number, face) in complex.faces.iter().enumerate() {
        let on_side = |&c: &usize| complex.places[c][1] == complex.low[1];
        if face.rim != Some(1) || !face.corners.iter().all(on_side) {
            continue;
        }
        cells.push(face.corners.map(|corner| {
            *numbers.entry(corner).or_insert_with(|| {
                let [x, _, z] = complex.places[corner];
                vertices.push([x, z]);
                vertices.len() - 1
            })
        }));
        parents.push(number);
    }
    let mut section = Simplices::new(vertices, cells, parents);
    section.cut_until(|place| lengths.at(place));
    section
}

/// The pressure across at a point of a triangle.
pub(super) fn across(
    plane: &Complex<2, 3>,
    parents: &[usize],
    cell: usize,
    point: Point,
    (complex, sheets): (&Complex<3, 4>, &Sheets<3>),
    factor: f64,
) -> Form {
    let corners = plane.cells[cell].corners.map(|c| plane.places[c]);
    let place: [f64; 2] = match point {
        Point::Vertex(k) => corners[k],
        Point::Centroid => std::array::from_fn(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 3.0),
    };
    let face = parents[cell];
    let [a, b, c] = complex.faces[face].corners.map(|corner| {
        let [x, _, z] = complex.places[corner];
        [x, z]
    });
    let area =
        |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let whole = area(a, b, c);
    let weights = [area(place, b, c), area(a, place, c), area(a, b, place)].map(|part| part / whole);
    let mut sum = Form::default();
    for (vertex, weight) in weights.into_iter().enumerate() {
        sum.add(1.0, &sheets.stress(complex, face, vertex, [1, 1], factor * weight));
    }
    sum
}
