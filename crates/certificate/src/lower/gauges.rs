//! Gauges: affine functions that values of the stress function are relative to. They carry no stress.

use crate::CertificateError;
use crate::fields::{Gradient, LowerField};
use crate::interval::{Interval, Vector};
use crate::problem::{Problem, exists, finite};

/// Value and slopes of the stress function at a vertex copy, beyond the affine function of the gauge `base` and the polynomial of
/// a surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct LocalJet {
    pub(super) base: usize,
    pub(super) surface: usize,
    pub(super) f: Interval,
    pub(super) slopes: Vector,
}

/// The affine functions of the gauges.
pub(super) struct Gauges<'a> {
    problem: &'a Problem<'a>,
    field: &'a LowerField,
    /// Value at the origin and slopes.
    affine: Vec<(Interval, Vector)>,
}

impl<'a> Gauges<'a> {
    pub(super) fn new(problem: &'a Problem<'a>, field: &'a LowerField) -> Result<Self, CertificateError> {
        let mut affine = Vec::with_capacity(field.gauges.len());
        for (i, gauge) in field.gauges.iter().enumerate() {
            let place = || format!("chain {i}");
            finite("value", place, gauge.constant, "force")?;
            let gradient = match gauge.gradient {
                Gradient::Free { x, y } => {
                    finite("slope along x", place, x, "force/length")?;
                    finite("slope along y", place, y, "force/length")?;
                    Vector::point([x, y])
                }
                Gradient::Along { line, value } => {
                    exists(place, "line", line, problem.statement.lines.len())?;
                    finite("slope", place, value, "force/length^2")?;
                    problem.direction(line) * Interval::point(value)
                }
            };
            affine.push((Interval::point(gauge.constant), gradient));
        }
        if affine.first().is_some_and(|(c, g)| c.is_zero() && g.x.is_zero() && g.y.is_zero()) {
            Ok(Self { problem, field, affine })
        } else {
            let problem = "it must be there and be zero, since others are relative to it";
            Err(CertificateError::BadField { place: "chain 0".into(), problem })
        }
    }

    /// Slopes of gauge `a` beyond those of gauge `b`.
    pub(super) fn gradient(&self, a: usize, b: usize) -> Vector {
        if a == b { Vector::ZERO } else { self.affine[a].1 - self.affine[b].1 }
    }

    /// Value of gauge `a` beyond that of gauge `b` at a point.
    pub(super) fn value(&self, a: usize, b: usize, at: Vector) -> Interval {
        if a == b {
            return Interval::ZERO;
        }
        self.affine[a].0 - self.affine[b].0 + self.gradient(a, b).dot(at)
    }

    /// Slope of gauge `a` beyond that of gauge `b` across a line, along `to - from` turned left.
    pub(super) fn across(&self, a: usize, b: usize, line: usize) -> Interval {
        if a == b { Interval::ZERO } else { self.one_across(a, line) - self.one_across(b, line) }
    }

    fn one_across(&self, gauge: usize, line: usize) -> Interval {
        match self.field.gauges[gauge].gradient {
            // Exactly, which arithmetic would not show.
            Gradient::Along { line: along, .. } if along == line => Interval::ZERO,
            _ => self.affine[gauge].1.dot(self.problem.direction(line).turned()),
        }
    }
}
