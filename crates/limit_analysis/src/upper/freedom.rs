//! Kinematic boundary conditions: how each control point of a quadratic velocity may move.

use soilctl_certificate::Condition;
use soilctl_conic::{Form, Program};

use super::Velocity;
use super::meshed::MeshedProblem;
use super::nodes::Element;
use crate::problem::Problem;
use crate::vector::distance;

/// A triangle and its control points.
type Quadratic = (usize, [usize; 6]);

/// Notches this little (in radians) above twice the friction angle are held too: flow would be extremely fast there.
const NOTCH_MARGIN: f64 = 0.1;

/// How a control point may move.
#[derive(Debug, Clone, Copy)]
pub(super) enum Freedom {
    Still,
    /// Along a line.
    Slide {
        line: usize,
        index: usize,
        unit: f64,
    },
    Free {
        x: usize,
        y: usize,
    },
}

impl Freedom {
    pub(super) fn velocity(&self, problem: &Problem) -> Velocity {
        match *self {
            Self::Still => [Form::default(), Form::default()],
            Self::Slide { line, index, unit } => {
                let [p, q] = problem.ends(line);
                [Form::unknown(index, unit * (q[0] - p[0])), Form::unknown(index, unit * (q[1] - p[1]))]
            }
            Self::Free { x, y } => [Form::unknown(x, 1.0), Form::unknown(y, 1.0)],
        }
    }
}

/// Which control points may move, and how.
pub(super) fn freedoms(
    meshed: &MeshedProblem,
    elements: &[Element],
    count: usize,
    still: &[bool],
    program: &mut Program,
) -> Vec<Freedom> {
    let MeshedProblem { problem, topology, .. } = *meshed;
    let quadratic = |(triangle, element): (usize, &Element)| match element {
        Element::Quadratic(nodes) => Some((triangle, *nodes)),
        Element::Stream(_) | Element::Rest => None,
    };
    let nodes: Vec<Quadratic> = elements.iter().enumerate().filter_map(quadratic).collect();
    let mut fixed = vec![false; count];
    let mut smooth: Vec<Vec<usize>> = vec![Vec::new(); count];
    for &(triangle, all) in &nodes {
        if still.get(triangle).copied().unwrap_or(false) {
            all.iter().for_each(|n| fixed[*n] = true);
        }
        for k in 0..3 {
            let Some(side) = topology.line[triangle][k] else { continue };
            for node in [(k + 1) % 3, (k + 2) % 3, 3 + k].map(|i| all[i]) {
                match problem.condition(side) {
                    Some(Condition::Fixed | Condition::Far) => fixed[node] = true,
                    Some(Condition::Smooth) if !smooth[node].contains(&side.line) => {
                        smooth[node].push(side.line)
                    }
                    _ => {}
                }
            }
        }
    }
    hold_pockets(&nodes, &mut fixed);
    // A triangle whose corners are all held cannot dilate: with one free control point its strain rates at two corners
    // would have to point two ways at once.
    for (_, all) in &nodes {
        if all[..3].iter().all(|n| fixed[*n]) {
            all.iter().for_each(|n| fixed[*n] = true);
        }
    }
    hold_notches(meshed, &nodes, &mut fixed);
    (0..count)
        .map(|node| match smooth[node].as_slice() {
            _ if fixed[node] => Freedom::Still,
            [] => Freedom::Free { x: program.unknown(), y: program.unknown() },
            [line, more @ ..] if more.iter().all(|other| in_line(problem, *line, *other)) => {
                let [p, q] = problem.ends(*line);
                Freedom::Slide { line: *line, index: program.unknown(), unit: 1.0 / distance(p, q) }
            }
            _ => Freedom::Still,
        })
        .collect()
}

/// Whether two lines that meet are both level or both upright: what slides along one slides along the other.
fn in_line(problem: &Problem, a: usize, b: usize) -> bool {
    let ([p, q], [r, s]) = (problem.ends(a), problem.ends(b));
    (0..2).any(|axis| p[axis] == q[axis] && r[axis] == s[axis])
}

/// Holds corners inside the soil with at most two free neighbours: soil that dilates needs room.
fn hold_pockets(nodes: &[Quadratic], fixed: &mut [bool]) {
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); fixed.len()];
    let mut seen = vec![0_usize; fixed.len()];
    for (_, all) in nodes {
        for k in 0..3 {
            seen[all[3 + k]] += 1;
            for other in [(k + 1) % 3, (k + 2) % 3] {
                if !neighbours[all[k]].contains(&all[other]) {
                    neighbours[all[k]].push(all[other]);
                }
            }
        }
    }
    // Corners on a rim: a free surface, a face or a jump.
    let mut rim = vec![false; fixed.len()];
    for (_, all) in nodes {
        for k in (0..3).filter(|k| seen[all[3 + k]] == 1) {
            rim[all[(k + 1) % 3]] = true;
            rim[all[(k + 2) % 3]] = true;
        }
    }
    let corner = |n: usize| !neighbours[n].is_empty();
    let mut open: Vec<usize> = (0..fixed.len()).filter(|n| corner(*n) && !fixed[*n]).collect();
    while let Some(node) = open.pop() {
        if fixed[node] || rim[node] || neighbours[node].iter().filter(|n| !fixed[**n]).count() > 2 {
            continue;
        }
        fixed[node] = true;
        open.extend(neighbours[node].iter().filter(|n| !fixed[**n]));
    }
}

/// Holds the control points around a held corner that lie in a notch between held edges too narrow for friction: no
/// flow that dilates leaves a notch of less than twice the friction angle.
fn hold_notches(meshed: &MeshedProblem, nodes: &[Quadratic], fixed: &mut [bool]) {
    let mut around: Vec<Vec<(usize, usize)>> = vec![Vec::new(); fixed.len()];
    for (i, (_, all)) in nodes.iter().enumerate() {
        for k in (0..3).filter(|k| fixed[all[*k]]) {
            around[all[k]].push((i, k));
        }
    }
    let spokes = |(i, k): (usize, usize)| [nodes[i].1[3 + (k + 1) % 3], nodes[i].1[3 + (k + 2) % 3]];
    for fan in around {
        let mut done = vec![false; fan.len()];
        for first in 0..fan.len() {
            if done[first] {
                continue;
            }
            // The triangles that hang together across free spokes.
            let (mut part, mut open) = (Vec::new(), vec![first]);
            done[first] = true;
            while let Some(i) = open.pop() {
                part.push(i);
                for j in 0..fan.len() {
                    let joined = spokes(fan[i]).iter().any(|s| !fixed[*s] && spokes(fan[j]).contains(s));
                    if joined && !done[j] {
                        done[j] = true;
                        open.push(j);
                    }
                }
            }
            let free: Vec<usize> = part.iter().flat_map(|i| spokes(fan[*i])).filter(|s| !fixed[*s]).collect();
            // A spoke seen once lies on a free surface or a jump: the notch is open there.
            let closed = free.iter().all(|s| free.iter().filter(|o| *o == s).count() == 2);
            let angle: f64 = part.iter().map(|i| meshed.mesh.angle(nodes[fan[*i].0].0, fan[*i].1)).sum();
            let soil = meshed.soil(nodes[fan[first].0].0);
            if closed && angle < 2.0 * soil.flow_tan().atan() + NOTCH_MARGIN {
                free.into_iter().for_each(|s| fixed[s] = true);
            }
        }
    }
}
