//! Stress in the soil beyond far lines; the [documentation of the crate](crate#beyond-far-lines) says why it balances.

use super::StressFunction;
use super::strength::check;
use crate::CertificateError;
use crate::interval::Interval;
use crate::mesh::Place;
use crate::problem::Stress;
use crate::statement::Condition;
use crate::tiling::{Beyond, Side, after};

const QUANTITY: &str = "strength to spare of the soil beyond far lines";

impl StressFunction<'_> {
    /// Checks that the soil beyond a far edge bears the stresses that it takes over from the last node stresses.
    pub(super) fn check_far(&self, side: Side, part: &[Stress; 3]) -> Result<(), CertificateError> {
        let strength = &self.problem.strengths[self.tiling.region(side.triangle)];
        let corners = self.tiling.corners(side.triangle);
        let level = self.is_level(side);
        let far_stress = Interval::point(self.field.far_stress);
        for (node, stress) in part.iter().take(2).enumerate() {
            let corner = after(side.corner, 1 + node);
            let reference = self.reference.at(corners[corner].y);
            let place = || format!("{side}, {}", ["its start", "its end"][node]);
            let lower = Stress { xx: reference.xx + far_stress, ..reference };
            // At an apex both sides are free of stress.
            if !self.node_is_apex(side.triangle, side.corner, node) {
                let beyond = if level {
                    Stress { yy: stress.yy, ..lower }
                } else {
                    Stress { xx: stress.xx, ..reference }
                };
                check(strength, &beyond, QUANTITY, place)?;
            }
            if self.is_far_corner(self.tiling.mesh.triangles[side.triangle].corners[corner]) {
                check(strength, &lower, QUANTITY, place)?;
                self.check_change(strength, place)?;
            }
        }
        Ok(())
    }

    /// Whether a far edge is on the level far side, which is then the only one that it can be on.
    fn is_level(&self, side: Side) -> bool {
        match self.tiling.beyond(side) {
            Beyond::Boundary(on, _) => self.problem.direction(on.side.line).y.is_zero(),
            Beyond::Soil(_) => false,
        }
    }

    /// Whether a vertex is where a vertical and the level far side meet.
    fn is_far_corner(&self, vertex: usize) -> bool {
        let Place::Corner { point } = self.tiling.mesh.vertices[vertex].place else { return false };
        let far = self.problem.far;
        let [x_min, x_max, y_min] = far.limits;
        let [x, y] = self.problem.statement.points[point];
        far.below && y == y_min && ((far.left && x == x_min) || (far.right && x == x_max))
    }

    /// Checks for each soil at the level far side that it bears the change of the reference stress with depth, however
    /// much that adds up to.
    pub(super) fn check_recession(&self) -> Result<(), CertificateError> {
        for side in self.tiling.sides() {
            if let Beyond::Boundary(_, Condition::Far) = self.tiling.beyond(side)
                && self.is_level(side)
            {
                let strength = &self.problem.strengths[self.tiling.region(side.triangle)];
                self.check_change(strength, || format!("{side}, far below"))?;
            }
        }
        Ok(())
    }

    fn check_change(
        &self,
        strength: &crate::problem::Strength,
        place: impl Fn() -> String,
    ) -> Result<(), CertificateError> {
        check(&Self::cone(strength), &self.reference.gradient, QUANTITY, place)
    }
}
