//! The field of a stress function that is known everywhere.

use super::around::{look_around, split};
use crate::problem::Problem;
use crate::tiling::Tiling;
use crate::{Gauge, Gradient, Jet, LowerField, Mesh, Statement, VertexCopy};

/// Value and slopes at a point.
type Function<'a> = &'a dyn Fn([f64; 2]) -> [f64; 3];

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Fits a field to a stress function that has no apex. Stresses beyond the reference must be linear on each triangle.
pub(crate) fn fitted(statement: &Statement, mesh: &Mesh, multiplier: f64, f: Function) -> LowerField {
    let problem = Problem::new(statement).unwrap();
    let tiling = Tiling::new(&problem, mesh).unwrap();
    let corners = split(&tiling, mesh);
    let around = look_around(&problem, &tiling, mesh, &corners);
    let runs = problem.statement.runs(|b| b.condition.traction_is_given());
    let starts: Vec<[f64; 2]> = runs.iter().map(|run| problem.walked(run.sides[0])[0]).collect();
    // Less the affine function that touches where the first run starts.
    let first = starts.first().map_or(([0.0; 2], [0.0; 3]), |p| (*p, f(*p)));
    let f = |p: [f64; 2]| {
        let ([x, y], [value, fx, fy]) = (first.0, first.1);
        let [v, vx, vy] = f(p);
        [v - value - dot([fx, fy], [p[0] - x, p[1] - y]), vx - fx, vy - fy]
    };
    let at = |v: usize| mesh.vertices[v].position;
    let copies = around.iter().map(|a| {
        let [value, fx, fy] = f(at(a.vertex));
        let jet = match (a.gauge, a.given.as_slice()) {
            (Some(gauge), _) => Jet::Gauge { gauge },
            (_, []) => Jet::Free { base: 0, f: value, fx, fy },
            (_, [line]) => {
                let t = direction(statement, *line);
                Jet::OneLine { line: *line, f: value, along: dot(t, [fx, fy]) / dot(t, t) }
            }
            _ => Jet::TwoLines { f: value },
        };
        VertexCopy { vertex: a.vertex, jet }
    });
    let zero = Gauge { constant: 0.0, gradient: Gradient::Free { x: 0.0, y: 0.0 } };
    let later = starts.iter().skip(1).map(|p| {
        let [value, x, y] = f(*p);
        Gauge { constant: value - dot([x, y], *p), gradient: Gradient::Free { x, y } }
    });
    let across = |t: [f64; 2], p: [f64; 2]| {
        let [_, fx, fy] = f(p);
        dot([-t[1], t[0]], [fx, fy])
    };
    let slopes = mesh.triangles.iter().map(|t| {
        [0, 1, 2].map(|k| {
            let [a, b] = [1, 2].map(|i| at(t.corners[(k + i) % 3]));
            across([b[0] - a[0], b[1] - a[1]], [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0])
        })
    });
    LowerField {
        mesh: mesh.clone(),
        copies: copies.collect(),
        gauges: std::iter::once(zero).chain(later).collect(),
        lines: (0..statement.lines.len())
            .map(|line| across(direction(statement, line), statement.points[statement.lines[line].from]))
            .collect(),
        slopes: slopes.collect(),
        corners,
        far_stress: 0.0,
        multiplier,
    }
}

fn direction(statement: &Statement, line: usize) -> [f64; 2] {
    let [a, b] = [statement.lines[line].from, statement.lines[line].to].map(|p| statement.points[p]);
    [b[0] - a[0], b[1] - a[1]]
}
