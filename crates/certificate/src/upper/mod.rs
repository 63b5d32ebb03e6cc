//! The upper bound: the power of a flow in which every bit of soil dilates at least as much as its friction demands.

mod edges;
mod flow;
#[cfg(test)]
mod tests;

use crate::CertificateError;
use crate::fields::{UpperField, Velocity};
use crate::interval::{Interval, Vector};
use crate::problem::{Problem, exists, finite};
use crate::statement::Statement;
use crate::tiling::{Beyond, Side, Tiling, after};

/// Proves an upper bound on the force that the soil can resist, times the structure's velocity.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a problem or not covered, if the field is not built as it must be, or
/// if the flow is not proven to be one that the soil allows.
pub fn prove_upper(statement: &Statement, field: &UpperField) -> Result<f64, CertificateError> {
    let problem = Problem::new(statement)?;
    if let Some(region) = statement.regions.iter().position(|r| r.material.phi_deg == 0.0) {
        let what = "an upper bound for soil without friction";
        return Err(CertificateError::NotCovered { place: format!("region {region}"), what });
    }
    let tiling = Tiling::new(&problem, &field.mesh)?;
    let flow = Flow::new(&problem, &tiling, field)?;
    let mut power = Interval::ZERO;
    for triangle in 0..field.nodes.len() {
        power = power + flow.triangle(triangle)?;
    }
    for side in tiling.sides() {
        power = power + flow.edge(side)?;
    }
    if power.hi() < f64::INFINITY {
        Ok(power.hi())
    } else {
        Err(CertificateError::NotProven {
            quantity: "difference of the largest number and the bound",
            place: "the whole flow".into(),
            low: f64::NEG_INFINITY,
            unit: "force*velocity",
        })
    }
}

/// A velocity field on a checked mesh.
struct Flow<'a> {
    problem: &'a Problem<'a>,
    tiling: &'a Tiling<'a>,
    field: &'a UpperField,
    /// Velocities of the control points.
    values: Vec<Vector>,
}

impl<'a> Flow<'a> {
    fn new(
        problem: &'a Problem<'a>,
        tiling: &'a Tiling<'a>,
        field: &'a UpperField,
    ) -> Result<Self, CertificateError> {
        let (found, needed) = (field.nodes.len(), field.mesh.triangles.len());
        if found != needed {
            return Err(CertificateError::Length { list: "nodes", found, needed, each: "triangle" });
        }
        let count = field.velocities.len();
        for (i, nodes) in field.nodes.iter().enumerate() {
            for node in nodes {
                exists(|| format!("triangle {i}"), "control point", *node, count)?;
            }
        }
        let mut values = Vec::with_capacity(count);
        for (i, velocity) in field.velocities.iter().enumerate() {
            let place = || format!("control point {i}");
            values.push(match *velocity {
                Velocity::Zero => Vector::ZERO,
                Velocity::Slide { line, value } => {
                    exists(place, "line", line, problem.statement.lines.len())?;
                    finite("velocity", place, value, "")?;
                    problem.direction(line) * Interval::point(value)
                }
                Velocity::Free { x, y } => {
                    finite("velocity along x", place, x, "")?;
                    finite("velocity along y", place, y, "")?;
                    Vector::point([x, y])
                }
            });
        }
        Ok(Self { problem, tiling, field, values })
    }

    /// Control points on an edge: at its start, in the middle, at its end.
    fn on_edge(&self, side: Side) -> [usize; 3] {
        let nodes = self.field.nodes[side.triangle];
        [nodes[after(side.corner, 1)], nodes[3 + side.corner], nodes[after(side.corner, 2)]]
    }

    /// Difference of two velocities, exactly zero if they are one.
    fn difference(&self, a: usize, b: usize) -> Vector {
        if a == b { Vector::ZERO } else { self.values[a] - self.values[b] }
    }

    /// What an edge adds to the bound.
    fn edge(&self, side: Side) -> Result<Interval, CertificateError> {
        match self.tiling.beyond(side) {
            // Once for the two triangles.
            Beyond::Soil(other) if other < side => Ok(Interval::ZERO),
            Beyond::Soil(other) => self.jump(side, other),
            Beyond::Boundary(on, condition) => self.boundary(side, on, condition),
        }
    }
}
