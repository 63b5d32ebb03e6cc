//! The weight of the soil beyond far lines. Beside a vertical far side the layers go on level, under a level surface at the
//! height of its upper end.

use super::body_force::BodyForce;
use super::references::ReferenceStresses;
use crate::CertificateError;
use crate::interval::Interval;
use crate::problem::{Problem, Stress};
use crate::statement::{Condition, LineUse};

/// Soil of one unit weight beside a vertical far side.
#[derive(Debug, Clone, Copy)]
struct Layer {
    /// Height of its upper end.
    top: Interval,
    /// Vertical stress there, beyond the surcharge.
    above: Interval,
    /// Change of the vertical stress with depth.
    rate: Interval,
}

impl Layer {
    fn at(&self, y: Interval) -> Interval {
        self.above + self.rate * (self.top - y)
    }
}

/// Vertical stress beyond far lines, from the weight.
pub(super) struct Overburden {
    surcharge: Interval,
    /// For each line, the soil beside it if it is a vertical far one.
    layers: Vec<Option<Layer>>,
    /// The lowest layer on the left and on the right.
    lowest: [Option<Layer>; 2],
    /// Change of the reference stress with depth below the level far side, and its `yy - xx`.
    pub(super) below: (Stress, Interval),
}

fn not_covered(line: usize, what: &'static str) -> CertificateError {
    CertificateError::NotCovered { place: format!("line {line}"), what }
}

impl Overburden {
    pub(super) fn new(
        problem: &Problem,
        references: &ReferenceStresses,
        body_force: &BodyForce,
    ) -> Result<Self, CertificateError> {
        let statement = problem.statement;
        let base = references.base();
        let mut layers = vec![None; statement.lines.len()];
        let mut lowest = [None; 2];
        let mut lowest_weights: Vec<(usize, f64)> = Vec::new();
        for (hand, x) in problem.far.limits[..2].iter().enumerate() {
            let mut column = sides(problem, |ends| ends.iter().all(|p| p[0] == *x));
            // From above.
            column.sort_by(|a, b| b.1.total_cmp(&a.1));
            let (mut soil, mut last): (Option<(f64, Layer)>, _) = (None, None);
            for (line, y, region) in column {
                let material = &statement.regions[region].material;
                if material.pore_pressure.gradient[0] != 0.0 {
                    return Err(not_covered(
                        line,
                        "pore pressure that varies along x beside a vertical far line",
                    ));
                }
                if soil.is_none() && y != statement.datum && !body_force.is_vertical() {
                    return Err(not_covered(
                        line,
                        "a far side not up to the datum where gravity is not vertical",
                    ));
                }
                let weight = material.unit_weight;
                if soil.is_none_or(|(above, _)| above != weight) {
                    let (top, rate) = (Interval::point(y), body_force.down(weight));
                    let above = soil.map_or(Interval::ZERO, |(_, layer)| layer.at(top));
                    soil = Some((weight, Layer { top, above, rate }));
                }
                layers[line] = soil.map(|(_, layer)| layer);
                lowest[hand] = layers[line];
                last = Some((line, weight));
            }
            lowest_weights.extend(last);
        }
        let mut below = (base.gradient, base.difference);
        if problem.far.below {
            let y_min = problem.far.limits[2];
            let bottom = sides(problem, |ends| ends.iter().all(|p| p[1] == y_min));
            let weights =
                bottom.iter().map(|(line, _, r)| (*line, statement.regions[*r].material.unit_weight));
            let all: Vec<(usize, f64)> = weights.chain(lowest_weights).collect();
            let weight = all.first().map_or(0.0, |(_, w)| *w);
            if let Some((line, _)) = all.iter().find(|(_, w)| *w != weight) {
                return Err(not_covered(*line, "different unit weights beyond the far side below"));
            }
            if statement.regions.first().is_some_and(|r| r.material.unit_weight != weight) {
                let rate = body_force.down(weight);
                below = (Stress { xx: rate, yy: rate, xy: Interval::ZERO }, Interval::ZERO);
            }
        }
        Ok(Self { surcharge: Interval::point(statement.surcharge), layers, lowest, below })
    }

    /// Vertical stress beside a vertical far line.
    pub(super) fn beside(&self, line: usize, y: Interval) -> Interval {
        self.layers[line].map_or(Interval::point(f64::NAN), |layer| layer.at(y) - self.surcharge)
    }

    /// Vertical stress at a corner of the frame, on the left or right, beyond both far sides.
    pub(super) fn at_corner(&self, hand: usize, y: Interval) -> Interval {
        self.lowest[hand].map_or(Interval::point(f64::NAN), |layer| layer.at(y) - self.surcharge)
    }
}

/// Far sides with both ends as wanted: line, height of the upper end, region.
fn sides(problem: &Problem, wanted: impl Fn(&[[f64; 2]; 2]) -> bool) -> Vec<(usize, f64, usize)> {
    let far = problem.statement.boundaries.iter().filter(|b| b.condition == Condition::Far);
    let side = |side: LineUse| {
        let ends = problem.walked(side);
        let region = problem.owner(side)?;
        wanted(&ends).then_some((side.line, ends[0][1].max(ends[1][1]), region))
    };
    far.filter_map(|b| side(b.side())).collect()
}
