//! The reference stress of each region, in equilibrium with its weight.
//!
//! Soils of one unit weight all have the base. Where unit weights differ, which is for vertical gravity only, a region may
//! have a *column part* besides: a vertical normal stress, linear, that balances the difference of its weight and starts
//! from that of the soil above, so that tractions are the same on both sides of all interfaces. On vertical ones it has
//! none.

use super::body_force::BodyForce;
use crate::CertificateError;
use crate::interval::{Interval, Vector};
use crate::problem::{Column, Problem, ReferenceStress};

/// What a column part follows from. Parts with equal layers are equal, even if their intervals do not show it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Layer {
    unit_weight: f64,
    /// Two points of the line that it starts from.
    top: [[f64; 2]; 2],
}

/// A column part; none, with no layers, if it is zero.
#[derive(Debug, Clone, Default)]
struct Part {
    layers: Vec<Layer>,
    column: Option<Column>,
}

/// Where a region may start from.
struct Top {
    /// First and last point.
    ends: [[f64; 2]; 2],
    /// The region above; none at a boundary.
    above: Option<usize>,
}

impl Top {
    fn is_level(&self) -> bool {
        self.ends[0][1] == self.ends[1][1]
    }
}

/// The reference stresses of all regions.
pub(super) struct ReferenceStresses {
    base: ReferenceStress,
    of: Vec<ReferenceStress>,
    parts: Vec<Part>,
}

impl ReferenceStresses {
    pub(super) fn new(problem: &Problem, body_force: &BodyForce) -> Result<Self, CertificateError> {
        let regions = &problem.statement.regions;
        let weight = regions.first().map_or(0.0, |r| r.material.unit_weight);
        let dead = ReferenceStress::new(problem.statement, weight);
        let base = body_force.live(weight).map_or(dead, |force| dead.with_force(force));
        let mut parts = vec![Part::default(); regions.len()];
        if let Some(other) = regions.iter().position(|r| r.material.unit_weight != weight) {
            if !body_force.is_vertical() {
                let what = "soils of different unit weight where gravity is not vertical";
                return Err(CertificateError::NotCovered { place: format!("region {other}"), what });
            }
            parts = columns(problem, body_force, weight)?;
        }
        let of = parts.iter().map(|part| base.with_column(part.column)).collect();
        Ok(Self { base, of, parts })
    }

    /// The part that all regions have in common.
    pub(super) fn base(&self) -> &ReferenceStress {
        &self.base
    }

    /// The whole of a region.
    pub(super) fn of(&self, region: usize) -> &ReferenceStress {
        &self.of[region]
    }

    /// Whether the references of two regions are one function.
    pub(super) fn same(&self, a: usize, b: usize) -> bool {
        self.parts[a].layers == self.parts[b].layers
    }

    /// Whether the reference of a region is the base all along a line with these ends, or at a point if they are one: it has no
    /// column part, or one that starts there.
    pub(super) fn is_base_at(&self, region: usize, ends: [[f64; 2]; 2]) -> bool {
        match self.parts[region].layers.as_slice() {
            [] => true,
            [Layer { top: [from, to], .. }] if from == to => ends.iter().all(|p| p[1] == from[1]),
            [Layer { top: [from, to], .. }] => {
                let is_top = ends == [*from, *to] || ends == [*to, *from];
                is_top || ends == [*from; 2] || ends == [*to; 2]
            }
            _ => false,
        }
    }
}

/// The column parts of all regions, from the top downwards.
fn columns(
    problem: &Problem,
    body_force: &BodyForce,
    base_weight: f64,
) -> Result<Vec<Part>, CertificateError> {
    let count = problem.statement.regions.len();
    let tops: Vec<Vec<Top>> = (0..count).map(|region| tops(problem, region)).collect();
    let mut parts: Vec<Option<Part>> = vec![None; count];
    // Each round finds at least one part, if there is one to find.
    for _ in 0..count {
        for region in 0..count {
            if parts[region].is_none()
                && tops[region].iter().all(|top| top.above.is_none_or(|above| parts[above].is_some()))
            {
                parts[region] =
                    Some(column(problem, body_force, base_weight, region, &tops[region], &parts)?);
            }
        }
    }
    let found = |(region, part): (usize, Option<Part>)| {
        let what = "regions of different unit weight that lie above each other in a circle (one that is both above and below \
                    others can be cut in two along a level line)";
        part.ok_or_else(|| CertificateError::NotCovered { place: format!("region {region}"), what })
    };
    parts.into_iter().enumerate().map(found).collect()
}

/// The sides of a region that lie above it: interfaces, or boundaries if there is no interface.
fn tops(problem: &Problem, region: usize) -> Vec<Top> {
    let (mut interfaces, mut boundaries) = (Vec::new(), Vec::new());
    for side in problem.statement.regions[region].loops.iter().flatten() {
        let ends = problem.walked(*side);
        if ends[1][0] >= ends[0][0] {
            continue;
        }
        let above = problem.owner(side.reversed());
        match above.filter(|_| problem.condition(*side).is_none()) {
            None => boundaries.push(Top { ends, above: None }),
            // A line through one region has the same reference on both sides.
            Some(above) if above == region => {}
            above => interfaces.push(Top { ends, above }),
        }
    }
    if interfaces.is_empty() { boundaries } else { interfaces }
}

fn column(
    problem: &Problem,
    body_force: &BodyForce,
    base_weight: f64,
    region: usize,
    tops: &[Top],
    parts: &[Option<Part>],
) -> Result<Part, CertificateError> {
    let statement = problem.statement;
    let zero = Part::default();
    let above = |top: &Top| top.above.and_then(|a| parts[a].as_ref()).unwrap_or(&zero);
    let unit_weight = statement.regions[region].material.unit_weight;
    if unit_weight == base_weight && tops.iter().all(|top| above(top).layers.is_empty()) {
        return Ok(zero);
    }
    // The layers that follow from one top: those above it go on, if they are as heavy, or a new one starts there.
    let layers = |top: &Top| {
        let mut layers = above(top).layers.clone();
        if layers.last().map_or(base_weight, |last| last.unit_weight) != unit_weight {
            let ends = if top.is_level() { [[0.0, top.ends[0][1]]; 2] } else { top.ends };
            layers.push(Layer { unit_weight, top: ends });
        }
        layers
    };
    let first =
        tops.first().filter(|first| tops.len() == 1 || tops.iter().all(|top| layers(top) == layers(first)));
    if let Some(first) = first
        && layers(first) == above(first).layers
    {
        return Ok(above(first).clone());
    }
    let (ends, above) = match first {
        Some(first) => (first.ends, above(first)),
        // Nothing adjoins that it would have to fit.
        None if tops.iter().all(|top| top.above.is_none()) => {
            ([[0.0, statement.datum], [1.0, statement.datum]], &zero)
        }
        None => {
            let what = "a region of other unit weight must have one straight top; cut it by vertical lines";
            return Err(CertificateError::NotCovered { place: format!("region {region}"), what });
        }
    };
    let [anchor, end] = ends.map(Vector::point);
    let along = end - anchor;
    let (value, slope) = above.column.map_or((Interval::ZERO, Vector::ZERO), |c| (c.at(anchor), c.gradient));
    let difference = Interval::point(unit_weight) - Interval::point(base_weight);
    let y = -(difference * body_force.along_y());
    // On the line it is the one above.
    let x = slope.x + (slope.y - y) * along.y / along.x;
    let level = along.y.is_zero();
    let top = if level { [[0.0, ends[0][1]]; 2] } else { ends };
    let mut layers = above.layers.clone();
    layers.push(Layer { unit_weight, top });
    Ok(Part { layers, column: Some(Column { anchor, value, gradient: Vector { x, y } }) })
}
