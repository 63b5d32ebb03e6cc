//! Statements for which there is no proof here.

use crate::CertificateError;
use crate::problem::Problem;
use crate::statement::Condition;

fn not_covered(line: usize, what: &'static str) -> CertificateError {
    CertificateError::NotCovered { place: format!("line {line}"), what }
}

/// Checks faces on soil without friction.
pub(super) fn check(problem: &Problem) -> Result<(), CertificateError> {
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
    }
    Ok(())
}
