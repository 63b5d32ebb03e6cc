//! Tetrahedra in upright edges, at the surface.
//!
//! One that has two faces in upright planes on which there is no shear, and an edge in the surface, has too few unknown tractions
//! beside a neighbour with a face in the surface: the balances of both depend on each other. Such are cut in two, each with one of
//! the faces. The planes are those of the box and the plate's, which may be smooth.

use super::region::{Region, on_plate};
use super::simplices::Simplices;

/// Cuts them. No tetrahedra of this kind come of the others when they are bisected.
pub(super) fn cut(mesh: &mut Simplices<3, 4>, region: &Region) {
    let mut next = 0;
    while next < mesh.cells.len() {
        match between(mesh, region, next) {
            Some(edge) => mesh.bisect(edge),
            None => next += 1,
        }
    }
}

/// The edge between the vertices that only one of the two faces has.
fn between(mesh: &Simplices<3, 4>, region: &Region, cell: usize) -> Option<[usize; 2]> {
    let corners = mesh.cells[cell];
    let places = corners.map(|corner| mesh.vertices[corner]);
    // The only vertex that is not in a plane, if the three others are.
    let out = |is_in: &dyn Fn(&[f64; 3]) -> bool| {
        let mut out = (0..4).filter(|&k| !is_in(&places[k]));
        out.next().filter(|_| out.next().is_none()).map(|k| corners[k])
    };
    let side = |axis: usize| {
        let planes = &region.planes[axis];
        [planes[0], planes[planes.len() - 1]].into_iter().find_map(|end| out(&|place| place[axis] == end))
    };
    let at_surface = places.iter().filter(|place| place[2] == 0.0).count();
    let [a, b] = [side(0).or_else(|| out(&|place| on_plate(*place)))?, side(1)?];
    (at_surface >= 2).then_some([a.min(b), a.max(b)])
}
