use crate::interval::{Interval, Vector};
use crate::statement::Statement;

/// A plane stress state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stress {
    pub(crate) xx: Interval,
    pub(crate) yy: Interval,
    pub(crate) xy: Interval,
}

impl Stress {
    pub(crate) const ZERO: Self = Self { xx: Interval::ZERO, yy: Interval::ZERO, xy: Interval::ZERO };

    /// `a . stress b`.
    pub(crate) fn between(&self, a: Vector, b: Vector) -> Interval {
        a.x * b.x * self.xx + a.y * b.y * self.yy + (a.x * b.y + a.y * b.x) * self.xy
    }

    /// `stress a`.
    pub(crate) fn on(&self, a: Vector) -> Vector {
        Vector { x: self.xx * a.x + self.xy * a.y, y: self.xy * a.x + self.yy * a.y }
    }
}

/// The reference stress: level layers at rest, in equilibrium with the weight, at the datum a pressure equal to the
/// surcharge. It is linear in the depth below the datum and does not depend on x.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reference {
    datum: Interval,
    surcharge: Interval,
    /// Its change with depth.
    pub(crate) gradient: Stress,
}

impl Reference {
    /// The reference stress of soil with this unit weight.
    pub(crate) fn new(statement: &Statement, unit_weight: f64) -> Self {
        let [gx, gy] = statement.gravity.map(|g| Interval::point(unit_weight) * Interval::point(g));
        // The components of gravity, not of the weight, which may be zero.
        let t = Interval::point(statement.gravity[0]) / Interval::point(statement.gravity[1]);
        let xx = (Interval::ONE + Interval::point(2.0) * t.square()) * gy;
        Self {
            datum: Interval::point(statement.datum),
            surcharge: Interval::point(statement.surcharge),
            gradient: Stress { xx, yy: gy, xy: gx },
        }
    }

    /// `t . stress n` at height `y`, with `n` = `t` turned left. Exactly zero if both normal stresses are the same and
    /// there is no shear stress.
    pub(crate) fn shear(&self, y: Interval, t: Vector) -> Interval {
        let Stress { xx, yy, xy } = self.gradient;
        (t.x * t.y * (yy - xx) + (t.x.square() - t.y.square()) * xy) * (self.datum - y)
    }

    /// The stress at height `y`.
    pub(crate) fn at(&self, y: Interval) -> Stress {
        let depth = self.datum - y;
        let Stress { xx, yy, xy } = self.gradient;
        Stress { xx: xx * depth - self.surcharge, yy: yy * depth - self.surcharge, xy: xy * depth }
    }
}
