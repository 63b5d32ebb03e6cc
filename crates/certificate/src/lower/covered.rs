//! Statements for which there is no proof here.

use super::loads::{Loads, is_bare};
use crate::CertificateError;
use crate::problem::Problem;
use crate::statement::Condition;

fn not_covered(line: usize, what: &'static str) -> CertificateError {
    CertificateError::NotCovered { place: format!("line {line}"), what }
}

/// Checks faces on soil without friction, and free sides of soil without cohesion.
pub(super) fn check(problem: &Problem, loads: &Loads) -> Result<(), CertificateError> {
    let statement = problem.statement;
    for boundary in &statement.boundaries {
        let side = boundary.side();
        if let Condition::Face { delta_deg, adhesion } = boundary.condition {
            let region = problem.owner(side).and_then(|r| statement.regions.get(r));
            let frictionless = region.is_none_or(|r| r.material.phi_deg == 0.0);
            if delta_deg == 0.0 && adhesion > 0.0 && !frictionless {
                return Err(not_covered(side.line, "adhesion without friction on soil with friction"));
            }
            if delta_deg > 0.0 && frictionless {
                return Err(not_covered(side.line, "interface friction on soil without friction"));
            }
        }
        if is_bare(problem, boundary) {
            if problem.walked(side).iter().any(|p| p[1] != statement.datum) {
                return Err(not_covered(side.line, "a free side off the datum in soil without cohesion"));
            }
            // The reference may press there if the side is the lower one of heavier soil.
            if !loads.is_at_rest_up_to(side) {
                let what = "loads before or next to a free side of soil without cohesion";
                return Err(not_covered(side.line, what));
            }
        }
    }
    Ok(())
}
