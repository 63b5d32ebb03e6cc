use super::StressFunction;
use super::element::NodeStresses;
use crate::CertificateError;
use crate::interval::Interval;
use crate::problem::{Strength, Stress};
use crate::tiling::after;

/// The least that the strength may have to spare in a stress state; at least zero if the state is proven to be one the
/// soil can bear: `c cos(phi) - sin(phi) (xx + yy)/2 >= sqrt(((xx - yy)/2)^2 + xy^2)`.
pub(super) fn spare(strength: &Strength, stress: &Stress) -> f64 {
    let Strength { friction, cohesion } = strength;
    let radius_square = (stress.xx - stress.yy).half().square() + stress.xy.square();
    let bound = *cohesion * friction.cos - friction.sin * (stress.xx + stress.yy).half();
    if bound.is_at_least_zero() && (bound.square() - radius_square).is_at_least_zero() {
        return 0.0;
    }
    // For the message only; never zero.
    (bound.lo() - radius_square.hi().sqrt()).min(-f64::MIN_POSITIVE)
}

/// Checks that a stress state is one the soil can bear.
pub(super) fn check(
    strength: &Strength,
    stress: &Stress,
    quantity: &'static str,
    place: impl Fn() -> String,
) -> Result<(), CertificateError> {
    let low = spare(strength, stress);
    if low >= 0.0 {
        Ok(())
    } else {
        Err(CertificateError::NotProven { quantity, place: place(), low, unit: "stress" })
    }
}

impl StressFunction<'_> {
    /// Total stresses at the nodes of a triangle.
    pub(super) fn stresses(&self, triangle: usize) -> NodeStresses {
        let local = self.local(triangle);
        let mut stresses = local.stresses();
        let [p, q, r] = local.corners;
        let centroid = (p.y + q.y + r.y).third();
        for (k, part) in stresses.iter_mut().enumerate() {
            let heights = [local.corners[after(k, 1)].y, local.corners[after(k, 2)].y, centroid];
            for (stress, y) in part.iter_mut().zip(heights) {
                let reference = self.reference.at(y);
                stress.xx = stress.xx + reference.xx;
                stress.yy = stress.yy + reference.yy;
                stress.xy = stress.xy + reference.xy;
            }
        }
        stresses
    }

    /// Checks that the soil bears the stresses of a triangle. They are linear in each part, and stresses that a soil bears
    /// are a convex set, so the nodes decide. At an apex there is no stress.
    pub(super) fn check_strength(
        &self,
        triangle: usize,
        stresses: &NodeStresses,
    ) -> Result<(), CertificateError> {
        let strength = &self.problem.strengths[self.tiling.region(triangle)];
        for (k, part) in stresses.iter().enumerate() {
            for (node, stress) in part.iter().enumerate() {
                let place = || {
                    let node = ["its first corner", "its last corner", "the centroid"][node];
                    format!("triangle {triangle}, part at edge {k}, {node}")
                };
                check(strength, stress, "strength to spare", place)?;
            }
        }
        Ok(())
    }

    /// Whether a corner of a part is an apex.
    pub(super) fn node_is_apex(&self, triangle: usize, part: usize, node: usize) -> bool {
        self.is_apex(self.field.corners[triangle][after(part, 1 + node)])
    }

    /// Zero tension for soil without cohesion, as a strength to compare changes of stress with.
    pub(super) fn cone(strength: &Strength) -> Strength {
        Strength { cohesion: Interval::ZERO, ..*strength }
    }
}
