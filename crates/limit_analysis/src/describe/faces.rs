//! Regions of the statement: what edges enclose.

use soilctl_certificate::LineUse;

use std::collections::BTreeMap;

use super::ground::{Map, Occupant, inside};
use crate::vector::{Point, between, cross, distance};

/// A piece of soil.
#[derive(Debug, Clone)]
pub(super) struct Face {
    pub(super) region: usize,
    pub(super) submerged: bool,
    /// The outer loop, then holes and slits, all with the face on the left.
    pub(super) loops: Vec<Vec<LineUse>>,
}

impl Map {
    /// First and last point of a walked edge.
    pub(super) fn walked(&self, walk: LineUse) -> [usize; 2] {
        let [a, b] = self.arrangement.edges[walk.line].ends;
        if walk.forward { [a, b] } else { [b, a] }
    }

    pub(super) fn walked_points(&self, walk: LineUse) -> [Point; 2] {
        self.walked(walk).map(|p| self.arrangement.points[p])
    }

    pub(super) fn left_of(&self, walk: LineUse) -> Occupant {
        self.sides[walk.line][usize::from(!walk.forward)]
    }

    /// All pieces of soil.
    pub(super) fn faces(&self) -> Vec<Face> {
        let loops = self.loops();
        let polygon =
            |ring: &[LineUse]| -> Vec<Point> { ring.iter().map(|w| self.walked_points(*w)[0]).collect() };
        let mut faces = Vec::new();
        let mut outer: Vec<(Vec<Point>, f64, usize)> = Vec::new();
        let mut holes = Vec::new();
        for ring in loops {
            let points = polygon(&ring);
            let area = area(&points);
            // The longest edge tells best what it bounds.
            let length = |w: &LineUse| {
                let [a, b] = self.walked_points(*w);
                distance(b, a)
            };
            let longest = ring.iter().copied().max_by(|a, b| length(a).total_cmp(&length(b)));
            let Some(Occupant::Soil { region, submerged }) = longest.map(|w| self.left_of(w)) else {
                continue;
            };
            if area > 0.0 && !is_slit(&ring) {
                outer.push((points, area, faces.len()));
                faces.push(Face { region, submerged, loops: vec![ring] });
            } else {
                holes.push((points[0], ring));
            }
        }
        for (at, ring) in holes {
            let around = outer
                .iter()
                .filter(|(points, _, _)| inside(points, at) && !points.contains(&at))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((_, _, face)) = around {
                faces[*face].loops.push(ring);
            }
        }
        faces
    }

    /// All loops, each with what it bounds on the left.
    fn loops(&self) -> Vec<Vec<LineUse>> {
        // Walks out of each point, counter-clockwise.
        let mut out: BTreeMap<usize, Vec<(f64, LineUse)>> = BTreeMap::new();
        for edge in 0..self.arrangement.edges.len() {
            for forward in [true, false] {
                let walk = LineUse { line: edge, forward };
                let [a, b] = self.walked_points(walk);
                let along = between(a, b);
                out.entry(self.walked(walk)[0]).or_default().push((along[1].atan2(along[0]), walk));
            }
        }
        let mut next: BTreeMap<LineUse, LineUse> = BTreeMap::new();
        for walks in out.values_mut() {
            walks.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (i, (_, walk)) in walks.iter().enumerate() {
                // Whoever comes back along this edge turns as far right as can be: the next one clockwise.
                let before = walks[(i + walks.len() - 1) % walks.len()].1;
                next.insert(walk.reversed(), before);
            }
        }
        let mut loops = Vec::new();
        let mut done: Vec<[bool; 2]> = vec![[false; 2]; self.arrangement.edges.len()];
        for start in next.keys() {
            let mut ring = Vec::new();
            let mut at = *start;
            while !std::mem::replace(&mut done[at.line][usize::from(at.forward)], true) {
                ring.push(at);
                match next.get(&at) {
                    Some(walk) => at = *walk,
                    None => break,
                }
            }
            if !ring.is_empty() {
                loops.push(ring);
            }
        }
        loops
    }
}

/// Whether each edge of a loop is walked both ways: it encloses nothing, whatever rounding makes of its area.
fn is_slit(ring: &[LineUse]) -> bool {
    ring.iter().all(|w| ring.contains(&w.reversed()))
}

pub(super) fn area(points: &[Point]) -> f64 {
    let Some(first) = points.first() else { return 0.0 };
    points.windows(2).map(|w| 0.5 * cross(between(*first, w[0]), between(*first, w[1]))).sum()
}
