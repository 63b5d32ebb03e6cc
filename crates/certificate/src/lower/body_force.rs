use crate::fields::LowerField;
use crate::interval::{Interval, Vector};
use crate::statement::{Objective, Statement};

/// The body force on the soil: gravity, and the force whose factor is bounded.
#[derive(Debug, Clone, Copy)]
pub(super) struct BodyForce {
    gravity: [f64; 2],
    /// The second force and its factor.
    live: Option<([f64; 2], Interval)>,
}

impl BodyForce {
    pub(super) fn new(statement: &Statement, field: &LowerField) -> Self {
        let live = match statement.objective {
            Objective::Body { gravity } => Some((gravity, Interval::point(field.multiplier))),
            Objective::Structure { .. } | Objective::Loads | Objective::Everything => None,
        };
        Self { gravity: statement.gravity, live }
    }

    /// Whether all of it is vertical.
    pub(super) fn is_vertical(&self) -> bool {
        self.gravity[0] == 0.0 && self.live.is_none_or(|(g, _)| g[0] == 0.0)
    }

    /// The live force on soil of this unit weight; none if there is no such force.
    pub(super) fn live(&self, unit_weight: f64) -> Option<Vector> {
        self.live.map(|(g, factor)| Vector::point(g) * Interval::point(unit_weight) * factor)
    }

    /// The vertical force on soil of this unit weight.
    pub(super) fn down(&self, unit_weight: f64) -> Interval {
        let dead = Interval::point(unit_weight) * Interval::point(self.gravity[1]);
        self.live(unit_weight).map_or(dead, |live| dead + live.y)
    }

    /// The vertical force on soil of unit weight one.
    pub(super) fn along_y(&self) -> Interval {
        self.down(1.0)
    }
}
