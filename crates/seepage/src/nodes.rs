//! Where the head has one value: corners of triangles that share an edge, unless a wall is there.

use std::collections::BTreeMap;

use crate::error::SeepageError;
use crate::ground::{Condition, Ground, pair};

/// What holds at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Hold {
    Head { head: f64, entry: usize },
    Air,
    Nothing,
}

/// The nodes of a ground.
#[derive(Debug, Clone)]
pub(crate) struct Nodes {
    /// For each triangle, the nodes at its corners.
    pub(crate) of: Vec<[usize; 3]>,
    /// Where they are.
    pub(crate) at: Vec<[f64; 2]>,
    /// What holds there.
    pub(crate) holds: Vec<Hold>,
}

/// Sets that are united two by two.
struct Sets(Vec<usize>);

impl Sets {
    fn first(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn unite(&mut self, a: usize, b: usize) {
        let [a, b] = [self.first(a), self.first(b)];
        self.0[a.max(b)] = a.min(b);
    }
}

impl Nodes {
    pub(crate) fn new(ground: &Ground) -> Result<Self, SeepageError> {
        let walls: Vec<[usize; 2]> = {
            let mut walls: Vec<_> = ground.walls.iter().map(|[a, b]| pair(*a, *b)).collect();
            walls.sort_unstable();
            walls
        };
        let mut sides: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        for (t, triangle) in ground.triangles.iter().enumerate() {
            for k in 0..3 {
                let [a, b] = [1, 2].map(|i| triangle.corners[(k + i) % 3]);
                sides.entry(pair(a, b)).or_default().push(t);
            }
        }
        let mut sets = Sets((0..3 * ground.triangles.len()).collect());
        for (edge, triangles) in &sides {
            match triangles.as_slice() {
                [first, second] if walls.binary_search(edge).is_err() => {
                    for point in edge {
                        let corner = |t: usize| {
                            ground.triangles[t].corners.iter().position(|c| c == point).map(|i| 3 * t + i)
                        };
                        if let (Some(a), Some(b)) = (corner(*first), corner(*second)) {
                            sets.unite(a, b);
                        }
                    }
                }
                [_, _] | [_] | [] => {}
                _ => return Err(SeepageError::Crowded { edge: *edge }),
            }
        }
        let mut numbers = vec![usize::MAX; sets.0.len()];
        let mut at = Vec::new();
        let mut of = Vec::with_capacity(ground.triangles.len());
        for (t, triangle) in ground.triangles.iter().enumerate() {
            of.push([0, 1, 2].map(|i| {
                let first = sets.first(3 * t + i);
                if numbers[first] == usize::MAX {
                    numbers[first] = at.len();
                    at.push(ground.points[triangle.corners[i]]);
                }
                numbers[first]
            }));
        }
        let mut nodes = Self { holds: vec![Hold::Nothing; at.len()], of, at };
        nodes.hold(ground);
        nodes.check_reached()?;
        Ok(nodes)
    }

    /// A given head goes before air, the first entry before later ones.
    fn hold(&mut self, ground: &Ground) {
        for boundary in &ground.boundaries {
            for i in [1, 2] {
                let node = self.of[boundary.triangle][(boundary.opposite + i) % 3];
                let hold = &mut self.holds[node];
                match (boundary.condition, *hold) {
                    (Condition::Head { head, entry }, Hold::Nothing | Hold::Air) => {
                        *hold = Hold::Head { head, entry };
                    }
                    (Condition::Head { head, entry }, Hold::Head { entry: first, .. }) if entry < first => {
                        *hold = Hold::Head { head, entry };
                    }
                    (Condition::Air, Hold::Nothing) => *hold = Hold::Air,
                    (Condition::Head { .. } | Condition::Air, _) => {}
                }
            }
        }
    }

    /// Without a given head anywhere in it, a piece of soil could have any.
    fn check_reached(&self) -> Result<(), SeepageError> {
        let mut sets = Sets((0..self.at.len()).collect());
        for [a, b, c] in &self.of {
            sets.unite(*a, *b);
            sets.unite(*b, *c);
        }
        let mut reached = vec![false; self.at.len()];
        for (node, hold) in self.holds.iter().enumerate() {
            if matches!(hold, Hold::Head { .. }) {
                reached[sets.first(node)] = true;
            }
        }
        match (0..self.at.len()).find(|node| !reached[sets.first(*node)]) {
            Some(node) => Err(SeepageError::NoHead { at: self.at[node] }),
            None => Ok(()),
        }
    }
}
