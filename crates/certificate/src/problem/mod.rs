//! A statement that has been checked, with what the proofs look up in it.

mod anisotropy;
mod envelope;
mod far;
mod grip;
mod members;
mod numbers;
mod outline;
mod reference;
mod sides;

use crate::CertificateError;
use crate::interval::{Angle, Interval, Vector, angle};
use crate::statement::{Condition, LineUse, Linear, Material, Statement};

pub(crate) use anisotropy::Anisotropy;
pub(crate) use envelope::{Envelope, Straight, StressPoint};
pub(crate) use far::FarFrame;
pub(crate) use grip::Gripped;
pub(crate) use members::{Attached, Piece};
pub(crate) use numbers::{exists, finite};
pub(crate) use reference::{Column, ReferenceStress, Stress};

/// Strength of one region.
#[derive(Debug, Clone)]
pub(crate) struct Strength {
    pub(crate) friction: Angle,
    pub(crate) cohesion: Linear,
    pub(crate) pore_pressure: Linear,
    pub(crate) tension: Option<Interval>,
    /// What limits it beside friction and cohesion.
    pub(crate) envelope: Option<Envelope>,
    /// How it depends on the direction, where it does.
    pub(crate) anisotropy: Option<Anisotropy>,
}

impl Strength {
    pub(crate) fn new(material: &Material) -> Self {
        Self {
            friction: angle(material.phi_deg),
            cohesion: material.cohesion,
            pore_pressure: material.pore_pressure,
            tension: material.tension.map(Interval::point),
            envelope: material.envelope.as_ref().map(|envelope| Envelope::new(material, envelope)),
            anisotropy: material.anisotropy.as_ref().map(Anisotropy::new),
        }
    }

    /// The lines of which a lower bound obeys each, beside that of friction and cohesion.
    pub(crate) fn further(&self) -> &[Straight] {
        self.envelope.as_ref().map_or(&[], |envelope| &envelope.inside)
    }

    /// What counts as the shear rate, from `exx - eyy` and `2 exy`.
    pub(crate) fn shear_rate(&self, difference: Interval, shear: Interval) -> Interval {
        match &self.anisotropy {
            Some(anisotropy) => anisotropy.rate(difference, shear),
            None => (difference.square() + shear.square()).sqrt(),
        }
    }

    /// The friction that the flow rule asks for: where pressure is greatest.
    pub(crate) fn flow_friction(&self) -> Angle {
        self.envelope
            .as_ref()
            .and_then(|envelope| envelope.outside.last())
            .map_or(self.friction, |line| line.friction)
    }
}

impl Linear {
    /// An enclosure of its value at a point. Exactly zero if it is zero everywhere.
    pub(crate) fn enclosed(&self, p: Vector) -> Interval {
        Interval::point(self.at_origin) + Vector::point(self.gradient).dot(p)
    }
}

/// A checked statement.
#[derive(Debug)]
pub(crate) struct Problem<'a> {
    pub(crate) statement: &'a Statement,
    /// One for each region.
    pub(crate) strengths: Vec<Strength>,
    /// How far the soil goes on beyond far lines.
    pub(crate) far: FarFrame,
    /// For each line, the region on its left when walked forwards and when walked backwards.
    owners: Vec<[Option<usize>; 2]>,
    /// For each line, the boundary condition of the same two sides.
    conditions: Vec<[Option<Condition>; 2]>,
    /// For each pair of points joined by a line, lower index first, the line. Sorted.
    joined: Vec<([usize; 2], usize)>,
    /// For each line, the member that it is a piece of.
    pieces: Vec<Option<Piece>>,
}

/// Where the entry for a side is in a pair.
fn slot(side: LineUse) -> usize {
    usize::from(!side.forward)
}

impl<'a> Problem<'a> {
    /// Checks a statement.
    pub(crate) fn new(statement: &'a Statement) -> Result<Self, CertificateError> {
        numbers::check(statement)?;
        let owners = sides::owners(statement)?;
        let conditions = sides::conditions(statement, &owners)?;
        outline::check(statement, &owners)?;
        let far = FarFrame::new(statement)?;
        let strengths = statement.regions.iter().map(|r| Strength::new(&r.material)).collect();
        let mut joined: Vec<_> = statement
            .lines
            .iter()
            .enumerate()
            .map(|(i, l)| ([l.from.min(l.to), l.from.max(l.to)], i))
            .collect();
        joined.sort_unstable();
        let mut problem = Self { statement, strengths, far, owners, conditions, joined, pieces: Vec::new() };
        problem.pieces = problem.pieces_of_members()?;
        Ok(problem)
    }

    /// The region that has this side of a line on its boundary.
    pub(crate) fn owner(&self, side: LineUse) -> Option<usize> {
        self.owners[side.line][slot(side)]
    }

    /// The condition on this side of a line.
    pub(crate) fn condition(&self, side: LineUse) -> Option<Condition> {
        self.conditions[side.line][slot(side)]
    }

    /// Pore pressure of the soil on this side of a line, at the line's first and last point.
    pub(crate) fn pore_pressure(&self, side: LineUse) -> [Interval; 2] {
        let line = self.statement.lines[side.line];
        let pressure =
            self.owner(side).map_or_else(Linear::default, |region| self.strengths[region].pore_pressure);
        [line.from, line.to].map(|point| pressure.enclosed(Vector::point(self.statement.points[point])))
    }

    /// The line between two points.
    pub(crate) fn line_between(&self, a: usize, b: usize) -> Option<usize> {
        let key = [a.min(b), a.max(b)];
        self.joined.binary_search_by_key(&key, |j| j.0).ok().map(|i| self.joined[i].1)
    }

    /// First point of a line.
    pub(crate) fn start(&self, line: usize) -> Vector {
        Vector::point(self.statement.points[self.statement.lines[line].from])
    }

    /// First and last point of a side as it is walked.
    pub(crate) fn walked(&self, side: LineUse) -> [[f64; 2]; 2] {
        self.statement.lines[side.line].walked(side.forward).map(|p| self.statement.points[p])
    }

    /// From the first point of a line to its last.
    pub(crate) fn direction(&self, line: usize) -> Vector {
        Vector::point(self.statement.points[self.statement.lines[line].to]) - self.start(line)
    }

    /// The point at `from + s (to - from)`.
    pub(crate) fn on_line(&self, line: usize, s: f64) -> Vector {
        self.start(line) + self.direction(line) * Interval::point(s)
    }
}
