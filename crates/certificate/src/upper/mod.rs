//! The upper bound: a velocity field is proven kinematically admissible, and its power adds up to the bound.

mod check;
mod edge_velocity;
mod edges;
mod jets;
mod means;
mod members;
mod power;
mod quadratic;
mod resistance;
mod slips;
mod stream;
#[cfg(test)]
mod tests;
mod walls;

use crate::CertificateError;
use crate::fields::{Flow, UpperField};
use crate::interval::{Interval, Vector};
use crate::problem::Problem;
use crate::statement::Statement;
use crate::tiling::{Tiling, after};

use jets::StreamValue;
use power::Power;
use walls::Walls;

/// Proves an upper bound on the statement's objective: the force that the soil can resist times the structure's velocity,
/// or the factor on the live loads or the body force.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a problem or not covered, if the field is not built as it must be, or
/// if the flow is not proven to be one that the soil allows and, for a factor, one on which the load does work.
pub fn prove_upper(statement: &Statement, field: &UpperField) -> Result<f64, CertificateError> {
    let problem = Problem::new(statement)?;
    check::plane(statement)?;
    check::faces(&problem)?;
    let tiling = Tiling::new(&problem, &field.mesh)?;
    let velocity = VelocityField::new(&problem, &tiling, field)?;
    let mut power = Power::ZERO;
    for triangle in 0..field.mesh.triangles.len() {
        power = power + velocity.triangle(triangle)?;
    }
    for side in tiling.sides() {
        power = power + velocity.edge(side)?;
    }
    power = power + velocity.members()?;
    power.bound(&statement.objective)
}

/// A polynomial velocity on a triangle: its corners, then its control points at corners and edges.
pub(crate) type Piece = ([Vector; 3], [Vector; 6]);

/// Velocities of members along themselves and across on their edges, and the slip of bars, in the order of [`Tiling::along_members`].
pub(crate) type MemberVelocities = Result<Vec<[[Interval; 3]; 3]>, CertificateError>;

/// Velocities on the pieces of each triangle, and of members, on a checked mesh. No flow rule is checked.
pub(crate) fn piece_velocities<T>(
    statement: &Statement,
    field: &UpperField,
    with: impl FnOnce(&Tiling, Vec<Vec<Piece>>, MemberVelocities) -> T,
) -> Result<T, CertificateError> {
    let problem = Problem::new(statement)?;
    let tiling = Tiling::new(&problem, &field.mesh)?;
    let velocity = VelocityField::new(&problem, &tiling, field)?;
    let pieces = (0..field.mesh.triangles.len()).map(|t| velocity.pieces(t)).collect();
    Ok(with(&tiling, pieces, velocity.along_members()))
}

/// A velocity field on a checked mesh.
struct VelocityField<'a> {
    problem: &'a Problem<'a>,
    tiling: &'a Tiling<'a>,
    field: &'a UpperField,
    /// Velocities of the control points.
    velocities: Vec<Vector>,
    /// The stream function at the vertex copies.
    stream: Vec<StreamValue>,
}

impl<'a> VelocityField<'a> {
    fn new(
        problem: &'a Problem<'a>,
        tiling: &'a Tiling<'a>,
        field: &'a UpperField,
    ) -> Result<Self, CertificateError> {
        check::numbers(problem, field)?;
        let velocities: Vec<Vector> =
            field.velocities.iter().map(|v| quadratic::velocity(problem, *v)).collect();
        check::flows(problem, tiling, field, &velocities)?;
        let walls = Walls::new(problem, tiling, field)?;
        let stream = jets::values(problem, tiling, field, &walls)?;
        Ok(Self { problem, tiling, field, velocities, stream })
    }

    /// What a triangle adds to the power. Checks the flow rule.
    fn triangle(&self, triangle: usize) -> Result<Power, CertificateError> {
        match self.field.flows[triangle] {
            Flow::Quadratic(nodes) => self.quadratic(triangle, nodes),
            Flow::Stream { corners, .. } => Ok(self.stream(triangle, corners)),
        }
    }

    /// The velocity of a triangle.
    fn pieces(&self, triangle: usize) -> Vec<Piece> {
        match self.field.flows[triangle] {
            Flow::Quadratic(nodes) => {
                vec![(self.tiling.corners(triangle), nodes.map(|node| self.velocities[node]))]
            }
            Flow::Stream { corners, .. } => self.stream_pieces(triangle, corners),
        }
    }

    /// For each corner, the edge opposite to it.
    fn edges(&self, triangle: usize) -> [Vector; 3] {
        let corners = self.tiling.corners(triangle);
        [0, 1, 2].map(|k| corners[after(k, 2)] - corners[after(k, 1)])
    }
}
