//! Stress in the soil beyond far lines; the [documentation of the crate](crate#beyond-far-lines) says why it balances.

use super::StressFunction;
use super::strength::Limit;
use crate::CertificateError;
use crate::interval::Interval;
use crate::mesh::{Place, Side};
use crate::problem::{Strength, Stress};
use crate::statement::Condition;
use crate::tiling::{Beyond, OnLine, after};

const QUANTITY: &str = "strength to spare of the soil beyond far lines";

impl StressFunction<'_> {
    /// Checks that the soil beyond a far edge bears the stresses that it takes over from the last node stresses.
    pub(super) fn check_far(
        &self,
        side: Side,
        on: OnLine,
        part: &[Stress; 3],
    ) -> Result<(), CertificateError> {
        let corners = self.tiling.corners(side.triangle);
        for (node, stress) in part.iter().take(2).enumerate() {
            let corner = after(side.corner, 1 + node);
            let p = corners[corner];
            let limit = self.limit(side.triangle, p);
            let base = self.references.base().at(p);
            let place = || format!("{side}, {}", ["its start", "its end"][node]);
            let lower_xx = base.xx + Interval::point(self.field.far_stress);
            let beyond = if self.is_level(on) {
                Stress { xx: lower_xx, yy: stress.yy, xy: base.xy }
            } else {
                Stress { xx: stress.xx, yy: self.overburden.beside(on.side.line, p.y), xy: base.xy }
            };
            limit.check(&beyond, QUANTITY, place)?;
            let vertex = self.tiling.mesh.triangles[side.triangle].corners[corner];
            if let Some(hand) = self.far_corner(vertex) {
                let yy = self.overburden.at_corner(hand, p.y);
                limit.check(&Stress { xx: lower_xx, yy, xy: base.xy }, QUANTITY, place)?;
                self.check_change(side, place)?;
            }
        }
        Ok(())
    }

    /// Whether a far edge is on the level far side, which is then the only one that it can be on.
    fn is_level(&self, on: OnLine) -> bool {
        self.problem.direction(on.side.line).y.is_zero()
    }

    /// Whether a vertex is where a vertical and the level far side meet: 0 on the left, 1 on the right.
    fn far_corner(&self, vertex: usize) -> Option<usize> {
        let Place::Corner { point } = self.tiling.mesh.vertices[vertex].place else { return None };
        let far = self.problem.far;
        let [x_min, x_max, y_min] = far.limits;
        let [x, y] = self.problem.statement.points[point];
        let hands = [far.left && x == x_min, far.right && x == x_max];
        hands.into_iter().position(|is| is && far.below && y == y_min)
    }

    /// Checks for each soil at the level far side that it bears the change of the reference stress with depth, however
    /// much that adds up to.
    pub(super) fn check_recession(&self) -> Result<(), CertificateError> {
        for side in self.tiling.sides() {
            if let Beyond::Boundary(on, Condition::Far) = self.tiling.beyond(side)
                && self.is_level(on)
            {
                self.check_change(side, || format!("{side}, far below"))?;
            }
        }
        Ok(())
    }

    fn check_change(&self, side: Side, place: impl Fn() -> String) -> Result<(), CertificateError> {
        let strength: &Strength = &self.problem.strengths[self.tiling.region(side.triangle)];
        let water = -Interval::point(strength.pore_pressure.gradient[1]);
        let limit = Limit::of_changes(strength, self.splice.as_ref(), water);
        let (change, difference) = self.overburden.below;
        let mean = change.yy - difference.half();
        limit.check_parts(mean, difference.half(), change.xy, QUANTITY, place)
    }
}
