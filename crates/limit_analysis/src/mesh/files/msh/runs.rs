//! Joins the edges of a curve in straight runs.

use super::super::super::vector::{along, between, distance, dot};
use super::edges::Edge;
use super::parts::Parts;

/// A run is straight if vertices are off it by no more than this fraction of the largest coordinate.
const STRAIGHT: f64 = 1e-12;

/// Edges of the outline that are one line of it.
pub(super) struct Run {
    /// Vertices from the first to the last, at least two.
    pub(super) vertices: Vec<usize>,
    /// Regions on the left and on the right.
    pub(super) regions: [Option<usize>; 2],
    /// Physical groups.
    pub(super) groups: Vec<i64>,
}

impl Run {
    pub(super) fn ends(&self) -> [usize; 2] {
        [self.vertices[0], self.vertices[self.vertices.len() - 1]]
    }
}

/// The runs, in the order of their first edges.
pub(super) fn runs(parts: &Parts, edges: Vec<Edge>) -> Vec<Run> {
    let slack = STRAIGHT * parts.points.iter().flatten().fold(0f64, |m, c| m.max(c.abs()));
    let (before, after) = neighbours(parts, &edges, slack);
    let mut runs = Vec::new();
    let mut done = vec![false; edges.len()];
    for start in 0..edges.len() {
        if done[start] {
            continue;
        }
        let mut first = start;
        while let Some(edge) = before[first].filter(|&e| e != start) {
            first = edge;
        }
        let mut chain = vec![first];
        while let Some(edge) = after[chain[chain.len() - 1]].filter(|&e| e != first) {
            chain.push(edge);
        }
        chain.iter().for_each(|&e| done[e] = true);
        let Edge { regions, groups, .. } = &edges[first];
        let run = |vertices| Run { vertices, regions: *regions, groups: groups.clone() };
        let vertices: Vec<usize> =
            chain.iter().map(|&e| edges[e].ends[0]).chain([edges[chain[chain.len() - 1]].ends[1]]).collect();
        if is_straight(parts, &vertices, slack) {
            runs.push(run(vertices));
        } else {
            runs.extend(vertices.windows(2).map(|pair| run(pair.to_vec())));
        }
    }
    runs
}

/// For each edge the one before it and the one after it in the same straight run.
fn neighbours(parts: &Parts, edges: &[Edge], slack: f64) -> (Vec<Option<usize>>, Vec<Option<usize>>) {
    let count = parts.points.len();
    let (mut at_end, mut at_start, mut degree) = (vec![None; count], vec![None; count], vec![0usize; count]);
    for (i, e) in edges.iter().enumerate() {
        at_start[e.ends[0]] = Some(i);
        at_end[e.ends[1]] = Some(i);
        e.ends.iter().for_each(|&v| degree[v] += 1);
    }
    let (mut before, mut after) = (vec![None; edges.len()], vec![None; edges.len()]);
    for v in 0..count {
        let (Some(i), Some(k), 2) = (at_end[v], at_start[v], degree[v]) else { continue };
        let (a, b): (&Edge, &Edge) = (&edges[i], &edges[k]);
        let same = a.curve.is_some() && a.curve == b.curve && a.regions == b.regions && a.groups == b.groups;
        if same && is_straight(parts, &[a.ends[0], v, b.ends[1]], slack) {
            after[i] = Some(k);
            before[k] = Some(i);
        }
    }
    (before, after)
}

/// Whether vertices follow one another on a straight line.
fn is_straight(parts: &Parts, vertices: &[usize], slack: f64) -> bool {
    let at = |i: usize| parts.points[vertices[i]];
    let (a, b) = (at(0), at(vertices.len() - 1));
    let way = between(a, b);
    if distance(a, b) <= slack {
        return false;
    }
    let mut last = 0.0;
    (1..vertices.len() - 1).all(|i| {
        let s = dot(between(a, at(i)), way) / dot(way, way);
        let follows = s > last && s < 1.0;
        last = s;
        follows && distance(at(i), along(a, b, s)) <= slack
    })
}
