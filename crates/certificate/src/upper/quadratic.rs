//! Quadratic flows of soil with friction.

use super::VelocityField;
use super::power::Power;
use super::resistance::Resistance;
use crate::CertificateError;
use crate::fields::Velocity;
use crate::interval::{Interval, Vector};
use crate::problem::Problem;
use crate::tiling::after;

/// What the velocity of a control point means. Its numbers have been checked.
pub(super) fn velocity(problem: &Problem, velocity: Velocity) -> Vector {
    match velocity {
        Velocity::Zero => Vector::ZERO,
        Velocity::Slide { line, value } => problem.direction(line) * Interval::point(value),
        Velocity::Free { x, y } => Vector::point([x, y]),
    }
}

impl VelocityField<'_> {
    /// Difference of two velocities, exactly zero if they are one.
    pub(super) fn difference(&self, a: usize, b: usize) -> Vector {
        if a == b { Vector::ZERO } else { self.velocities[a] - self.velocities[b] }
    }

    /// What a triangle adds to the power. Checks the flow rule.
    ///
    /// The strain rate is linear, so it obeys the flow rule, a convex cone, everywhere if it does at the corners. At
    /// corner `k` the gradient of the velocity is `sum_i (b_ki - b_k) e_i' / area`, over the other two corners `i`, with
    /// `e_i'` the edge opposite to corner `i` turned left. The factor `1/area` is left out: it cancels in the integrals.
    pub(super) fn quadratic(&self, triangle: usize, nodes: [usize; 6]) -> Result<Power, CertificateError> {
        if nodes.iter().all(|node| self.velocities[*node].is_zero()) {
            return Ok(Power::ZERO);
        }
        let inward = self.edges(triangle).map(Vector::turned);
        let strength = &self.problem.strengths[self.tiling.region(triangle)];
        let friction = strength.flow_friction();
        let (mut dilation, mut shearing) = ([Interval::ZERO; 3], [Interval::ZERO; 3]);
        for k in 0..3 {
            let (i, j) = (after(k, 1), after(k, 2));
            // The edge between corners k and i is edge j.
            let parts = [(nodes[3 + j], inward[i]), (nodes[3 + i], inward[j])];
            let parts = parts.map(|(node, gradient)| (self.difference(node, nodes[k]), gradient));
            let sum =
                |of: fn(Vector, Vector) -> Interval| of(parts[0].0, parts[0].1) + of(parts[1].0, parts[1].1);
            let volume = sum(|v, g| v.dot(g));
            let stretch = sum(|v, g| v.x * g.x - v.y * g.y);
            let shear = sum(|v, g| v.x * g.y + v.y * g.x);
            let rate_square = stretch.square() + shear.square();
            let least = friction.sin.square() * rate_square;
            let spare = volume.square() - least;
            if !(volume.is_at_least_zero() && spare.is_at_least_zero()) {
                let low = volume.lo() - least.hi().sqrt();
                let quantity = "dilation beyond what the friction demands";
                let place = format!("triangle {triangle}, corner {k}");
                return Err(CertificateError::NotProven { quantity, place, low, unit: "velocity*length" });
            }
            (dilation[k], shearing[k]) = (volume, rate_square.sqrt());
        }
        let resistance = Resistance::new(strength, self.tiling.corners(triangle));
        let resisted = resistance.of_triangle(dilation, shearing);
        // The mean of a quadratic polynomial in Bernstein form is that of its coefficients.
        let sum = nodes.iter().fold(Vector::ZERO, |sum, node| sum + self.velocities[*node]);
        let area_by_6 = self.tiling.double_area(triangle) / Interval::point(12.0);
        let resisted = Power::resisted(resisted, &self.problem.statement.objective);
        Ok(resisted + self.body(triangle, sum * area_by_6))
    }
}
