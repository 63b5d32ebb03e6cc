use super::Flow;
use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::tiling::after;

impl Flow<'_> {
    /// What a triangle adds to the bound: dissipation less the power of the weight. Checks the flow rule.
    ///
    /// The strain rate is linear, so it obeys the flow rule, a convex cone, everywhere if it does at the corners. At
    /// corner `k` the gradient of the velocity is `sum_i (b_ki - b_k) e_i' / area`, over the other two corners `i`, with
    /// `e_i'` the edge opposite to corner `i` turned left. The factor `1/area` is left out until it cancels.
    pub(super) fn triangle(&self, triangle: usize) -> Result<Interval, CertificateError> {
        let corners = self.tiling.corners(triangle);
        let nodes = self.field.nodes[triangle];
        let inward = [0, 1, 2].map(|i| (corners[after(i, 2)] - corners[after(i, 1)]).turned());
        let strength = self.problem.strengths[self.tiling.region(triangle)];
        let mut opening = Interval::ZERO;
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
            let least = strength.friction.sin.square() * (stretch.square() + shear.square());
            let spare = volume.square() - least;
            if !(volume.is_at_least_zero() && spare.is_at_least_zero()) {
                let low = volume.lo() - least.hi().sqrt();
                let quantity = "dilation beyond what the friction demands";
                return Err(self.not_flowing(quantity, format!("triangle {triangle}, corner {k}"), low));
            }
            opening = opening + volume;
        }
        let tension = if strength.cohesion.is_zero() {
            Interval::ZERO
        } else {
            strength.cohesion * strength.friction.cot()
        };
        // The mean of a linear function, and of a quadratic polynomial in Bernstein form, is that of its coefficients.
        let mean = nodes.iter().fold(Vector::ZERO, |sum, node| sum + self.values[*node]);
        let weight = self.problem.statement.regions[self.tiling.region(triangle)].material.unit_weight;
        let body = Vector::point(self.problem.statement.gravity) * Interval::point(weight);
        let area = self.tiling.double_area(triangle).half();
        Ok(tension * opening.third() - body.dot(mean) * area / Interval::point(6.0))
    }

    pub(super) fn not_flowing(&self, quantity: &'static str, place: String, low: f64) -> CertificateError {
        CertificateError::NotProven { quantity, place, low, unit: "velocity*length" }
    }
}
