//! The statement of a problem, made ready for the solver.

use std::collections::BTreeMap;

use soilctl_certificate::{Condition, LineUse, Statement};

use crate::error::LimitError;
use crate::mesh::{self, Outline};

/// Strength of one region's soil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Soil {
    pub(crate) sin: f64,
    pub(crate) cos: f64,
    pub(crate) tan: f64,
    pub(crate) cohesion: f64,
    pub(crate) unit_weight: f64,
}

impl Soil {
    /// What lies between the apex of the yield cone and zero stress.
    pub(crate) fn tension(&self) -> f64 {
        self.cohesion / self.tan
    }
}

/// A limit-analysis problem: a [`Statement`] whose geometry has been checked and whose numbers are of the order of one.
///
/// The solver works on the numbers as they are, so lengths should be in units of the structure's size and stresses in
/// units of unit weight times that length; [`crate::EmbeddedPlate`] does that.
#[derive(Debug, Clone)]
pub struct Problem {
    statement: Statement,
    pub(crate) outline: Outline,
    pub(crate) soils: Vec<Soil>,
    conditions: BTreeMap<LineUse, Condition>,
}

impl Problem {
    /// Takes over a statement.
    ///
    /// # Errors
    ///
    /// [`LimitError::Mesh`] for geometry that is not a set of regions; [`LimitError::NotCovered`] for friction angles
    /// of zero, unit weights that differ, or are zero; [`LimitError::Range`] for numbers out of range.
    pub fn new(statement: Statement) -> Result<Self, LimitError> {
        let outline = Outline {
            points: statement.points.clone(),
            lines: statement.lines.iter().map(|l| mesh::Line { from: l.from, to: l.to }).collect(),
            regions: statement
                .regions
                .iter()
                .map(|r| mesh::RegionOutline {
                    loops: r
                        .loops
                        .iter()
                        .map(|l| {
                            l.iter().map(|u| mesh::LineUse { line: u.line, forward: u.forward }).collect()
                        })
                        .collect(),
                })
                .collect(),
        };
        outline.check()?;
        let lines = outline.lines.len() as f64;
        let named =
            statement.boundaries.iter().map(|b| ("the line of a boundary", b.line as f64, 0.0, lines));
        let down = ("gravity along y", statement.gravity[1], f64::MIN, 0.0);
        for (quantity, value, low, high) in named.chain([down]) {
            if !(value >= low && value < high) {
                return Err(LimitError::Range { quantity, value, low, high, unit: "" });
            }
        }
        let weight = statement.regions[0].material.unit_weight;
        let mut soils = Vec::new();
        for region in &statement.regions {
            let m = region.material;
            let range = |quantity, value: f64, low, high, unit| {
                if value >= low && value < high {
                    Ok(())
                } else {
                    Err(LimitError::Range { quantity, value, low, high, unit })
                }
            };
            range("the friction angle", m.phi_deg, 0.0, 90.0, "deg")?;
            range("the cohesion", m.cohesion, 0.0, f64::INFINITY, "")?;
            range("the unit weight", m.unit_weight, 0.0, f64::INFINITY, "")?;
            if m.phi_deg == 0.0 {
                return Err(LimitError::NotCovered {
                    what: "soil without friction (phi = 0)",
                    advice: "give a friction angle above zero",
                });
            }
            if m.unit_weight != weight {
                return Err(LimitError::NotCovered {
                    what: "soils of different unit weight",
                    advice: "give all regions the same unit weight",
                });
            }
            let (sin, cos) = m.phi_deg.to_radians().sin_cos();
            soils.push(Soil { sin, cos, tan: sin / cos, cohesion: m.cohesion, unit_weight: m.unit_weight });
        }
        let conditions = statement.boundaries.iter().map(|b| (b.side(), b.condition)).collect();
        Ok(Self { statement, outline, soils, conditions })
    }

    /// The statement.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    pub(crate) fn condition(&self, side: mesh::LineUse) -> Option<Condition> {
        self.conditions.get(&LineUse { line: side.line, forward: side.forward }).copied()
    }

    /// First and last point of a line.
    pub(crate) fn ends(&self, line: usize) -> [[f64; 2]; 2] {
        let l = self.outline.lines[line];
        [self.outline.points[l.from], self.outline.points[l.to]]
    }

    /// Reference stress `[xx, yy, xy]` at a point: in equilibrium with the weight, tension positive.
    pub(crate) fn reference(&self, p: [f64; 2]) -> [f64; 3] {
        let s = &self.statement;
        let depth = s.datum - p[1];
        let weight = self.soils[0].unit_weight;
        let t = s.gravity[0] / s.gravity[1];
        let vertical = weight * s.gravity[1] * depth;
        [(1.0 + 2.0 * t * t) * vertical - s.surcharge, vertical - s.surcharge, weight * s.gravity[0] * depth]
    }

    /// A typical stress at a point, seen over a length `h`: what rows and columns of the programs are scaled by.
    pub(crate) fn stress_scale(&self, p: [f64; 2], h: f64) -> f64 {
        let soil = &self.soils[0];
        soil.unit_weight * ((self.statement.datum - p[1]).max(0.0) + 0.3 * h)
            + self.statement.surcharge
            + soil.cohesion
    }
}
