//! Which region is on which side of each line, and under which condition.

use super::slot;
use crate::CertificateError;
use crate::statement::{Condition, LineUse, Statement};

fn bad(side: LineUse, problem: &'static str) -> CertificateError {
    let sense = if side.forward { "forwards" } else { "backwards" };
    CertificateError::BadStatement { place: format!("line {} walked {sense}", side.line), problem }
}

/// For each line, the region on its left when walked forwards and when walked backwards. Checks that loops close.
pub(super) fn owners(statement: &Statement) -> Result<Vec<[Option<usize>; 2]>, CertificateError> {
    let mut owners = vec![[None; 2]; statement.lines.len()];
    let ends = |side: LineUse| statement.lines[side.line].walked(side.forward);
    for (region, r) in statement.regions.iter().enumerate() {
        // Besides, a line has two sides: so there are not many regions, and who compares them in pairs is done soon.
        if r.loops.is_empty() {
            let problem = "has no loop, so it is nowhere";
            return Err(CertificateError::BadStatement { place: format!("region {region}"), problem });
        }
        for (index, uses) in r.loops.iter().enumerate() {
            let next = uses.iter().cycle().skip(1);
            if uses.is_empty() || uses.iter().zip(next).any(|(a, b)| ends(*a)[1] != ends(*b)[0]) {
                let place = format!("loop {index} of region {region}");
                let problem =
                    "each line must end where the next one starts, the last one where the first starts";
                return Err(CertificateError::BadStatement { place, problem });
            }
            for side in uses {
                if owners[side.line][slot(*side)].replace(region).is_some() {
                    return Err(bad(*side, "used twice by loops; a line has one region on each side"));
                }
            }
        }
    }
    Ok(owners)
}

/// For each line, the boundary conditions of its two sides. Checks that every side of a region is either a boundary or
/// an interface.
pub(super) fn conditions(
    statement: &Statement,
    owners: &[[Option<usize>; 2]],
) -> Result<Vec<[Option<Condition>; 2]>, CertificateError> {
    let mut conditions = vec![[None; 2]; statement.lines.len()];
    for boundary in &statement.boundaries {
        let side = boundary.side();
        if owners[side.line][slot(side)].is_none() {
            return Err(bad(side, "a boundary condition where no region is"));
        }
        if conditions[side.line][slot(side)].replace(boundary.condition).is_some() {
            return Err(bad(side, "two boundary conditions on one side"));
        }
    }
    for (line, (owner, condition)) in owners.iter().zip(&conditions).enumerate() {
        for forward in [true, false] {
            let here = LineUse { line, forward };
            let open = |s: LineUse| owner[slot(s)].is_some() && condition[slot(s)].is_none();
            if open(here) && !open(here.reversed()) {
                return Err(bad(here, "needs a boundary condition, or soil without one on the other side"));
            }
        }
    }
    Ok(conditions)
}
