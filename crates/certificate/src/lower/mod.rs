//! The lower bound: the force that goes with stresses in equilibrium that the soil can bear everywhere.

mod chains;
mod element;
mod faces;
mod far;
mod force;
mod given;
mod glue;
mod jets;
mod local;
mod strength;
#[cfg(test)]
mod tests;

use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::problem::{Problem, Reference};
use crate::statement::{Condition, Statement};
use crate::tiling::{Beyond, Side, Tiling, after};

use chains::Chains;
use given::GivenLines;
use jets::LocalJet;

/// Proves a lower bound on the force that the soil can resist, times the structure's velocity.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a problem or not covered, if the field is not built as it must be, or
/// if the soil or a face is not proven to bear the stresses.
pub fn prove_lower(statement: &Statement, field: &LowerField) -> Result<f64, CertificateError> {
    let problem = Problem::new(statement)?;
    let reference = reference(statement)?;
    let tiling = Tiling::new(&problem, &field.mesh)?;
    let function = StressFunction::new(&problem, &tiling, field, reference)?;
    function.check_recession()?;
    for triangle in 0..field.mesh.triangles.len() {
        let stresses = function.stresses(triangle);
        function.check_strength(triangle, &stresses)?;
        for (corner, part) in stresses.iter().enumerate() {
            let side = Side { triangle, corner };
            match tiling.beyond(side) {
                Beyond::Boundary(_, Condition::Face { delta_deg, adhesion }) => {
                    function.check_face(side, part, delta_deg, adhesion)?;
                }
                Beyond::Boundary(_, Condition::Far) => function.check_far(side, part)?,
                _ => {}
            }
        }
    }
    let power = function.power().lo();
    if power > f64::NEG_INFINITY {
        Ok(power)
    } else {
        Err(CertificateError::NotProven {
            quantity: "difference of the bound and the least number",
            place: "the whole field".into(),
            low: power,
            unit: "force*velocity",
        })
    }
}

/// The reference stress, if there is one for all soil.
fn reference(statement: &Statement) -> Result<Reference, CertificateError> {
    let weight = statement.regions.first().map_or(0.0, |r| r.material.unit_weight);
    if let Some(region) = statement.regions.iter().position(|r| r.material.unit_weight != weight) {
        let what = "a lower bound for soils of different unit weight";
        return Err(CertificateError::NotCovered { place: format!("region {region}"), what });
    }
    for boundary in statement.boundaries.iter().filter(|b| b.condition == Condition::Free) {
        let line = statement.lines[boundary.line];
        if [line.from, line.to].iter().any(|p| statement.points[*p][1] != statement.datum) {
            let what = "a lower bound with a free side that is not level at the datum";
            return Err(CertificateError::NotCovered { place: format!("line {}", boundary.line), what });
        }
    }
    Ok(Reference::new(statement, weight))
}

/// A stress function on a checked mesh.
struct StressFunction<'a> {
    problem: &'a Problem<'a>,
    tiling: &'a Tiling<'a>,
    field: &'a LowerField,
    reference: Reference,
    chains: Chains<'a>,
    given: GivenLines,
    /// Values and slopes of the vertex copies.
    jets: Vec<LocalJet>,
    /// Whether the stress must vanish where the soil has no strength: at the copies that belong to chains.
    apexes: bool,
}

impl<'a> StressFunction<'a> {
    fn new(
        problem: &'a Problem<'a>,
        tiling: &'a Tiling<'a>,
        field: &'a LowerField,
        reference: Reference,
    ) -> Result<Self, CertificateError> {
        let statement = problem.statement;
        let apexes =
            statement.surcharge == 0.0 && statement.regions.iter().all(|r| r.material.cohesion == 0.0);
        jets::check_numbers(problem, field)?;
        let chains = Chains::new(problem, field)?;
        glue::check(problem, tiling, field, apexes)?;
        let given = GivenLines::new(problem, tiling, field, &reference)?;
        let jets = jets::local_jets(problem, tiling, field, &chains, &given)?;
        given.check(problem, field, &chains)?;
        Ok(Self { problem, tiling, field, reference, chains, given, jets, apexes })
    }

    /// Whether the stress vanishes at a vertex copy, to the first order of its distance.
    fn is_apex(&self, copy: usize) -> bool {
        is_apex(self.field, self.apexes, copy)
    }

    /// Vertex copies at the start and end of an edge.
    fn ends(&self, side: Side) -> [usize; 2] {
        ends(self.field, side)
    }
}

fn is_apex(field: &LowerField, apexes: bool, copy: usize) -> bool {
    apexes && matches!(field.copies[copy].jet, Jet::Chain { .. })
}

fn ends(field: &LowerField, side: Side) -> [usize; 2] {
    [1, 2].map(|i| field.corners[side.triangle][after(side.corner, i)])
}
