use std::ops::Add;

use super::VelocityField;
use super::resistance::Resisted;
use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::statement::Objective;

/// Power of a flow.
#[derive(Debug, Clone, Copy)]
pub(super) struct Power {
    /// Dissipation less the power of dead loads.
    pub(super) net: Interval,
    /// Power of the load whose factor is bounded.
    pub(super) live: Interval,
}

impl Power {
    pub(super) const ZERO: Self = Self { net: Interval::ZERO, live: Interval::ZERO };

    /// Power that is dissipated.
    pub(super) fn dissipated(net: Interval) -> Self {
        Self { net, ..Self::ZERO }
    }

    /// Power that soil takes up, where the water in its pores is a load like others.
    pub(super) fn resisted(resisted: Resisted, objective: &Objective) -> Self {
        match objective {
            Objective::Everything => Self { net: resisted.strength, live: resisted.water },
            _ => Self::dissipated(resisted.all()),
        }
    }

    /// One of two, either of which proves a bound: that which does so with more to spare.
    pub(super) fn or_lesser(self, other: Self) -> Self {
        if self.live.is_zero() && other.live.is_zero() {
            return Self::dissipated(self.net.or_lesser(other.net));
        }
        let spare = |p: &Self| (p.net - p.live).hi();
        if spare(&other) < spare(&self) { other } else { self }
    }

    /// Power of a load.
    pub(super) fn of_load(power: Interval, live: bool) -> Self {
        if live { Self { live: power, ..Self::ZERO } } else { Self::dissipated(-power) }
    }

    /// The bound that follows.
    pub(super) fn bound(self, objective: &Objective) -> Result<f64, CertificateError> {
        let place = || "the whole flow".to_owned();
        let bound = match objective {
            Objective::Structure { .. } => self.net,
            Objective::Loads | Objective::Body { .. } | Objective::Everything if self.live.is_positive() => {
                self.net / self.live
            }
            Objective::Loads | Objective::Body { .. } | Objective::Everything => {
                let problem = "the load whose factor is bounded is not proven to do work on it";
                return Err(CertificateError::BadField { place: place(), problem });
            }
        };
        if bound.hi() < f64::INFINITY {
            return Ok(bound.hi());
        }
        Err(CertificateError::NotProven {
            quantity: "difference of the largest number and the bound",
            place: place(),
            low: f64::NEG_INFINITY,
            unit: "force*velocity",
        })
    }
}

impl Add for Power {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { net: self.net + other.net, live: self.live + other.live }
    }
}

impl VelocityField<'_> {
    /// Power of body forces on a triangle, from the integral of the velocity.
    pub(super) fn body(&self, triangle: usize, flow: Vector) -> Power {
        let statement = self.problem.statement;
        let weight = statement.regions[self.tiling.region(triangle)].material.unit_weight;
        let force = |gravity: [f64; 2]| (Vector::point(gravity) * Interval::point(weight)).dot(flow);
        let all = statement.objective == Objective::Everything;
        let dead = Power::of_load(force(statement.gravity), all);
        match statement.objective {
            Objective::Body { gravity } => dead + Power::of_load(force(gravity), true),
            Objective::Structure { .. } | Objective::Loads | Objective::Everything => dead,
        }
    }
}
