//! Soil beyond far lines: only the stress across the line is the mesh's.

use soilctl_certificate::{Condition, LineUse, Place};
use soilctl_conic::Form;

use super::{Lower, Stress};
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::vector::Point;

/// Weight of the soil above a point beside a vertical far side, from its own surface on, as the vertical stress.
fn overburden(lower: &Lower, problem: &Problem, side: LineUse, at: Point) -> Form {
    let x = problem.ends(side.line)[0][0];
    let beside: Vec<(f64, f64, f64)> = problem
        .statement()
        .boundaries
        .iter()
        .filter(|b| b.condition == Condition::Far)
        .filter_map(|b| {
            let [p, q] = problem.ends(b.line);
            let soil = &problem.soils[problem.owner(b.side())?];
            (p[0] == x && q[0] == x).then(|| (p[1].min(q[1]), p[1].max(q[1]), soil.unit_weight))
        })
        .collect();
    let mut stress = Form::constant(-lower.reference.surcharge());
    for (low, high, weight) in beside {
        let above = (high - at[1].max(low)).max(0.0);
        stress.add(above, &lower.reference.rate(weight));
    }
    stress
}

impl Lower {
    /// Yield of the soil beyond a far line at one end of an edge.
    pub(super) fn add_far(
        &mut self,
        problem: &Problem,
        mesh: &Mesh,
        side: LineUse,
        vertex: usize,
        s: &Stress,
        scale: f64,
    ) {
        let region = problem.owner(side).unwrap_or(0);
        let soil = &problem.soils[region];
        let at = mesh.vertices[vertex].position;
        let [p, q] = problem.ends(side.line);
        let [xx, yy, xy] = self.reference.at(region, at);
        let plain = self.is_plain(problem);
        if p[0] == q[0] {
            let above = if plain { yy } else { overburden(self, problem, side, at) };
            return self.add_yield(soil, &[s[0].clone(), above, xy], at, scale);
        }
        let Some(far) = self.function.far_stress else { return };
        let along = xx.plus(1.0, &Form::unknown(far, 1.0));
        if let Some(beside) = far_corner(problem, mesh, vertex) {
            let above = if plain { yy } else { overburden(self, problem, beside, at) };
            let state = [along.clone(), above, xy.clone()];
            self.add_yield(soil, &state, at, scale);
        }
        self.add_yield(soil, &[along, s[1].clone(), xy], at, scale);
    }

    /// Whether soil beyond vertical far sides has the reference's own vertical stress.
    fn is_plain(&self, problem: &Problem) -> bool {
        let s = problem.statement();
        let weight = problem.soils[0].unit_weight;
        problem.soils.iter().all(|soil| soil.unit_weight == weight)
            && s.boundaries.iter().filter(|b| b.condition == Condition::Far).all(|b| {
                let [p, q] = problem.ends(b.line);
                // No far side reaches higher or starts lower than the datum.
                p[0] != q[0] || (p[1].max(q[1]) <= s.datum && !starts_below(problem, b.side()))
            })
    }
}

/// Whether the run of vertical far sides that a side belongs to has its upper end below the datum.
fn starts_below(problem: &Problem, side: LineUse) -> bool {
    let x = problem.ends(side.line)[0][0];
    let s = problem.statement();
    let highest = s
        .boundaries
        .iter()
        .filter(|b| b.condition == Condition::Far && problem.ends(b.line).iter().all(|p| p[0] == x))
        .flat_map(|b| problem.ends(b.line))
        .map(|p| p[1])
        .fold(f64::NEG_INFINITY, f64::max);
    highest < s.datum
}

/// The vertical far side that meets a level one at a vertex.
fn far_corner(problem: &Problem, mesh: &Mesh, vertex: usize) -> Option<LineUse> {
    let Place::Corner { point } = mesh.vertices[vertex].place else { return None };
    problem.statement().boundaries.iter().find_map(|b| {
        let [p, q] = problem.ends(b.line);
        let here = b.condition == Condition::Far && problem.statement().lines[b.line].touches(point);
        (here && p[0] == q[0]).then(|| b.side())
    })
}
