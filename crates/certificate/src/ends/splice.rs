//! A lower bound in plane strain that holds for a structure of any width.
//!
//! In the slice of soil between the two ends, `|y| < w/2`, take a plane stress field, and across it any normal pressure
//! `f(x, z)`; beyond, take the stress of the ground at rest, the base of the reference, and across it the same `f`. In
//! both parts `f` does not vary with y, so equilibrium needs nothing of it, and tractions agree where the parts meet. As
//! principal pressures, with `H = c cot(phi)` and `K = (1 + sin(phi))/(1 - sin(phi))`, the soil bears `p1 >= p3` with `f`
//! across if
//!
//! ```text
//! p1 + H <= K (p3 + H),      (p1 + H)/K <= f + H <= K (p3 + H)
//! ```
//!
//! So there is an `f` for the states `p` inside and `o` outside, each of which the soil bears in the plane, exactly if
//!
//! ```text
//! p1 + H <= K^2 (o3 + H)     and     o1 + H <= K^2 (p3 + H)
//! ```
//!
//! Of the tool nothing is needed but that it is thin and of the same section between its ends: it may be bent, in several pieces, or buried. On
//! the planes of its ends the soil presses with `f` on either side and does not shear. So thin side plates there, of any outline, smooth or rough,
//! carry nothing on balance, and the bound holds for tools with them too.
//!
//! Both pressures of the ground at rest are the surcharge and a part that grows with the depth. So the mean pressure and
//! the place, of which all is linear, limit the radius of Mohr's circle: states that obey are a convex set of stress and
//! place together, and the nodes decide.

use super::plate::EndedTool;
use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::problem::{Problem, ReferenceStress};

/// What the stress of the soil between the ends must obey besides its strength.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Splice {
    /// Of the ground at rest: greatest and least pressure at the datum, and their change with depth.
    surcharge: Interval,
    change: [Interval; 2],
    datum: Interval,
    /// `K^2` and `H`.
    ratio: Interval,
    apex: Interval,
}

/// Greatest mean pressure and least, each with the radius of Mohr's circle added or taken: what [`Splice`] demands at
/// one place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpliceLimit {
    greatest: Interval,
    least: Interval,
}

impl Splice {
    /// Nothing for a statement in plane strain.
    ///
    /// # Errors
    ///
    /// [`CertificateError`] if the statement has a width and is not of thin sheets in a half-space, or the ground at rest does
    /// not bear its own weight.
    pub(crate) fn new(problem: &Problem) -> Result<Option<Self>, CertificateError> {
        if problem.statement.width.is_none() {
            return Ok(None);
        }
        let EndedTool { soil: strength, material, cohesion, .. } = EndedTool::new(problem)?;
        let base = ReferenceStress::new(problem.statement, material.unit_weight);
        let (sin, one) = (strength.friction.sin, Interval::ONE);
        let mean = -(base.gradient.yy - base.difference.half());
        let radius = (base.difference.half().square() + base.gradient.xy.square()).sqrt();
        let spare = sin * mean - radius;
        if !spare.is_at_least_zero() {
            let quantity = "strength to spare of the ground at rest";
            let place = "any depth".into();
            return Err(CertificateError::NotProven {
                quantity,
                place,
                low: spare.lo(),
                unit: "stress/length",
            });
        }
        let ratio = (one + sin) / (one - sin);
        Ok(Some(Self {
            surcharge: Interval::point(problem.statement.surcharge),
            change: [mean + radius, mean - radius],
            datum: Interval::point(problem.statement.datum),
            ratio: ratio.square(),
            apex: strength.friction.cot_times(cohesion),
        }))
    }

    /// What is demanded at a place.
    pub(crate) fn at(&self, p: Vector) -> SpliceLimit {
        let depth = self.datum - p.y;
        let [greatest, least] = self.change.map(|change| self.surcharge + change * depth + self.apex);
        self.limit(greatest, least, self.apex)
    }

    /// What is demanded of the change of stress with depth, so that it can go on for ever.
    pub(crate) fn of_changes(&self) -> SpliceLimit {
        self.limit(self.change[0], self.change[1], Interval::ZERO)
    }

    fn limit(&self, greatest: Interval, least: Interval, apex: Interval) -> SpliceLimit {
        SpliceLimit { greatest: self.ratio * least - apex, least: greatest / self.ratio - apex }
    }
}

impl SpliceLimit {
    /// What the radius of Mohr's circle must not exceed, given the mean stress (tension positive).
    pub(crate) fn radii(&self, mean: Interval) -> [Interval; 2] {
        [self.greatest + mean, -mean - self.least]
    }
}
