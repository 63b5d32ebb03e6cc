//! A stress function with random values wherever they are free.

use super::Random;
use super::around::{look_around, split};
use crate::problem::Problem;
use crate::tiling::Tiling;
use crate::{Gauge, Gradient, Jet, LowerField, Mesh, Statement, VertexCopy};

/// Fills a mesh with values up to `size`.
pub(crate) fn fill(statement: &Statement, mesh: &Mesh, size: f64, seed: u64) -> LowerField {
    let problem = Problem::new(statement).unwrap();
    let tiling = Tiling::new(&problem, mesh).unwrap();
    let corners = split(&tiling, mesh);
    let around = look_around(&problem, &tiling, mesh, &corners);
    let mut random = Random::new(seed);
    let mut next = || size * random.next();
    let copies = around.iter().map(|a| {
        let base = a.apexes.first().map_or(0, |t| around[*t].gauge.unwrap());
        let jet = match (a.gauge, a.apexes.as_slice(), a.given.as_slice()) {
            (Some(gauge), ..) => Jet::Gauge { gauge },
            (_, [apex], _) => Jet::OneApex { base, apex: *apex, f: next(), turn: next() },
            (_, [_, ..], _) => Jet::ManyApexes { base, f: next() },
            (_, _, []) => Jet::Free { base: 0, f: next(), fx: next(), fy: next() },
            (_, _, [line]) => Jet::OneLine { line: *line, f: next(), along: next() },
            _ => Jet::TwoLines { f: next() },
        };
        VertexCopy { vertex: a.vertex, jet }
    });
    let copies = copies.collect();
    // A line of given shear that the first gauge touches too has a known slope across.
    let on_line =
        |line: usize, gauge: usize| around.iter().any(|a| a.gauge == Some(gauge) && a.given.contains(&line));
    let count = around.iter().filter_map(|a| a.gauge).max().unwrap_or(0) + 1;
    let gauges = (0..count).map(|gauge| {
        let shared = (0..statement.lines.len()).find(|line| on_line(*line, gauge) && on_line(*line, 0));
        let gradient = match shared {
            _ if gauge == 0 => Gradient::Free { x: 0.0, y: 0.0 },
            Some(line) => Gradient::Along { line, value: next() },
            None => Gradient::Free { x: next(), y: next() },
        };
        Gauge { constant: if gauge == 0 { 0.0 } else { next() }, gradient }
    });
    LowerField {
        mesh: mesh.clone(),
        corners,
        copies,
        gauges: gauges.collect(),
        lines: statement.lines.iter().map(|_| next()).collect(),
        slopes: mesh.triangles.iter().map(|_| [next(), next(), next()]).collect(),
        far_stress: next(),
        multiplier: next(),
    }
}
