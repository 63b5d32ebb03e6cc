//! Regions of one soil as few polygons: cuts between them are of the solver's making and are not drawn.

use std::collections::BTreeSet;

use soilctl_certificate::{LineUse, Statement};
use soilctl_figure::Polygon;
use soilctl_limit_analysis::results::Point;

use super::place::ring;

/// The union of some regions, as polygons with holes; `place` says where a point of the statement is drawn.
pub(super) fn union(
    statement: &Statement,
    regions: &[usize],
    place: impl Fn(Point) -> Point,
) -> Vec<Polygon> {
    let (mut outer, mut holes) = (Vec::new(), Vec::new());
    for corners in outlines(statement, regions) {
        let corners: Vec<Point> = corners.into_iter().map(|p| place(statement.points[p])).collect();
        if double_area(&corners) > 0.0 { outer.push((corners, Vec::new())) } else { holes.push(corners) }
    }
    for hole in holes {
        let around = outer.iter_mut().find(|(corners, _)| is_inside(corners, super::place::middle(&hole)));
        if let Some((_, of)) = around {
            of.push(hole);
        }
    }
    let polygon = |(corners, holes): (Vec<Point>, Vec<Vec<Point>>)| {
        holes.iter().fold(Polygon::new(ring(&corners)), |polygon, hole| polygon.hole(ring(hole)))
    };
    outer.into_iter().map(polygon).collect()
}

/// Loops around the regions together: outer ones counter-clockwise, holes clockwise.
fn outlines(statement: &Statement, regions: &[usize]) -> Vec<Vec<usize>> {
    let boundary: BTreeSet<LineUse> = statement.boundaries.iter().map(|b| b.side()).collect();
    let uses: BTreeSet<LineUse> = regions
        .iter()
        .flat_map(|&region| statement.regions[region].loops.iter().flatten())
        .copied()
        .collect();
    let is_rim = |side: &LineUse| boundary.contains(side) || !uses.contains(&side.reversed());
    let mut left: Vec<LineUse> = uses.iter().copied().filter(is_rim).collect();
    let ends = |side: LineUse| statement.lines[side.line].walked(side.forward);
    let mut loops = Vec::new();
    while let Some(first) = left.pop() {
        let [start, mut at] = ends(first);
        let mut corners = vec![start];
        while at != start {
            let Some(next) = left.iter().position(|side| ends(*side)[0] == at) else { break };
            corners.push(at);
            at = ends(left.swap_remove(next))[1];
        }
        if corners.len() > 2 {
            loops.push(corners);
        }
    }
    loops
}

fn double_area(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum()
}

/// Whether a point is inside of a polygon.
pub(super) fn is_inside(corners: &[Point], [x, y]: Point) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = corners
        .iter()
        .zip(next)
        .filter(|([ax, ay], [bx, by])| (*ay > y) != (*by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax));
    crossed.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_inside_or_not() {
        let l = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        for (p, inside) in [([0.5, 1.5], true), ([1.5, 0.5], true), ([1.5, 1.5], false), ([-1.0, 0.5], false)]
        {
            assert_eq!(is_inside(&l, p), inside, "{p:?}");
        }
        assert!((double_area(&l) - 6.0).abs() < 1e-12);
    }
}
