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

    /// The same with this tension added in all directions.
    pub(crate) fn with_mean(&self, tension: Interval) -> Self {
        Self { xx: self.xx + tension, yy: self.yy + tension, xy: self.xy }
    }
}

/// Vertical normal stress, linear over a region, that goes with a unit weight other than that of the base.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Column {
    /// A point at which it is `value`, exactly.
    pub(crate) anchor: Vector,
    pub(crate) value: Interval,
    pub(crate) gradient: Vector,
}

impl Column {
    pub(crate) fn at(&self, p: Vector) -> Interval {
        self.value + self.gradient.dot(p - self.anchor)
    }
}

/// The reference stress of a region. Its base is that of level layers at rest, in equilibrium with the weight, at the datum
/// a pressure equal to the surcharge: linear in the depth below the datum, whatever x.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ReferenceStress {
    datum: Interval,
    surcharge: Interval,
    /// Change of the base with depth.
    pub(crate) gradient: Stress,
    /// `yy - xx` of that. Exactly zero with vertical gravity, which arithmetic would not show.
    pub(crate) difference: Interval,
    column: Option<Column>,
}

impl ReferenceStress {
    /// The base for soil with this unit weight.
    pub(crate) fn new(statement: &Statement, unit_weight: f64) -> Self {
        let [x, y] = statement.gravity.map(Interval::point);
        let [gx, gy] = [x, y].map(|g| Interval::point(unit_weight) * g);
        // The components of gravity, not of the weight, which may be zero.
        let t = if x.is_zero() { Interval::ZERO } else { x / y };
        let more = Interval::point(2.0) * t.square() * gy;
        Self {
            datum: Interval::point(statement.datum),
            surcharge: Interval::point(statement.surcharge),
            gradient: Stress { xx: gy + more, yy: gy, xy: gx },
            difference: -more,
            column: None,
        }
    }

    /// Adds what balances another body force, given as a force per volume.
    pub(crate) fn with_force(self, force: Vector) -> Self {
        let Stress { xx, yy, xy } = self.gradient;
        let gradient = Stress { xx: xx + force.y, yy: yy + force.y, xy: xy + force.x };
        Self { gradient, ..self }
    }

    /// The same with another column part.
    pub(crate) fn with_column(self, column: Option<Column>) -> Self {
        Self { column, ..self }
    }

    fn depth(&self, p: Vector) -> Interval {
        self.datum - p.y
    }

    /// How it changes from a point to one that is `step` away.
    pub(crate) fn change(&self, step: Vector) -> Stress {
        let down = -step.y;
        let Stress { xx, yy, xy } = self.gradient;
        let column = self.column.map_or(Interval::ZERO, |column| column.gradient.dot(step));
        Stress { xx: xx * down, yy: yy * down + column, xy: xy * down }
    }

    pub(crate) fn column_at(&self, p: Vector) -> Interval {
        self.column.map_or(Interval::ZERO, |column| column.at(p))
    }

    /// `t . stress n` at a point, with `n` = `t` turned left. Exactly zero if both normal stresses are the same and
    /// there is no shear stress.
    pub(crate) fn shear(&self, p: Vector, t: Vector) -> Interval {
        let difference = self.difference * self.depth(p) + self.column_at(p);
        t.x * t.y * difference + (t.x.square() - t.y.square()) * self.gradient.xy * self.depth(p)
    }

    /// The stress at a point, beyond the surcharge.
    pub(crate) fn excess(&self, p: Vector) -> Stress {
        let depth = self.depth(p);
        let Stress { xx, yy, xy } = self.gradient;
        Stress { xx: xx * depth, yy: yy * depth + self.column_at(p), xy: xy * depth }
    }

    /// The stress at a point.
    pub(crate) fn at(&self, p: Vector) -> Stress {
        self.excess(p).with_mean(-self.surcharge)
    }
}
