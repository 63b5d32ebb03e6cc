//! Slip lines: where the velocity field of one level falls off sharply, the next mesh lets velocities jump.

use soilctl_certificate::Side;

use std::collections::BTreeMap;

use crate::fields::VelocityField;
use crate::mesh::{Guide, Mesh};
use crate::problem::Problem;
use crate::singular::typical_length;
use crate::topology::Topology;
use crate::vector::distance;

/// A slip line is where the speed is this fraction of the greatest nearby.
const FRACTION: f64 = 0.3;

/// Slower soil does not count as moving.
const FLOOR: f64 = 0.3;

/// A slip line that passes a tip at this distance is led to it. All lengths are in units of the typical one.
const REACH: f64 = 0.06;

/// Distance of the points of a guide.
const SPACING: f64 = 0.05;

/// Shorter ones are left out.
const SHORTEST: f64 = 0.3;

type Crossing = (usize, usize);

/// Lines on which the speed (averaged over jumps) has the given value, as chains of points.
fn contours(
    problem: &Problem,
    mesh: &Mesh,
    topology: &Topology,
    velocity: &VelocityField,
) -> Vec<Vec<[f64; 2]>> {
    let condition = |s: Side| topology.line[s.triangle][s.corner].and_then(|l| problem.condition(l));
    let (corners, vertex_of) = topology.split(mesh, |s| condition(s).is_some());
    let mut middle_of: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    let mut place: Vec<[f64; 2]> = vertex_of.iter().map(|v| mesh.vertices[*v].position).collect();
    let mut nodes = Vec::new();
    for c in &corners {
        let mut all = [c[0], c[1], c[2], 0, 0, 0];
        for k in 0..3 {
            let (a, b) = (c[(k + 1) % 3], c[(k + 2) % 3]);
            let next = place.len();
            let id = *middle_of.entry((a.min(b), a.max(b))).or_insert(next);
            if id == next {
                place.push([0.5 * (place[a][0] + place[b][0]), 0.5 * (place[a][1] + place[b][1])]);
            }
            all[3 + k] = id;
        }
        nodes.push(all);
    }
    let mut speed = vec![(0.0, 0.0); place.len()];
    for (t, all) in nodes.iter().enumerate() {
        for (k, node) in all.iter().enumerate() {
            let b = &velocity.control[t];
            let value = |axis: usize| {
                if k < 3 {
                    return b[k][axis];
                }
                0.5 * b[k][axis] + 0.25 * b[(k - 2) % 3][axis] + 0.25 * b[(k - 1) % 3][axis]
            };
            speed[*node].0 += value(0).hypot(value(1));
            speed[*node].1 += 1.0;
        }
    }
    let speed: Vec<f64> = speed.iter().map(|(s, n)| s / n).collect();
    // The speed is compared with the greatest nearby: ahead of a plate soil may rise much faster than the plate moves.
    let mut fastest = speed.clone();
    for _ in 0..3 {
        let before = fastest.clone();
        for all in &nodes {
            let most = all.iter().map(|n| before[*n]).fold(0.0, f64::max);
            for n in all {
                fastest[*n] = fastest[*n].max(most);
            }
        }
    }
    let speed: Vec<f64> = speed.iter().zip(&fastest).map(|(s, f)| s / f.max(FLOOR) - FRACTION).collect();
    let mut links: BTreeMap<Crossing, Vec<Crossing>> = BTreeMap::new();
    // Soil that keeps its volume does not slip along lines: its velocity is continuous.
    let slips = |triangle: &usize| !problem.soils[mesh.triangles[*triangle].region].is_isochoric;
    for all in (0..nodes.len()).filter(slips).map(|t| &nodes[t]) {
        for part in [[0, 5, 4], [1, 3, 5], [2, 4, 3], [3, 4, 5]] {
            let crossings: Vec<Crossing> = (0..3)
                .map(|k| (all[part[k]], all[part[(k + 1) % 3]]))
                .filter(|(a, b)| (speed[*a] < 0.0) != (speed[*b] < 0.0))
                .map(|(a, b)| (a.min(b), a.max(b)))
                .collect();
            if let [a, b] = crossings[..] {
                links.entry(a).or_default().push(b);
                links.entry(b).or_default().push(a);
            }
        }
    }
    let point = |(a, b): Crossing| {
        let s = speed[a] / (speed[a] - speed[b]);
        [place[a][0] + s * (place[b][0] - place[a][0]), place[a][1] + s * (place[b][1] - place[a][1])]
    };
    let mut chains = Vec::new();
    loop {
        // Open chains first: they have an end.
        let start =
            links.iter().find(|(_, l)| l.len() == 1).or_else(|| links.iter().find(|(_, l)| !l.is_empty()));
        let Some((&start, _)) = start else { break };
        let mut chain = vec![point(start)];
        let mut here = start;
        while let Some(next) = links.get_mut(&here).and_then(Vec::pop) {
            if let Some(back) = links.get_mut(&next)
                && let Some(i) = back.iter().position(|c| *c == here)
            {
                back.remove(i);
            }
            chain.push(point(next));
            here = next;
        }
        links.retain(|_, l| !l.is_empty());
        chains.push(chain);
    }
    chains
}

fn length(line: &[[f64; 2]]) -> f64 {
    line.windows(2).map(|w| distance(w[0], w[1])).sum()
}

/// Slip lines of a flow as guides: joined to the tips that they pass, and smoothed.
pub(crate) fn guides(
    problem: &Problem,
    mesh: &Mesh,
    topology: &Topology,
    velocity: &VelocityField,
    tips: &[[f64; 2]],
) -> Vec<Guide> {
    let unit = typical_length(problem);
    let mut pieces = contours(problem, mesh, topology, velocity);
    for tip in tips {
        pieces = pieces.into_iter().flat_map(|piece| join(piece, *tip, unit * REACH)).collect();
    }
    pieces
        .into_iter()
        .filter(|piece| length(piece) > unit * SHORTEST)
        .map(|piece| Guide { points: smooth(&piece, unit * SPACING) })
        .collect()
}

/// Cuts a line where it passes a tip and joins both parts to it.
fn join(line: Vec<[f64; 2]>, tip: [f64; 2], reach: f64) -> Vec<Vec<[f64; 2]>> {
    let near = line.iter().map(|p| distance(*p, tip)).fold(f64::INFINITY, f64::min);
    if near > reach {
        return vec![line];
    }
    let inside = |p: &[f64; 2]| distance(*p, tip) < reach.max(1.5 * near);
    let first = line.iter().position(inside).unwrap_or(0);
    let last = line.iter().rposition(inside).unwrap_or(0);
    let mut before = line[..first].to_vec();
    before.push(tip);
    let mut after = vec![tip];
    after.extend_from_slice(&line[last + 1..]);
    [before, after].into_iter().filter(|l| l.len() > 1).collect()
}

/// Points at equal spacing along the line, averaged with their neighbours; the ends stay.
fn smooth(line: &[[f64; 2]], spacing: f64) -> Vec<[f64; 2]> {
    let total = length(line);
    let pieces = (total / spacing).ceil().max(2.0) as usize;
    let mut points = vec![line[0]];
    let (mut walked, mut segment) = (0.0, 0);
    for i in 1..pieces {
        let target = total * i as f64 / pieces as f64;
        while segment + 2 < line.len() && walked + distance(line[segment], line[segment + 1]) < target {
            walked += distance(line[segment], line[segment + 1]);
            segment += 1;
        }
        let (p, q) = (line[segment], line[segment + 1]);
        let s = ((target - walked) / distance(p, q).max(1e-300)).clamp(0.0, 1.0);
        points.push([p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])]);
    }
    points.push(line[line.len() - 1]);
    for _ in 0..6 {
        let old = points.clone();
        for i in 1..points.len() - 1 {
            for axis in 0..2 {
                points[i][axis] = 0.25 * old[i - 1][axis] + 0.5 * old[i][axis] + 0.25 * old[i + 1][axis];
            }
        }
    }
    points
}
