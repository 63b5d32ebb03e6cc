//! What holds around the copies of a mesh's vertices.

use crate::mesh::Side;
use crate::problem::Problem;
use crate::tiling::{Beyond, Tiling, after};
use crate::{Condition, Mesh};

/// What is known about one vertex copy.
#[derive(Default, Clone)]
pub(super) struct Around {
    pub(super) vertex: usize,
    pub(super) gauge: Option<usize>,
    /// Lines of given shear, one of each kind and direction.
    pub(super) given: Vec<usize>,
    /// Copies next to it at which the stress must vanish.
    pub(super) apexes: Vec<usize>,
}

/// One vertex copy for each fan of triangles around a vertex that no boundary cuts.
pub(super) fn split(tiling: &Tiling, mesh: &Mesh) -> Vec<[usize; 3]> {
    let none = usize::MAX;
    let mut copies = vec![[none; 3]; mesh.triangles.len()];
    let mut count = 0;
    for first in tiling.sides() {
        let vertex = mesh.triangles[first.triangle].corners[first.corner];
        if copies[first.triangle][first.corner] != none {
            continue;
        }
        let mut open = vec![first.triangle];
        while let Some(triangle) = open.pop() {
            let corner = mesh.triangles[triangle].corners.iter().position(|v| *v == vertex).unwrap();
            if copies[triangle][corner] != none {
                continue;
            }
            copies[triangle][corner] = count;
            for edge in [1, 2].map(|i| after(corner, i)) {
                if let Beyond::Soil(other) = tiling.beyond(Side { triangle, corner: edge }) {
                    open.push(other.triangle);
                }
            }
        }
        count += 1;
    }
    copies
}

pub(super) fn look_around(
    problem: &Problem,
    tiling: &Tiling,
    mesh: &Mesh,
    corners: &[[usize; 3]],
) -> Vec<Around> {
    let statement = problem.statement;
    let runs = problem.statement.runs(|b| b.condition.traction_is_given());
    let count = corners.iter().flatten().max().unwrap() + 1;
    let mut around = vec![Around::default(); count];
    let mut bare = vec![false; count];
    for side in tiling.sides() {
        let copy = corners[side.triangle][side.corner];
        around[copy].vertex = mesh.triangles[side.triangle].corners[side.corner];
        let ends = [1, 2].map(|i| corners[side.triangle][after(side.corner, i)]);
        let Beyond::Boundary(on, condition) = tiling.beyond(side) else { continue };
        let line = on.side.line;
        let cohesion = statement.regions[tiling.region(side.triangle)].material.cohesion;
        let alike = |a: usize, b: usize| {
            let [d, e] = [a, b].map(|l| problem.direction(l));
            let straight = (d.x.is_zero() && e.x.is_zero()) || (d.y.is_zero() && e.y.is_zero());
            let far =
                |l: usize| statement.boundaries.iter().any(|b| b.line == l && b.condition == Condition::Far);
            a == b || (straight && far(a) == far(b))
        };
        for copy in ends {
            if let Some(run) = runs.iter().position(|run| run.sides.contains(&on.side)) {
                around[copy].gauge = Some(run);
            }
            if condition == Condition::Free && statement.surcharge == 0.0 && cohesion.is_zero() {
                bare[copy] = true;
            }
            if condition.shear_is_given() && !around[copy].given.iter().any(|other| alike(*other, line)) {
                around[copy].given.push(line);
            }
        }
    }
    for copies in corners {
        for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (copies[i], copies[j])) {
            for (copy, apex) in [(a, b), (b, a)] {
                if bare[apex] && !around[copy].apexes.contains(&apex) {
                    around[copy].apexes.push(apex);
                }
            }
        }
    }
    around
}
