//! A stress function for a plate problem, with random values wherever they are free.

use super::Random;
use super::plate::PLATE;
use crate::problem::Problem;
use crate::tiling::{Beyond, Side, Tiling, after};
use crate::{Chain, Condition, Gradient, Jet, LowerField, Mesh, Statement, VertexCopy};

/// What is known about one vertex copy.
#[derive(Default, Clone)]
struct Around {
    vertex: usize,
    chain: Option<usize>,
    given: Vec<usize>,
    apexes: Vec<usize>,
}

/// Fills a mesh of a [`Plate`](super::Plate) problem with values up to `size`.
pub(crate) fn fill(statement: &Statement, mesh: &Mesh, size: f64, seed: u64) -> LowerField {
    let problem = Problem::new(statement).unwrap();
    let tiling = Tiling::new(&problem, mesh).unwrap();
    let corners = split(&tiling, mesh);
    let around = look_around(statement, &tiling, mesh, &corners);
    let mut random = Random::new(seed);
    let mut next = || size * random.next();
    let copies = around.iter().map(|a| {
        let base = a.apexes.first().map_or(0, |t| around[*t].chain.unwrap());
        let jet = match (a.chain, a.apexes.as_slice(), a.given.as_slice()) {
            (Some(chain), ..) => Jet::Chain { chain },
            (_, [apex], _) => Jet::OneApex { base, apex: *apex, f: next(), turn: next() },
            (_, [_, ..], _) => Jet::ManyApexes { base, f: next() },
            (_, _, []) => Jet::Free { base: 0, f: next(), fx: next(), fy: next() },
            (_, _, [line]) => Jet::OneLine { line: *line, f: next(), along: next() },
            _ => Jet::TwoLines { f: next() },
        };
        VertexCopy { vertex: a.vertex, jet }
    });
    let copies = copies.collect();
    let smooth = statement.boundaries.iter().any(|b| b.line == PLATE && b.condition.shear_is_given());
    let gradient = if smooth {
        Gradient::Along { line: PLATE, value: next() }
    } else {
        Gradient::Free { x: next(), y: next() }
    };
    LowerField {
        mesh: mesh.clone(),
        corners,
        copies,
        chains: vec![
            Chain { constant: 0.0, gradient: Gradient::Free { x: 0.0, y: 0.0 } },
            Chain { constant: next(), gradient },
        ],
        lines: statement.lines.iter().map(|_| next()).collect(),
        slopes: mesh.triangles.iter().map(|_| [next(), next(), next()]).collect(),
        far_stress: next(),
    }
}

/// One vertex copy for each fan of triangles around a vertex that no boundary cuts.
fn split(tiling: &Tiling, mesh: &Mesh) -> Vec<[usize; 3]> {
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

fn look_around(statement: &Statement, tiling: &Tiling, mesh: &Mesh, corners: &[[usize; 3]]) -> Vec<Around> {
    let count = corners.iter().flatten().max().unwrap() + 1;
    let mut around = vec![Around::default(); count];
    for side in tiling.sides() {
        let copy = corners[side.triangle][side.corner];
        around[copy].vertex = mesh.triangles[side.triangle].corners[side.corner];
        let ends = [1, 2].map(|i| corners[side.triangle][after(side.corner, i)]);
        let Beyond::Boundary(on, condition) = tiling.beyond(side) else { continue };
        for copy in ends {
            if condition == Condition::Free {
                // The surface ahead of the plate is line 3.
                around[copy].chain = Some(usize::from(on.side.line == 3));
            }
            if condition.shear_is_given() && !around[copy].given.contains(&on.side.line) {
                around[copy].given.push(on.side.line);
            }
        }
    }
    if statement.surcharge == 0.0 {
        for copies in corners {
            for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (copies[i], copies[j])) {
                for (copy, apex) in [(a, b), (b, a)] {
                    if around[apex].chain.is_some() && !around[copy].apexes.contains(&apex) {
                        around[copy].apexes.push(apex);
                    }
                }
            }
        }
    }
    around
}
