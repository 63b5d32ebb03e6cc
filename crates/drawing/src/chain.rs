//! Lines of one layer that meet at their ends: the areas that they bound, and what is left of them joined to longer lines.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Outline, Point, Shape, signed_area_m2};

/// Areas and lines, by layers in the order in which they first are there.
///
/// Lines that meet make a plane graph, and each of its faces inside is an area: walking along the left side of a line and turning left as sharply as can
/// be at each end comes back to the start.
pub(crate) fn join(lines: Vec<Shape>, join_m: f64) -> Vec<Shape> {
    let mut layers: Vec<(String, Vec<Vec<Point>>)> = Vec::new();
    for Shape { layer, corners, .. } in lines.into_iter().filter(|line| line.corners.len() > 1) {
        match layers.iter_mut().find(|(name, _)| *name == layer) {
            Some((_, of)) => of.push(corners),
            None => layers.push((layer, vec![corners])),
        }
    }
    let mut shapes = Vec::new();
    for (layer, lines) in layers {
        let graph = Graph::new(lines, join_m);
        let shape = |corners, outline| Shape { layer: layer.clone(), corners, outline };
        shapes.extend(graph.faces().into_iter().map(|corners| shape(corners, Outline::Closed)));
        shapes.extend(graph.rest().into_iter().map(|corners| shape(corners, Outline::Open)));
    }
    shapes
}

/// A line between two nodes, walked one way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Way {
    line: usize,
    forward: bool,
}

impl Way {
    const fn back(self) -> Self {
        Self { forward: !self.forward, ..self }
    }
}

/// Lines of a layer and the nodes where they end.
struct Graph {
    lines: Vec<Vec<Point>>,
    /// First and last node of each line.
    ends: Vec<[usize; 2]>,
    /// Whether a line is part of the outline of something.
    bounds: Vec<bool>,
    /// Ways that leave each node, counter-clockwise, of lines that bound something.
    leaving: Vec<Vec<Way>>,
}

impl Graph {
    fn new(drawn: Vec<Vec<Point>>, join_m: f64) -> Self {
        let mut nodes = Nodes::new(join_m);
        let (mut lines, mut ends) = (Vec::new(), Vec::new());
        let mut seen = BTreeSet::new();
        for mut line in drawn {
            let last = line.len() - 1;
            let [from, to] = [nodes.at(line[0]), nodes.at(line[last])];
            (line[0], line[last]) = (nodes.points[from], nodes.points[to]);
            // Neighbours that were drawn one by one have the line between them twice.
            if seen.insert(same_either_way(&line)) {
                lines.push(line);
                ends.push([from, to]);
            }
        }
        let mut graph = Self { bounds: vec![true; lines.len()], leaving: Vec::new(), lines, ends };
        graph.sort(nodes.points.len());
        // A line with the same face on both sides leads nowhere, or joins two parts, and bounds neither.
        let faces: BTreeMap<Way, usize> = graph
            .walks()
            .into_iter()
            .enumerate()
            .flat_map(|(face, walk)| walk.into_iter().map(move |way| (way, face)))
            .collect();
        for (line, bounds) in graph.bounds.iter_mut().enumerate() {
            let face = |forward| faces.get(&Way { line, forward });
            *bounds = face(true) != face(false);
        }
        graph.sort(nodes.points.len());
        graph
    }

    fn sort(&mut self, nodes: usize) {
        let mut leaving = vec![Vec::new(); nodes];
        for (line, [from, to]) in self.ends.iter().enumerate().filter(|(line, _)| self.bounds[*line]) {
            leaving[*from].push(Way { line, forward: true });
            leaving[*to].push(Way { line, forward: false });
        }
        let turned = |ways: Vec<Way>| {
            let mut turned: Vec<(f64, Way)> =
                ways.into_iter().map(|way| (self.direction(way), way)).collect();
            turned.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            turned.into_iter().map(|(_, way)| way).collect()
        };
        self.leaving = leaving.into_iter().map(turned).collect();
    }

    /// Corners along a way.
    fn corners(&self, way: Way) -> Vec<Point> {
        let mut corners = self.lines[way.line].clone();
        if !way.forward {
            corners.reverse();
        }
        corners
    }

    /// The direction in which a way leaves its first node.
    fn direction(&self, way: Way) -> f64 {
        let corners = self.corners(way);
        let next = corners.iter().find(|p| **p != corners[0]).copied().unwrap_or(corners[0]);
        libm::atan2(next[1] - corners[0][1], next[0] - corners[0][0])
    }

    /// The way that goes on along the left side: the next one clockwise from where this one came.
    fn next(&self, way: Way) -> Way {
        let node = self.ends[way.line][usize::from(way.forward)];
        let ways = &self.leaving[node];
        let came = ways.iter().position(|other| *other == way.back()).unwrap_or(0);
        ways[(came + ways.len() - 1) % ways.len()]
    }

    /// All faces as the ways around them, that outside too.
    fn walks(&self) -> Vec<Vec<Way>> {
        let mut walked = BTreeMap::new();
        let mut walks = Vec::new();
        let ways = (0..self.lines.len()).filter(|line| self.bounds[*line]);
        for start in ways.flat_map(|line| [true, false].map(|forward| Way { line, forward })) {
            let mut walk = Vec::new();
            let mut way = start;
            while walked.insert(way, ()).is_none() {
                walk.push(way);
                way = self.next(way);
            }
            if !walk.is_empty() {
                walks.push(walk);
            }
        }
        walks
    }

    /// Corners of the faces inside, counter-clockwise.
    fn faces(&self) -> Vec<Vec<Point>> {
        let outline = |walk: Vec<Way>| {
            let mut corners: Vec<Point> = Vec::new();
            for way in walk {
                let of = self.corners(way);
                corners.extend(&of[..of.len() - 1]);
            }
            corners
        };
        self.walks().into_iter().map(outline).filter(|corners| signed_area_m2(corners) > 0.0).collect()
    }

    /// Lines that bound nothing, joined where exactly two of them meet and no other line does.
    fn rest(&self) -> Vec<Vec<Point>> {
        let mut at: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (line, ends) in self.ends.iter().enumerate() {
            ends.iter().for_each(|&node| at.entry(node).or_default().push(line));
        }
        let mut is_left: Vec<bool> = self.bounds.iter().map(|bounds| !bounds).collect();
        let mut joined = Vec::new();
        for first in 0..self.lines.len() {
            if !std::mem::take(&mut is_left[first]) {
                continue;
            }
            let mut chain = self.lines[first].clone();
            let [from, to] = self.ends[first];
            // On from the last node; then the chain is turned and goes on from what was its first.
            for mut node in [to, from] {
                while let [a, b] = at[&node][..]
                    && let Some(line) = [a, b].into_iter().find(|line| is_left[*line])
                {
                    is_left[line] = false;
                    let forward = self.ends[line][0] == node;
                    chain.extend(self.corners(Way { line, forward }).into_iter().skip(1));
                    node = self.ends[line][usize::from(forward)];
                }
                chain.reverse();
            }
            joined.push(chain);
        }
        joined
    }
}

/// What tells a line from others, whichever way it is drawn.
fn same_either_way(line: &[Point]) -> Vec<[u64; 2]> {
    let bits = |p: &Point| p.map(|x| (x + 0.0).to_bits());
    let there: Vec<_> = line.iter().map(bits).collect();
    let back: Vec<_> = line.iter().rev().map(bits).collect();
    there.min(back)
}

/// Points that are near to each other are one node, found by the square of a grid that they are in.
struct Nodes {
    join_m: f64,
    /// Side of a square (m), not less than what coordinates are told by.
    side_m: f64,
    points: Vec<Point>,
    squares: BTreeMap<[i64; 2], Vec<usize>>,
}

impl Nodes {
    fn new(join_m: f64) -> Self {
        Self { join_m, side_m: join_m.max(1e-9), points: Vec::new(), squares: BTreeMap::new() }
    }

    fn at(&mut self, p: Point) -> usize {
        let [i, j] = p.map(|x| (x / self.side_m).floor() as i64);
        let near = |node: &&usize| {
            let q = self.points[**node];
            (q[0] - p[0]).hypot(q[1] - p[1]) <= self.join_m
        };
        for di in -1..=1 {
            for dj in -1..=1 {
                let square = [i.saturating_add(di), j.saturating_add(dj)];
                if let Some(node) = self.squares.get(&square).and_then(|nodes| nodes.iter().find(near)) {
                    return *node;
                }
            }
        }
        self.points.push(p);
        self.squares.entry([i, j]).or_default().push(self.points.len() - 1);
        self.points.len() - 1
    }
}
