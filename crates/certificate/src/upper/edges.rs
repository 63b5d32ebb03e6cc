use super::Flow;
use crate::CertificateError;
use crate::fields::Velocity;
use crate::interval::{Angle, Interval, Vector, angle};
use crate::problem::Strength;
use crate::statement::Condition;
use crate::tiling::{OnLine, Side, after};

impl Flow<'_> {
    /// The edge of a triangle as a vector.
    fn along(&self, side: Side) -> Vector {
        let corners = self.tiling.corners(side.triangle);
        corners[after(side.corner, 2)] - corners[after(side.corner, 1)]
    }

    /// What the jump of the velocity across an edge dissipates. A jump is a thin layer of the soil of either side: the
    /// traction there is within the strength of both, so either proves a bound.
    pub(super) fn jump(&self, side: Side, other: Side) -> Result<Interval, CertificateError> {
        let here = self.on_edge(side);
        let [end, middle, start] = self.on_edge(other);
        let there = [start, middle, end];
        if here == there {
            return Ok(Interval::ZERO);
        }
        let jumps = [0, 1, 2].map(|i| self.difference(here[i], there[i]));
        let strengths = [side, other].map(|s| self.problem.strengths[self.tiling.region(s.triangle)]);
        let place = || format!("{side}");
        let [first, second] = strengths.map(|s| self.sliding(self.along(side), jumps, s, place));
        match (first, second) {
            (Ok(a), Ok(b)) => Ok(if b.hi() < a.hi() { b } else { a }),
            (Ok(a), Err(_)) | (Err(_), Ok(a)) => Ok(a),
            (Err(e), Err(_)) => Err(e),
        }
    }

    /// What the surface of a triangle adds to the bound at a boundary.
    pub(super) fn boundary(
        &self,
        side: Side,
        on: OnLine,
        condition: Condition,
    ) -> Result<Interval, CertificateError> {
        let nodes = self.on_edge(side);
        let along = self.along(side);
        let bad = |problem| Err(CertificateError::BadField { place: side.to_string(), problem });
        match condition {
            Condition::Free => {
                let sum = nodes.iter().fold(Vector::ZERO, |sum, node| sum + self.values[*node]);
                let outward = -along.turned();
                Ok(Interval::point(self.problem.statement.surcharge) * outward.dot(sum).third())
            }
            Condition::Fixed | Condition::Far => {
                let at_rest = |node: &usize| self.values[*node].x.is_zero() && self.values[*node].y.is_zero();
                if nodes.iter().all(at_rest) {
                    Ok(Interval::ZERO)
                } else {
                    bad("the soil must be at rest here")
                }
            }
            Condition::Smooth => {
                let line = on.side.line;
                let across = self.problem.direction(line).turned();
                let slides = |node: &usize| match self.field.velocities[*node] {
                    Velocity::Zero => true,
                    Velocity::Slide { line: along, .. } if along == line => true,
                    _ => self.values[*node].dot(across).is_zero(),
                };
                if nodes.iter().all(slides) {
                    Ok(Interval::ZERO)
                } else {
                    bad("the soil must be at rest here or slide along this line")
                }
            }
            Condition::Face { delta_deg, adhesion } => {
                let structure = Vector::point(self.problem.statement.velocity);
                let relative = nodes.map(|node| self.values[node] - structure);
                let face = Strength { friction: angle(delta_deg), cohesion: Interval::point(adhesion) };
                self.sliding(along, relative, face, || format!("{side}"))
            }
        }
    }

    /// What sliding along an edge dissipates, from the relative velocity of the soil on the left at the three control
    /// points. Checks that it opens as much as the friction demands: since Bernstein polynomials are not negative and add
    /// up to one, it does so between the control points too.
    fn sliding(
        &self,
        along: Vector,
        relative: [Vector; 3],
        strength: Strength,
        place: impl Fn() -> String,
    ) -> Result<Interval, CertificateError> {
        let Strength { friction, cohesion } = strength;
        let across = along.turned();
        let mut opening = Interval::ZERO;
        for (i, d) in relative.iter().enumerate() {
            let (open, slip) = (d.dot(across), d.dot(along));
            for spare in spares(open, slip, friction) {
                if !spare.is_at_least_zero() {
                    let quantity = "opening beyond what the friction demands";
                    let place = format!("{}, control point {i} of 3", place());
                    return Err(self.not_flowing(quantity, place, spare.lo()));
                }
            }
            opening = opening + open;
        }
        if cohesion.is_zero() {
            return Ok(Interval::ZERO);
        }
        Ok(cohesion * friction.cot() * opening.third())
    }
}

/// Opening less slip times friction, for slip in either sense.
fn spares(open: Interval, slip: Interval, friction: Angle) -> [Interval; 2] {
    let needed = slip * friction.tan();
    [open - needed, open + needed]
}
