//! Boundary edges in the order in which they are walked with the soil on the left.

use std::collections::BTreeMap;

use soilctl_certificate::{Adjoins, Condition, LineUse, Run, Statement};

/// An edge of a triangle: the triangle, and the corner opposite to the edge.
type Edge = (usize, usize);

/// For each side of a line, the triangle edges on it, in walking order.
pub(super) fn edges_by_side(adjoins: &[[Adjoins; 3]]) -> BTreeMap<LineUse, Vec<Edge>> {
    /// With where on the line it starts.
    type Placed = (f64, Edge);
    let mut found: BTreeMap<LineUse, Vec<Placed>> = BTreeMap::new();
    for (triangle, adjoins) in adjoins.iter().enumerate() {
        for (corner, adjoins) in adjoins.iter().enumerate() {
            if let Adjoins::Boundary { side, ends, .. } = adjoins {
                let walked = if side.forward { ends[0] } else { -ends[0] };
                found.entry(*side).or_default().push((walked, (triangle, corner)));
            }
        }
    }
    let sorted = |(side, mut edges): (LineUse, Vec<Placed>)| {
        edges.sort_by(|a, b| a.0.total_cmp(&b.0));
        (side, edges.into_iter().map(|e| e.1).collect())
    };
    found.into_iter().map(sorted).collect()
}

/// All sides that are faces of structures.
pub(super) fn face_sides(statement: &Statement) -> Vec<LineUse> {
    let faces = statement.boundaries.iter().filter(|b| matches!(b.condition, Condition::Face { .. }));
    faces.map(soilctl_certificate::Boundary::side).collect()
}

/// Faces joined where one goes on as another, and just one: not around the edge of a plate.
pub(super) fn face_runs(statement: &Statement) -> Vec<Run> {
    let sides = face_sides(statement);
    let walked = |side: &LineUse| statement.lines[side.line].walked(side.forward);
    let next = |side: &LineUse| {
        let [_, end] = walked(side);
        let mut on = sides.iter().filter(|s| s.line != side.line && walked(s)[0] == end);
        on.next().copied().filter(|_| on.next().is_none())
    };
    let led_to: Vec<LineUse> = sides.iter().filter_map(next).collect();
    let height = |side: &LineUse| statement.points[walked(side)[0]][1];
    // First those with an end, then closed ones from their highest point on.
    let (open, mut others): (Vec<_>, Vec<_>) = sides.iter().partition(|s| !led_to.contains(s));
    others.sort_by(|a, b| height(b).total_cmp(&height(a)));
    let mut done: Vec<LineUse> = Vec::new();
    let mut runs = Vec::new();
    for start in open.into_iter().chain(others) {
        let mut run = Run { sides: Vec::new(), closed: false };
        let mut here = Some(start);
        while let Some(side) = here.filter(|s| !done.contains(s)) {
            done.push(side);
            run.sides.push(side);
            here = next(&side);
        }
        run.closed = here == Some(start);
        if !run.sides.is_empty() {
            runs.push(run);
        }
    }
    runs
}
